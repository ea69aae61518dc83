// SPDX-License-Identifier: MIT
// From values to places along an axis, and the ticks there.
#pragma once
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "viz/charts/figure.hpp"

namespace gno::viz {

/// Made from an axis and all values that will be drawn along it. Places are the values themselves, or their decimal logarithms.
class Scale {
public:
    Scale(const Axis& axis, std::span<const double> values);

    /// Where to draw; nothing: it cannot be drawn (not finite, or not above zero on a logarithmic axis without a row for zero).
    [[nodiscard]] std::optional<double> place(double value) const;
    [[nodiscard]] double low() const { return low_; }                                                  ///< place of the low end
    [[nodiscard]] double high() const { return high_; }                                                ///< place of the high end
    [[nodiscard]] const std::vector<std::pair<double, std::string>>& ticks() const { return ticks_; }  ///< place and text, ascending
    /// Places of the line between the row for zero and the decades; nothing when there is no such row.
    [[nodiscard]] std::optional<double> zeroLine() const;

private:
    void makeLog(const Axis& axis, double least, double greatest, bool hasZero);
    void makeLinear(const Axis& axis, double least, double greatest);
    bool log_, zero_ = false;
    double low_ = 0, high_ = 1, zeroPlace_ = 0;
    std::vector<std::pair<double, std::string>> ticks_;
};

/// 0.001, 20, 1,500, 2e+07: short and exact enough for a tick.
std::string tickText(double value);

}  // namespace gno::viz
