// SPDX-License-Identifier: MIT
#include "validation/study/report/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace gno::report {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Between the two neighbours of `share` (0..1) in ascending values.
double quantile(const std::vector<double>& ascending, double share) {
    const double at = share * double(ascending.size() - 1);
    const auto below = size_t(at);
    const size_t above = std::min(below + 1, ascending.size() - 1);
    return ascending[below] + (at - double(below)) * (ascending[above] - ascending[below]);
}

std::vector<double> sorted(std::span<const double> values) {
    std::vector<double> all(values.begin(), values.end());
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace

double median(std::span<const double> values) { return values.empty() ? kNone : quantile(sorted(values), 0.5); }

double geometricMean(std::span<const double> values) {
    if (values.empty()) return kNone;
    double sum = 0;
    for (const double value : values) sum += std::log(value);
    return std::exp(sum / double(values.size()));
}

double mean(std::span<const double> values) {
    return values.empty() ? kNone : std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

double deviation(std::span<const double> values) {
    if (values.size() < 2) return 0;
    const double middle = mean(values);
    double sum = 0;
    for (const double value : values) sum += (value - middle) * (value - middle);
    return std::sqrt(sum / double(values.size() - 1));
}

Spread spreadOf(std::span<const double> values) {
    if (values.empty()) return {kNone, kNone, kNone};
    const std::vector<double> all = sorted(values);
    const double tail = all.size() < 8 ? 0 : 0.25;
    return {quantile(all, 0.5), quantile(all, tail), quantile(all, 1 - tail)};
}

bool indistinguishable(const Spread& a, const Spread& b) { return a.low <= b.high && b.low <= a.high; }

std::vector<double> ratios(std::span<const double> a, std::span<const double> b) {
    std::vector<double> quotients;
    for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) quotients.push_back(a[i] / b[i]);
    return quotients;
}

std::optional<PowerFit> fitPower(std::span<const double> x, std::span<const double> y) {
    std::vector<double> logX, logY;
    for (size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
        if (!(x[i] > 0) || !(y[i] > 0)) continue;
        logX.push_back(std::log(x[i]));
        logY.push_back(std::log(y[i]));
    }
    const double middleX = mean(logX), middleY = mean(logY);
    double xx = 0, xy = 0;
    for (size_t i = 0; i < logX.size(); ++i) {
        xx += (logX[i] - middleX) * (logX[i] - middleX);
        xy += (logX[i] - middleX) * (logY[i] - middleY);
    }
    if (!(xx > 1e-12)) return {};
    PowerFit fit;
    fit.exponent = xy / xx;
    fit.factor = std::exp(middleY - fit.exponent * middleX);
    if (logX.size() < 3) return fit;
    double rest = 0;
    for (size_t i = 0; i < logX.size(); ++i) {
        const double off = logY[i] - middleY - fit.exponent * (logX[i] - middleX);
        rest += off * off;
    }
    fit.standardError = std::sqrt(rest / double(logX.size() - 2) / xx);
    return fit;
}

std::vector<size_t> paretoFront(std::span<const Cost> costs) {
    std::vector<size_t> order(costs.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) {
        return costs[a].time != costs[b].time ? costs[a].time < costs[b].time : costs[a].error < costs[b].error;
    });
    std::vector<size_t> front;
    for (const size_t i : order)
        if (front.empty() || costs[i].error < costs[front.back()].error) front.push_back(i);
    return front;
}

}  // namespace gno::report
