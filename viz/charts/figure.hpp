// SPDX-License-Identifier: MIT
// A figure as data: panels with axes and series, a title above, a legend at the right. `drawPng` makes the picture.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace gno::viz {

using Color = std::array<uint8_t, 3>;  ///< sRGB

enum class Marker { none, circle, square, diamond, cross, plus };
enum class Line { none, solid, dashed, dotted, dashDotted };

/// Something to draw with, in a plot and in its legend. `hollow`: the marker's rim only.
struct Look {
    Color color{};
    Marker marker = Marker::none;
    Line line = Line::none;
    float width = 2;  ///< of the line, pixels
    bool hollow = false;
};

/// A value with its spread: whiskers from low to high. Where an end is missing, there is no whisker.
struct Value {
    double at = 0;
    std::optional<double> low, high;
    Value() = default;
    Value(double value) : at(value) {}  // NOLINT: a number is a value without a spread
    Value(double value, double lowest, double highest) : at(value), low(lowest), high(highest) {}
};

struct Point {
    Value x, y;
    std::string label;  ///< written beside the point where there is room; empty: none
    float lift = 0;     ///< drawn so many pixels of the page higher, to keep equal values apart
};

struct Series {
    Look look;
    std::vector<Point> points;
    std::string legend;  ///< empty: not in the legend
    bool steps = false;  ///< the line goes level to the next x, then down or up to it: a front, a cumulative distribution
    bool bars = false;   ///< bars from `barBase` to y, of `barWidth` in units of x
    double barBase = 0, barWidth = 0.8;
    bool band = false;  ///< the spread of y as a band behind the line instead of whiskers
};

/// `log`: decades; values of 0 are drawn in a row of their own at the low end when `zeroRow` names it, and left out otherwise.
struct Axis {
    std::string title;
    bool log = false;
    std::string zeroRow;                                ///< for example "0 = exact"; log only
    std::optional<double> low, high;                    ///< missing: from the data
    std::vector<std::pair<double, std::string>> names;  ///< of values, instead of numbers (bars)
    double zeroShare = 0.16;                            ///< height of the row for zero, as a share of the decades
};

struct Panel {
    std::string title;
    Axis x, y;
    std::vector<Series> series;
};

struct Figure {
    std::string title, subtitle;
    std::vector<Panel> panels;
    uint32_t columns = 1;                              ///< panels are laid out in rows of so many
    uint32_t width = 1000, height = 640;               ///< in pixels of the page; the picture has twice as many each way
    std::vector<std::pair<std::string, Look>> legend;  ///< entries of its own above those of the series; an entry without look is a heading
};

/// PNG bytes. The same legend text is shown once. A display must be there (viz/display.hpp). Throws std::runtime_error when VTK draws nothing.
std::string drawPng(const Figure& figure);

}  // namespace gno::viz
