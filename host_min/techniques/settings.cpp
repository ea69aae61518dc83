// SPDX-License-Identifier: MIT
#include "host_min/techniques/settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "host_min/error.hpp"

namespace gno::host {
namespace {

std::pair<std::string, std::string> split(const std::string& text) {
    const size_t at = text.find('=');
    if (at == std::string::npos || at == 0) throw InputError(fmt::format("--set {}: write KEY=VALUE", text));
    return {text.substr(0, at), text.substr(at + 1)};
}

template <class Number, class... Format>
bool isNumberBetween(const std::string& text, uint32_t minimum, uint32_t maximum, Format... format) {
    Number number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, format...);
    return error == std::errc{} && end == text.data() + text.size() && number >= minimum && number <= maximum;
}

void checkValue(const SettingInfo& info, const std::string& value) {
    const bool good = !info.choices.empty() ? std::find(info.choices.begin(), info.choices.end(), value) != info.choices.end()
                      : info.decimals       ? isNumberBetween<double>(value, info.minimum, info.maximum, std::chars_format::fixed)
                                            : isNumberBetween<uint32_t>(value, info.minimum, info.maximum);
    if (!good) throw InputError(fmt::format("--set {}={}: must be {}", info.key, value, info.range()));
}

}  // namespace

std::string SettingInfo::range() const {
    if (!choices.empty()) return fmt::format("{}", fmt::join(choices, "|"));
    return decimals ? fmt::format("{}.0..{}.0", minimum, maximum) : fmt::format("{}..{}", minimum, maximum);
}

Settings::Settings(std::span<const SettingInfo> known, std::span<const std::string> given) {
    std::map<std::string, std::string> chosen;
    for (const std::string& text : given) {
        const auto [key, value] = split(text);
        if (!chosen.emplace(key, value).second) throw InputError(fmt::format("--set {} is given twice", key));
    }
    for (const SettingInfo& info : known) {
        const auto at = chosen.find(info.key);
        const std::string value = at == chosen.end() ? info.fallback : at->second;
        checkValue(info, value);
        values_.emplace_back(info.key, value);
        kinds_[info.key] = !info.choices.empty() ? Kind::word : info.decimals ? Kind::decimals : Kind::whole;
    }
}

const std::string& Settings::word(const std::string& key) const {
    for (const auto& [name, value] : values_)
        if (name == key) return value;
    throw std::logic_error("no such setting: " + key);
}

uint32_t Settings::number(const std::string& key) const { return uint32_t(std::stoul(word(key))); }

double Settings::real(const std::string& key) const { return std::stod(word(key)); }

nlohmann::ordered_json Settings::json() const {
    nlohmann::ordered_json result = nlohmann::ordered_json::object();
    for (const auto& [name, value] : values_) {
        switch (kinds_.at(name)) {
            case Kind::word:
                result[name] = value;
                break;
            case Kind::whole:
                result[name] = std::stoul(value);
                break;
            case Kind::decimals:
                result[name] = std::stod(value);
                break;
        }
    }
    return result;
}

void checkSettings(std::span<const std::span<const SettingInfo>> known, std::span<const std::string> given) {
    std::set<std::string> keys;
    for (const auto& list : known)
        for (const SettingInfo& info : list) keys.insert(info.key);
    for (const std::string& text : given) {
        const std::string key = split(text).first;
        if (!keys.contains(key))
            throw InputError(fmt::format("--set {}: none of the chosen techniques knows it; known here: {}", key, fmt::join(keys, ", ")));
    }
}

}  // namespace gno::host
