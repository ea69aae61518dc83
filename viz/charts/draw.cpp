// SPDX-License-Identifier: MIT
#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkContextItem.h>
#include <vtkContextScene.h>
#include <vtkContextView.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPNGWriter.h>
#include <vtkPen.h>
#include <vtkPlot.h>
#include <vtkRenderWindow.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <memory>
#include <set>
#include <stdexcept>

#include "viz/charts/palette.hpp"
#include "viz/charts/plots.hpp"

namespace gno::viz {
namespace {

constexpr float kMargin = 16, kTitle = 19, kText = 13, kLegendLine = 20, kSwatch = 34;  // pixels of the page

struct PreparedPanel {
    const Panel& panel;
    Scale x, y;
    vtkRectf outer;  ///< with the titles of the axes
    vtkNew<vtkChartXY> chart;
    explicit PreparedPanel(const Panel& p) : panel(p), x(p.x, values(p, &Point::x)), y(p.y, values(p, &Point::y)) {}

private:
    static std::vector<double> values(const Panel& panel, Value Point::*of) {
        std::vector<double> all;
        for (const Series& series : panel.series)
            for (const Point& point : series.points) {
                all.push_back((point.*of).at);
                if ((point.*of).low && (point.*of).high) all.insert(all.end(), {*(point.*of).low, *(point.*of).high});
                if (series.bars && of == &Point::y) all.push_back(series.barBase);
                if (series.bars && of == &Point::x) all.insert(all.end(), {point.x.at - series.barWidth / 2, point.x.at + series.barWidth / 2});
            }
        return all;
    }
};

using Legend = std::vector<std::pair<std::string, Look>>;

Legend legendOf(const Figure& figure) {
    Legend legend = figure.legend;
    std::set<std::string> seen;
    for (const auto& [text, look] : legend) seen.insert(text);
    for (const Panel& panel : figure.panels)
        for (const Series& series : panel.series)
            if (!series.legend.empty() && seen.insert(series.legend).second) {
                Look look = series.look;
                if (series.bars) look.marker = Marker::square;
                legend.emplace_back(series.legend, look);
            }
    return legend;
}

float legendWidth(const Legend& legend) {
    size_t longest = 0;
    for (const auto& [text, look] : legend) longest = std::max(longest, text.size());
    return legend.empty() ? 0 : kSwatch + 14 + 0.53f * kText * float(longest);
}

void prepareAxis(vtkAxis& axis, const Scale& scale) {
    vtkNew<vtkDoubleArray> places;
    vtkNew<vtkStringArray> texts;
    for (const auto& [place, text] : scale.ticks()) {
        places->InsertNextValue(place);
        texts->InsertNextValue(text);
    }
    axis.SetBehavior(vtkAxis::FIXED);
    axis.SetRange(scale.low(), scale.high());
    axis.SetCustomTickPositions(places, texts);
    axis.SetTitle("");  // painted by Ink: VTK sets it too close to the texts of the ticks
    axis.GetGridPen()->SetColor(228, 228, 228);
    axis.GetGridPen()->SetWidth(kPixel);
    axis.GetPen()->SetWidth(kPixel);
    axis.GetPen()->SetColor(120, 120, 120);
    axis.SetTickLength(4 * kPixel);
    axis.SetLabelOffset(7 * kPixel);
    vtkTextProperty* text = axis.GetLabelProperties();
    text->SetFontFamilyToArial();
    text->SetFontSize(int(kText * kPixel));
    text->SetColor(kInk[0] / 255.0, kInk[1] / 255.0, kInk[2] / 255.0);
}

/// A chart paints its axes only around a plot: one from corner to corner that leaves no ink.
void addFrame(vtkChartXY& chart, const Scale& x, const Scale& y) {
    vtkNew<vtkTable> corners;
    for (const Scale* scale : {&x, &y}) {
        vtkNew<vtkDoubleArray> ends;
        ends->SetName(scale == &x ? "x" : "y");
        ends->InsertNextValue(scale->low());
        ends->InsertNextValue(scale->high());
        corners->AddColumn(ends);
    }
    vtkPlot* frame = chart.AddPlot(vtkChart::LINE);
    frame->SetInputData(corners, 0, 1);
    frame->GetPen()->SetOpacity(0);
    frame->GetPen()->SetLineType(vtkPen::NO_PEN);
}

}  // namespace

/// Everything that is not an axis; painted after the charts, whose axes know their pixels then. (VTK's object model wants it outside the unnamed
/// namespace.)
class Ink : public vtkContextItem {
public:
    vtkTypeMacro(Ink, vtkContextItem);
    static Ink* New();

    const Figure* figure = nullptr;
    const std::vector<std::unique_ptr<PreparedPanel>>* panels = nullptr;

    bool Paint(vtkContext2D* painter) override {
        const float top = float(figure->height) * kPixel;
        setText(*painter, kTitle, kInk, true);
        painter->DrawString(kMargin * kPixel, top - (kMargin + kTitle) * kPixel, vtkStdString(figure->title));
        setText(*painter, kText, {90, 90, 90});
        painter->DrawString(kMargin * kPixel, top - (kMargin + kTitle + kText + 10) * kPixel, vtkStdString(figure->subtitle));
        for (const auto& panel : *panels) paintPanel(*painter, *panel);
        paintLegend(*painter);
        return true;
    }

private:
    static void paintPanel(vtkContext2D& painter, const PreparedPanel& prepared) {
        vtkAxis& bottom = *prepared.chart->GetAxis(vtkAxis::BOTTOM);
        vtkAxis& left = *prepared.chart->GetAxis(vtkAxis::LEFT);
        const vtkRectf area(bottom.GetPoint1()[0], left.GetPoint1()[1], bottom.GetPoint2()[0] - bottom.GetPoint1()[0],
                            left.GetPoint2()[1] - left.GetPoint1()[1]);
        const Canvas canvas{prepared.x, prepared.y, area};
        if (const auto zero = prepared.y.zeroLine()) {
            const float y = area.GetBottom() + area.GetHeight() * float((*zero - prepared.y.low()) / (prepared.y.high() - prepared.y.low()));
            drawStroke(painter, {kFaint, Marker::none, Line::dashed, 1, false}, {area.GetLeft(), y, area.GetRight(), y});
        }
        if (!prepared.panel.title.empty()) {
            setText(painter, kText + 1, kInk, true);
            painter.DrawString(area.GetLeft(), area.GetTop() + 5 * kPixel, vtkStdString(prepared.panel.title));
        }
        setText(painter, kText, kInk);
        painter.GetTextProp()->SetJustificationToCentered();
        painter.DrawString(area.GetLeft() + area.GetWidth() / 2, prepared.outer.GetBottom() + 2 * kPixel, vtkStdString(prepared.panel.x.title));
        painter.GetTextProp()->SetOrientation(90);
        painter.GetTextProp()->SetVerticalJustificationToTop();
        painter.DrawString(prepared.outer.GetLeft(), area.GetBottom() + area.GetHeight() / 2, vtkStdString(prepared.panel.y.title));
        for (const Series& series : prepared.panel.series) drawSeries(painter, canvas, series);
        drawLabels(painter, canvas, prepared.panel.series);
    }

    void paintLegend(vtkContext2D& painter) const {
        const Legend legend = legendOf(*figure);
        const float left = (float(figure->width) - kMargin - legendWidth(legend)) * kPixel;
        float y = (float(figure->height) - kMargin - kTitle - kText - 40) * kPixel;
        for (const auto& [text, look] : legend) {
            const bool isHeading = look.marker == Marker::none && look.line == Line::none;
            if (!isHeading) {
                drawStroke(painter, look, {left, y, left + (kSwatch - 6) * kPixel, y});
                drawMarker(painter, look, left + (kSwatch - 6) / 2 * kPixel, y);
            }
            setText(painter, kText, kInk, isHeading);
            painter.GetTextProp()->SetVerticalJustificationToCentered();
            painter.DrawString(left + (isHeading ? 0 : kSwatch * kPixel), y, vtkStdString(text));
            y -= kLegendLine * kPixel;
        }
    }
};
vtkStandardNewMacro(Ink);

std::string drawPng(const Figure& figure) {
    vtkNew<vtkContextView> view;
    view->GetRenderWindow()->SetOffScreenRendering(1);
    view->GetRenderWindow()->SetMultiSamples(0);
    view->GetRenderWindow()->SetSize(int(float(figure.width) * kPixel), int(float(figure.height) * kPixel));
    const uint32_t columns = std::max(1u, figure.columns), rows = (uint32_t(figure.panels.size()) + columns - 1) / columns;
    const float head = kMargin + kTitle + kText + 18, gap = 14, titled = 20;
    const float legend = legendWidth(legendOf(figure));
    const float width = (float(figure.width) - kMargin - (legend > 0 ? legend + kMargin : 0)) / float(columns),
                height = (float(figure.height) - head - 6) / float(std::max(1u, rows));
    std::vector<std::unique_ptr<PreparedPanel>> panels;
    for (const Panel& panel : figure.panels) {
        const auto index = uint32_t(panels.size());
        panels.push_back(std::make_unique<PreparedPanel>(panel));
        PreparedPanel& prepared = *panels.back();
        vtkChartXY& chart = *prepared.chart;
        chart.SetAutoSize(false);
        addFrame(chart, prepared.x, prepared.y);
        const float x = 8 + width * float(index % columns), y = float(figure.height) - head - height * float(index / columns + 1) + 6;
        prepared.outer = vtkRectf(x * kPixel, y * kPixel, (width - gap) * kPixel, (height - titled) * kPixel);
        const float left = panel.y.title.empty() ? 0 : kText + 6, bottom = panel.x.title.empty() ? 0 : kText + 5;
        chart.SetSize(vtkRectf((x + left) * kPixel, (y + bottom) * kPixel, (width - gap - left) * kPixel, (height - titled - bottom) * kPixel));
        prepareAxis(*chart.GetAxis(vtkAxis::BOTTOM), prepared.x);
        prepareAxis(*chart.GetAxis(vtkAxis::LEFT), prepared.y);
        if (!panel.x.names.empty()) chart.GetAxis(vtkAxis::BOTTOM)->SetGridVisible(false);
        view->GetScene()->AddItem(&chart);
    }
    vtkNew<Ink> ink;
    ink->figure = &figure;
    ink->panels = &panels;
    view->GetScene()->AddItem(ink);
    view->Render();

    vtkNew<vtkWindowToImageFilter> image;
    image->SetInput(view->GetRenderWindow());
    image->ReadFrontBufferOff();
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(image->GetOutputPort());
    writer->WriteToMemoryOn();
    writer->Write();
    vtkUnsignedCharArray* bytes = writer->GetResult();
    if (bytes == nullptr || bytes->GetNumberOfValues() == 0) throw std::runtime_error("VTK drew no picture");
    return {reinterpret_cast<const char*>(bytes->GetPointer(0)), size_t(bytes->GetNumberOfValues())};
}

}  // namespace gno::viz
