// SPDX-License-Identifier: MIT
// Painting inside one panel, in pixels of the picture: series, their whiskers, and labels that keep clear of each other.
#pragma once
#include <vector>

#include <vtkContext2D.h>
#include <vtkRect.h>

#include "viz/charts/scale.hpp"

namespace gno::viz {

inline constexpr float kPixel = 2;  ///< pixels of the picture to one of the page

/// Places of a panel's two scales to pixels.
struct Canvas {
    const Scale &x, &y;
    vtkRectf area;
    [[nodiscard]] std::optional<float> atX(double value) const;
    [[nodiscard]] std::optional<float> atY(double value) const;
    [[nodiscard]] std::optional<std::array<float, 2>> at(const Point& point) const;  ///< with its lift
};

void setText(vtkContext2D& painter, float size, Color color, bool bold = false);  ///< left, bottom; size in pixels of the page
void drawMarker(vtkContext2D& painter, const Look& look, float x, float y);
void drawStroke(vtkContext2D& painter, const Look& look, std::vector<float> xy);  ///< x, y, x, y ...
void drawSeries(vtkContext2D& painter, const Canvas& canvas, const Series& series);
/// Labels of all points, in the order of the series: each takes the first of eight places around its point that is free, or is left out.
void drawLabels(vtkContext2D& painter, const Canvas& canvas, const std::vector<Series>& series);

}  // namespace gno::viz
