// SPDX-License-Identifier: MIT
// The few statistics of the report. All functions take values as they come and leave them alone.
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace gno::report {

double median(std::span<const double> values);         ///< mean of the two in the middle; NaN of none
double geometricMean(std::span<const double> values);  ///< of positive values; NaN of none
double mean(std::span<const double> values);
double deviation(std::span<const double> values);  ///< standard deviation of the sample (n - 1); 0 of fewer than two

/// Median and range: the lowest and highest below eight values, the quartiles from eight on.
struct Spread {
    double median = 0, low = 0, high = 0;
};
Spread spreadOf(std::span<const double> values);
/// Neither is faster for certain: their ranges meet.
bool indistinguishable(const Spread& a, const Spread& b);

/// a[i] / b[i] for all i that both have: the repeats of one group take turns, so equal numbers were measured next to each other.
std::vector<double> ratios(std::span<const double> a, std::span<const double> b);

/// y = factor * x^exponent, by least squares on the logarithms. standardError: of the exponent; missing with two points, which any line meets.
struct PowerFit {
    double exponent = 0, factor = 1;
    std::optional<double> standardError;
};
/// Of all pairs that are positive; nothing: fewer than two different x.
std::optional<PowerFit> fitPower(std::span<const double> x, std::span<const double> y);

struct Cost {
    double time = 0, error = 0;
};
/// Those that none of the others beats: no other is at least as good in both and better in one. Indexes, ascending in time; of equal ones the first.
std::vector<size_t> paretoFront(std::span<const Cost> costs);

}  // namespace gno::report
