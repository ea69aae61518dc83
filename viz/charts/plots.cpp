// SPDX-License-Identifier: MIT
#include "viz/charts/plots.hpp"

#include <vtkBrush.h>
#include <vtkPen.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>

#include "viz/charts/palette.hpp"

namespace gno::viz {
namespace {

constexpr float kMarkerSize = 9 * kPixel;

std::optional<float> along(const Scale& scale, double value, float from, float length) {
    const auto place = scale.place(value);
    if (!place) return {};
    return from + length * float((*place - scale.low()) / (scale.high() - scale.low()));
}

void setPen(vtkContext2D& painter, Color color, float width, int type = vtkPen::SOLID_LINE, uint8_t opacity = 255) {
    vtkPen* pen = painter.GetPen();
    pen->SetColor(color[0], color[1], color[2]);
    pen->SetOpacity(opacity);
    pen->SetWidth(width);
    pen->SetLineType(type);
}

void setBrush(vtkContext2D& painter, Color color, uint8_t opacity) {
    painter.GetBrush()->SetColor(color[0], color[1], color[2]);
    painter.GetBrush()->SetOpacity(opacity);
}

bool overlap(const vtkRectf& a, const vtkRectf& b) {
    return a.GetLeft() < b.GetRight() && b.GetLeft() < a.GetRight() && a.GetBottom() < b.GetTop() && b.GetBottom() < a.GetTop();
}

/// The part of a whisker that can be drawn: an end that is off the scale goes to the edge.
void drawWhisker(vtkContext2D& painter, const Canvas& canvas, const Value& value, float other, bool isVertical, Color color) {
    if (!value.low || !value.high) return;
    const auto low = isVertical ? canvas.atY(*value.low) : canvas.atX(*value.low),
               high = isVertical ? canvas.atY(*value.high) : canvas.atX(*value.high);
    if (!high) return;
    const float from = low.value_or(isVertical ? canvas.area.GetBottom() : canvas.area.GetLeft()), cap = 3 * kPixel;
    setPen(painter, color, kPixel, vtkPen::SOLID_LINE, 190);
    if (isVertical) {
        painter.DrawLine(other, from, other, *high);
        for (const float end : {from, *high}) painter.DrawLine(other - cap, end, other + cap, end);
    } else {
        painter.DrawLine(from, other, *high, other);
        for (const float end : {from, *high}) painter.DrawLine(end, other - cap, end, other + cap);
    }
}

void drawBand(vtkContext2D& painter, const Canvas& canvas, const Series& series) {
    std::vector<float> upper, lower;
    for (const Point& point : series.points) {
        const auto x = canvas.atX(point.x.at), low = canvas.atY(point.y.low.value_or(point.y.at)),
                   high = canvas.atY(point.y.high.value_or(point.y.at));
        if (!x || !low || !high) continue;
        upper.insert(upper.end(), {*x, *high});
        lower.insert(lower.end(), {*x, *low});
    }
    setPen(painter, series.look.color, 0, vtkPen::NO_PEN, 0);
    setBrush(painter, series.look.color, 45);
    for (size_t i = 0; i + 3 < upper.size(); i += 2) {
        float quad[] = {lower[i], lower[i + 1], lower[i + 2], lower[i + 3], upper[i + 2], upper[i + 3], upper[i], upper[i + 1]};
        painter.DrawQuad(quad);
    }
}

}  // namespace

std::optional<float> Canvas::atX(double value) const { return along(x, value, area.GetLeft(), area.GetWidth()); }
std::optional<float> Canvas::atY(double value) const { return along(y, value, area.GetBottom(), area.GetHeight()); }
std::optional<std::array<float, 2>> Canvas::at(const Point& point) const {
    const auto across = atX(point.x.at), up = atY(point.y.at);
    if (!across || !up) return {};
    return std::array{*across, *up + point.lift * kPixel};
}

void setText(vtkContext2D& painter, float size, Color color, bool bold) {
    vtkTextProperty* text = painter.GetTextProp();
    text->SetFontFamilyToArial();
    text->SetFontSize(int(size * kPixel));
    text->SetBold(bold);
    text->SetColor(color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
    text->SetOpacity(1);
    text->SetOrientation(0);
    text->SetJustificationToLeft();
    text->SetVerticalJustificationToBottom();
}

void drawMarker(vtkContext2D& painter, const Look& look, float x, float y) {
    const float r = kMarkerSize / 2;
    const Color fill = look.hollow ? Color{255, 255, 255} : look.color;
    setPen(painter, look.hollow ? look.color : Color{255, 255, 255}, look.hollow ? 2 * kPixel : 0.5f * kPixel);
    setBrush(painter, fill, 255);
    switch (look.marker) {
        case Marker::none:
            return;
        case Marker::circle:
            painter.DrawEllipse(x, y, r, r);
            if (look.hollow) painter.DrawArc(x, y, r, 0, 360);
            return;
        case Marker::square:
            painter.DrawRect(x - 0.88f * r, y - 0.88f * r, 1.76f * r, 1.76f * r);
            return;
        case Marker::diamond:
            painter.DrawQuad(x - 1.2f * r, y, x, y - 1.2f * r, x + 1.2f * r, y, x, y + 1.2f * r);
            return;
        case Marker::cross:
        case Marker::plus: {
            const float d = look.marker == Marker::cross ? 0.75f * r : 0, s = look.marker == Marker::cross ? 0.75f * r : r;
            setPen(painter, look.color, 2.6f * kPixel);
            painter.DrawLine(x - s, y - d, x + s, y + d);
            painter.DrawLine(x - d, y + s, x + d, y - s);
            return;
        }
    }
}

void drawStroke(vtkContext2D& painter, const Look& look, std::vector<float> xy) {
    if (look.line == Line::none || xy.size() < 4) return;
    // Dashes of our own: the ones of the device follow the picture's pixels and start anew at every vertex.
    const std::vector<float> pattern = look.line == Line::dashed       ? std::vector<float>{7, 4}
                                       : look.line == Line::dotted     ? std::vector<float>{1.5f, 3.5f}
                                       : look.line == Line::dashDotted ? std::vector<float>{7, 3, 1.5f, 3}
                                                                       : std::vector<float>{};
    setPen(painter, look.color, look.width * kPixel);
    if (pattern.empty()) {
        painter.DrawPoly(xy.data(), int(xy.size() / 2));
        return;
    }
    size_t part = 0;
    float left = pattern[0] * kPixel;
    for (size_t i = 0; i + 3 < xy.size(); i += 2) {
        float x = xy[i], y = xy[i + 1];
        float rest = std::hypot(xy[i + 2] - x, xy[i + 3] - y);
        while (rest > 0) {
            const float step = std::min(rest, left), share = step / rest;
            const float nextX = x + share * (xy[i + 2] - x), nextY = y + share * (xy[i + 3] - y);
            if (part % 2 == 0) painter.DrawLine(x, y, nextX, nextY);
            x = nextX, y = nextY, rest -= step, left -= step;
            if (left <= 0) left = pattern[++part % pattern.size()] * kPixel;
        }
    }
}

void drawSeries(vtkContext2D& painter, const Canvas& canvas, const Series& series) {
    if (series.band) drawBand(painter, canvas, series);
    std::vector<float> line;
    for (const Point& point : series.points) {
        const auto place = canvas.at(point);
        if (!place) continue;
        const auto [x, y] = *place;
        if (series.steps && !line.empty()) line.insert(line.end(), {x, line.back()});
        line.insert(line.end(), {x, y});
        if (!series.bars) continue;
        const auto left = canvas.atX(point.x.at - series.barWidth / 2), right = canvas.atX(point.x.at + series.barWidth / 2),
                   base = canvas.atY(series.barBase);
        if (!left || !right || !base) continue;
        setPen(painter, {255, 255, 255}, kPixel);
        setBrush(painter, series.look.color, 255);
        painter.DrawRect(*left, std::min(*base, y), *right - *left, std::abs(y - *base));
    }
    if (!series.bars) drawStroke(painter, series.look, line);
    for (const Point& point : series.points) {
        const auto place = canvas.at(point);
        if (!place) continue;
        const auto [x, y] = *place;
        drawWhisker(painter, canvas, point.x, y, false, series.look.color);
        if (!series.band) drawWhisker(painter, canvas, point.y, x, true, series.bars ? kInk : series.look.color);
        if (!series.bars) drawMarker(painter, series.look, x, y);
    }
}

void drawLabels(vtkContext2D& painter, const Canvas& canvas, const std::vector<Series>& series) {
    std::vector<vtkRectf> taken;
    const float r = kMarkerSize / 2;
    for (const Series& one : series)
        for (const Point& point : one.points) {
            const auto place = canvas.at(point);
            if (!place) continue;
            const auto [x, y] = *place;
            if (one.look.marker != Marker::none) taken.emplace_back(x - r, y - r, 2 * r, 2 * r);
            if (!point.x.low || !point.x.high) continue;
            const auto low = canvas.atX(*point.x.low), high = canvas.atX(*point.x.high);
            if (low && high) taken.emplace_back(*low, y - 2 * kPixel, *high - *low, 4 * kPixel);
        }
    setText(painter, 12, kInk);
    for (const Series& one : series)
        for (const Point& point : one.points) {
            const auto place = canvas.at(point);
            if (point.label.empty() || !place) continue;
            const auto [x, y] = *place;
            float bounds[4];
            painter.ComputeStringBounds(vtkStdString(point.label), bounds);
            const float w = bounds[2], h = bounds[3], gap = r + 3 * kPixel;
            const std::array<std::array<float, 2>, 8> places{{{gap, -h / 2},
                                                              {-gap - w, -h / 2},
                                                              {-w / 2, gap},
                                                              {-w / 2, -gap - h},
                                                              {gap, gap / 2},
                                                              {gap, -gap / 2 - h},
                                                              {-gap - w, gap / 2},
                                                              {-gap - w, -gap / 2 - h}}};
            for (const auto& [dx, dy] : places) {
                const vtkRectf box(x + dx, y + dy, w, h);
                const bool isInside = box.GetLeft() > canvas.area.GetLeft() && box.GetRight() < canvas.area.GetRight() &&
                                      box.GetBottom() > canvas.area.GetBottom() && box.GetTop() < canvas.area.GetTop();
                if (!isInside || std::any_of(taken.begin(), taken.end(), [&](const vtkRectf& other) { return overlap(box, other); })) continue;
                taken.push_back(box);
                setText(painter, 12, one.look.color == kFaint ? kInk : one.look.color);
                painter.DrawString(box.GetX(), box.GetY(), vtkStdString(point.label));
                break;
            }
        }
}

}  // namespace gno::viz
