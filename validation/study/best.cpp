// SPDX-License-Identifier: MIT
#include "validation/study/best.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "host_min/error.hpp"

namespace gno::study {
namespace {

constexpr int kRungs = 9;       // of the first ladder
constexpr int kFinerRungs = 5;  // of each that follows
constexpr int kFinerLadders = 3;
constexpr double kDecades = 100;      // from this ratio of its ends on, a ladder goes in equal ratios
constexpr double kLeastShare = 1e-6;  // of the largest value: the least one tried beside 0, where fractions are allowed

bool isValue(const host::SettingInfo& info, const std::string& text) {
    try {
        const host::Settings checked(std::span(&info, 1), std::vector{info.key + "=" + text});
        return true;
    } catch (const host::InputError&) {
        return false;
    }
}

/// As the setting wants it: whole where it takes nothing else.
std::string textOf(const host::SettingInfo& info, double value) {
    const std::string exact = fmt::format("{:.6g}", value);
    return isValue(info, exact) ? exact : fmt::format("{:.0f}", value);
}

/// `least`: where equal ratios begin when `low` is 0.
std::vector<double> ladder(double low, double high, double least, int rungs) {
    std::vector<double> values;
    const double first = low > 0 ? low : std::min(least, high);
    if (low >= 0 && high / first >= kDecades) {
        if (low == 0) values.push_back(0);
        for (int i = 0; i < rungs; ++i) values.push_back(first * std::pow(high / first, double(i) / (rungs - 1)));
    } else {
        for (int i = 0; i < rungs; ++i) values.push_back(low + (high - low) * i / (rungs - 1));
    }
    return values;
}

}  // namespace

std::string bestValue(const host::SettingInfo& info, const std::function<uint64_t(const std::string&)>& wrong) {
    if (!info.choices.empty()) {
        std::string best = info.fallback;
        uint64_t least = wrong(best);
        for (const std::string& word : info.choices) {
            if (word == info.fallback) continue;
            const uint64_t count = wrong(word);
            if (count < least) {
                least = count;
                best = word;
            }
        }
        return best;
    }
    std::map<double, std::pair<uint64_t, std::string>> tried;
    const auto attempt = [&](const std::string& text) {
        const double value = std::stod(text);
        if (!tried.contains(value) && isValue(info, text)) tried[value] = {wrong(text), text};
    };
    attempt(info.fallback);
    const double bottom = double(info.minimum), top = double(info.maximum);
    const bool whole = !isValue(info, fmt::format("{:.6f}", bottom + (top - bottom) / std::numbers::pi));
    const double least = whole ? 1 : top * kLeastShare;
    for (const double value : ladder(bottom, top, least, kRungs)) attempt(textOf(info, value));
    const auto best = [&] {  // the first of the fewest
        return std::min_element(tried.begin(), tried.end(), [](const auto& a, const auto& b) { return a.second.first < b.second.first; });
    };
    for (int i = 0; i < kFinerLadders; ++i) {
        const auto at = best();
        const size_t before = tried.size();
        const double low = at == tried.begin() ? at->first : std::prev(at)->first,
                     high = std::next(at) == tried.end() ? at->first : std::next(at)->first;
        for (const double value : ladder(low, high, least, kFinerRungs)) attempt(textOf(info, value));
        if (tried.size() == before) break;
    }
    const auto& fallback = tried.at(std::stod(info.fallback));
    return fallback.first == best()->second.first ? fallback.second : best()->second.second;
}

}  // namespace gno::study
