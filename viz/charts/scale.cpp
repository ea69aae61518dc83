// SPDX-License-Identifier: MIT
#include "viz/charts/scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gno::viz {

std::string tickText(double value) {
    const double size = std::abs(value);
    if (value == 0) return "0";
    if (size >= 1e6 || size < 1e-4) {
        const double power = std::floor(std::log10(size) + 1e-9);
        return fmt::format("{:.3g}e{:g}", value / std::pow(10, power), power);
    }
    const std::string text = fmt::format("{:.10g}", value);
    if (size < 1e4) return text;
    const size_t digits = std::min(text.find('.'), text.size()), sign = value < 0;
    std::string grouped;
    for (size_t i = 0; i < text.size(); ++i) {
        if (i > sign && i < digits && (digits - i) % 3 == 0) grouped += ',';
        grouped += text[i];
    }
    return grouped;
}

Scale::Scale(const Axis& axis, std::span<const double> values) : log_(axis.log) {
    double least = std::numeric_limits<double>::infinity(), greatest = -least;
    bool hasZero = false;
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        hasZero = hasZero || value == 0;
        if (log_ && value <= 0) continue;
        least = std::min(least, value);
        greatest = std::max(greatest, value);
    }
    if (axis.low) least = *axis.low;
    if (axis.high) greatest = *axis.high;
    if (!(least <= greatest)) least = log_ ? 1 : 0, greatest = log_ ? 10 : 1;
    if (log_)
        makeLog(axis, least, greatest, hasZero);
    else
        makeLinear(axis, least, greatest);
    if (axis.names.empty()) return;
    ticks_.clear();
    for (const auto& [value, text] : axis.names)
        if (const auto at = place(value)) ticks_.emplace_back(*at, text);
}

void Scale::makeLog(const Axis& axis, double least, double greatest, bool hasZero) {
    low_ = std::log10(least);
    high_ = std::log10(greatest);
    const double margin = std::max(0.06 * (high_ - low_), 0.08);
    if (!axis.low) low_ -= margin;
    if (!axis.high) high_ += margin;
    if (high_ - low_ < 0.4) low_ -= 0.2, high_ += 0.2;
    const double span = high_ - low_;
    const int every = std::max(1, int(std::ceil(span / 7)));  // decades between two ticks
    zero_ = !axis.zeroRow.empty() && hasZero;
    if (zero_) {
        low_ = std::floor(low_ + 1e-9);
        const double row = axis.zeroShare * (high_ - low_);
        zeroPlace_ = low_ - row;
        ticks_.emplace_back(zeroPlace_, axis.zeroRow);
    }
    const std::vector<double> steps = span > 3     ? std::vector<double>{1}
                                      : span > 1.2 ? std::vector<double>{1, 2, 5}
                                                   : std::vector<double>{1, 1.5, 2, 3, 4, 5, 7};
    for (int decade = int(std::floor(low_)); decade <= int(std::ceil(high_)); ++decade) {
        if (decade % every != 0) continue;
        for (const double step : steps) {
            const double value = step * std::pow(10.0, decade), at = std::log10(value);
            if (at >= low_ - 1e-9 && at <= high_ + 1e-9) ticks_.emplace_back(at, tickText(value));
        }
    }
    if (zero_) low_ = zeroPlace_ - 0.6 * (low_ - zeroPlace_);
}

void Scale::makeLinear(const Axis& axis, double least, double greatest) {
    if (greatest == least) greatest += std::max(std::abs(greatest), 1.0) * 0.5, least -= axis.low ? 0 : std::max(std::abs(least), 1.0) * 0.5;
    const double margin = 0.05 * (greatest - least);
    low_ = axis.low ? least : least - margin;
    high_ = axis.high ? greatest : greatest + margin;
    const double rough = (high_ - low_) / 6, decade = std::pow(10.0, std::floor(std::log10(rough)));
    const double step = decade * (rough / decade < 1.5 ? 1 : rough / decade < 3.5 ? 2 : rough / decade < 7.5 ? 5 : 10);
    for (double index = std::ceil(low_ / step - 1e-9); index * step <= high_ + 1e-9 * step; ++index)
        ticks_.emplace_back(index * step, tickText(index * step));
}

std::optional<double> Scale::place(double value) const {
    if (!std::isfinite(value)) return {};
    if (!log_) return value;
    if (value > 0) return std::log10(value);
    if (value == 0 && zero_) return zeroPlace_;
    return {};
}

std::optional<double> Scale::zeroLine() const {
    if (!zero_) return {};
    return zeroPlace_ + (zeroPlace_ - low_);
}

}  // namespace gno::viz
