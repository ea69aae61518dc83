// SPDX-License-Identifier: MIT
#include "viz/picture.hpp"

#include <fmt/format.h>
#include <vtkActor2D.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkLegendBoxActor.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkScalarBarActor.h>
#include <vtkSphereSource.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>

#include "host_min/output/png.hpp"

namespace gno::viz {
namespace {

constexpr double kTitleHeight = 0.055, kNoteHeight = 0.07;  // of the window
constexpr int kNoteLines = 3;
constexpr double kViewAngle = 34;  // of the overview, degrees

vtkSmartPointer<vtkTextActor> text(const std::string& words, int size, double x, double y) {
    const auto actor = vtkSmartPointer<vtkTextActor>::New();
    actor->SetInput(words.c_str());
    actor->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
    actor->SetPosition(x, y);
    actor->GetTextProperty()->SetFontSize(size);
    actor->GetTextProperty()->SetColor(kDark.r, kDark.g, kDark.b);
    actor->GetTextProperty()->SetVerticalJustificationToCentered();
    return actor;
}

/// How far from `at`, along `back`, all corners of the box are left of a legend that is so wide.
double distanceFor(const Dump& dump, const Box& box, glm::dvec3 back, glm::dvec3 at, double aspect, double legend) {
    const double slope = 0.94 * std::tan(glm::radians(kViewAngle / 2));
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), back)), up = glm::cross(back, right);
    double distance = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p =
            dump.world({corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y, corner & 4 ? box.high.z : box.low.z}) - at;
        const double across = std::max(std::abs(glm::dot(p, right)) / ((0.9 - legend) * aspect), std::abs(glm::dot(p, up)));
        distance = std::max(distance, across / slope + glm::dot(p, back));
    }
    return distance;
}

void plain(vtkTextProperty& property, int size) {
    property.SetColor(kDark.r, kDark.g, kDark.b);
    property.ItalicOff();
    property.ShadowOff();
    property.BoldOff();
    property.SetFontSize(size);
}

/// 1, 2, 5, 10, ... from `least` to `most`, so few that they do not touch.
vtkSmartPointer<vtkDoubleArray> roundNumbers(double least, double most) {
    const auto numbers = vtkSmartPointer<vtkDoubleArray>::New();
    const double decades = std::log10(most / least);
    for (int power = int(std::floor(std::log10(least))); power <= int(std::floor(std::log10(most))); ++power)
        for (const double digit : {1.0, 2.0, 5.0}) {
            const double number = digit * std::pow(10.0, power);
            if (number >= least && number <= most && (digit == 1 || decades < 4)) numbers->InsertNextValue(number);
        }
    return numbers;
}

}  // namespace

Picture::Picture(const PictureSize& size, const std::string& title, bool onScreen) : window_(vtkSmartPointer<vtkRenderWindow>::New()) {
    window_->SetOffScreenRendering(onScreen ? 0 : 1);
    window_->SetShowWindow(onScreen);
    window_->SetSize(size.width, size.height);
    window_->SetWindowName(title.c_str());
    window_->SetAlphaBitPlanes(1);
    window_->SetMultiSamples(0);
    frame_ = vtkSmartPointer<vtkRenderer>::New();
    frame_->SetBackground(kWhite.r, kWhite.g, kWhite.b);
    frame_->InteractiveOff();
    frame_->AddViewProp(text(title, size.height / 42, 0.012, 1 - kTitleHeight / 2));
    window_->AddRenderer(frame_);
    const double height = (1 - kTitleHeight - kNoteHeight) / size.rows;
    for (int row = 0; row < size.rows; ++row)
        for (int column = 0; column < size.columns; ++column) {
            const auto panel = vtkSmartPointer<vtkRenderer>::New();
            const double top = 1 - kTitleHeight - row * height;
            panel->SetViewport(double(column) / size.columns, top - height, double(column + 1) / size.columns, top);
            panel->SetBackground(kWhite.r, kWhite.g, kWhite.b);
            panel->SetUseDepthPeeling(1);
            panel->SetMaximumNumberOfPeels(12);
            panel->SetOcclusionRatio(0.02);
            panel->UseFXAAOn();
            window_->AddRenderer(panel);
            panels_.push_back(panel);
        }
}

void Picture::panelTitle(int index, const std::string& words) { panel(index).AddViewProp(text(words, window_->GetSize()[1] / 52, 0.02, 0.965)); }

void Picture::note(const std::string& words) {
    frame_->AddViewProp(text(words, window_->GetSize()[1] / 60, 0.012, kNoteHeight * (1 - (notes_ + 0.5) / kNoteLines)));
    ++notes_;
}

void Picture::legend(int index, vtkLookupTable& colours, const std::string& title) {
    vtkNew<vtkScalarBarActor> bar;
    bar->SetLookupTable(&colours);
    bar->SetTitle((title + "\n ").c_str());
    bar->SetUnconstrainedFontSize(true);
    const double* range = colours.GetTableRange();
    const bool isLog = colours.GetScale() == VTK_SCALE_LOG10,
               whole = isLog ? range[0] >= 1 : range[0] == std::floor(range[0]) && range[1] == std::floor(range[1]);
    const double span = range[1] - range[0];
    bar->SetNumberOfLabels(whole && span <= 12 ? int(span) + 1 : 6);
    if (isLog) {
        bar->SetUseCustomLabels(true);
        bar->SetCustomLabels(roundNumbers(range[0], range[1]));
    }
    bar->SetLabelFormat(whole ? "%.0f" : "%.3g");
    const int size = window_->GetSize()[1] / 58;
    plain(*bar->GetTitleTextProperty(), size);
    plain(*bar->GetLabelTextProperty(), size);
    bar->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
    const double* viewport = panel(index).GetViewport();
    const double share = viewport[2] - viewport[0];  // letters are of one size in all panels
    const double width = 0.1 / std::max(0.5, share);
    bar->SetPosition(1 - 1.15 * width, 0.2);
    bar->SetWidth(width);
    bar->SetHeight(0.6);
    bar->SetBarRatio(0.22);
    panel(index).AddViewProp(bar);
    legendWidths_[panels_[size_t(index)].Get()] = width;
}

void Picture::legend(int index, const std::vector<Kind>& kinds) {
    vtkNew<vtkLegendBoxActor> box;
    vtkNew<vtkSphereSource> ball;
    ball->SetThetaResolution(24);
    ball->SetPhiResolution(12);
    ball->Update();
    box->SetNumberOfEntries(int(kinds.size()));
    for (size_t i = 0; i < kinds.size(); ++i) {
        glm::dvec3 colour = kinds[i].colour;
        box->SetEntry(int(i), ball->GetOutput(), kinds[i].name.c_str(), &colour.x);
        box->SetEntrySymbol(int(i), ball->GetOutput());
    }
    box->BorderOff();
    box->UseBackgroundOff();
    box->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
    box->GetPosition2Coordinate()->SetCoordinateSystemToNormalizedViewport();
    const double* viewport = panel(index).GetViewport();
    const double width = 0.26 / (viewport[2] - viewport[0]), height = 0.034 * double(kinds.size()) / (viewport[3] - viewport[1]);
    box->GetPositionCoordinate()->SetValue(0.99 - width, 0.94 - height);
    box->GetPosition2Coordinate()->SetValue(width, height);
    plain(*box->GetEntryTextProperty(), window_->GetSize()[1] / 60);
    panel(index).AddViewProp(box);
}

void Picture::placeOverview(vtkCamera& camera, const Dump& dump, const Box& focus, vtkRenderer& panel) const {
    const glm::dvec3 at = dump.world((focus.low + focus.high) / 2.0), away = dump.camera().back;
    glm::dvec3 side(away.x, 0, away.z);
    side = glm::length(side) > 1e-3 ? glm::normalize(side) : glm::dvec3(0, 0, 1);
    const glm::dvec3 back = glm::normalize(side + glm::dvec3(0, 0.62, 0));
    const double* viewport = panel.GetViewport();
    const int* size = window_->GetSize();
    const double aspect = (viewport[2] - viewport[0]) * size[0] / ((viewport[3] - viewport[1]) * size[1]);
    const auto own = legendWidths_.find(&panel);
    const double legend = own == legendWidths_.end() ? 0.1 : own->second;
    const glm::dvec3 from = at + back * distanceFor(dump, focus, back, at, aspect, legend);
    camera.SetPosition(from.x, from.y, from.z);
    camera.SetFocalPoint(at.x, at.y, at.z);
    camera.SetViewUp(0, 1, 0);
    camera.SetViewAngle(kViewAngle);
    camera.SetWindowCenter(legend, 0);  // the legend stands at the right
}

void Picture::lookAt(const Dump& dump, View view, const Box& focus, const std::vector<int>& which) {
    std::vector<vtkRenderer*> panels;
    for (const int index : which) panels.push_back(&panel(index));
    if (which.empty()) panels.assign(panels_.begin(), panels_.end());
    vtkNew<vtkCamera> camera;
    if (view == View::overview) {
        placeOverview(*camera, dump, focus, *panels.front());
    } else {
        const DumpCamera& own = dump.camera();
        const glm::dvec3 from = dump.world(own.position), at = from - own.back * glm::length(dump.high() - dump.low()) * dump.metres();
        camera->SetPosition(from.x, from.y, from.z);
        camera->SetFocalPoint(at.x, at.y, at.z);
        camera->SetViewUp(own.up.x, own.up.y, own.up.z);
        camera->SetParallelProjection(!own.perspective);
        camera->SetViewAngle(glm::degrees(own.yfov));
        camera->SetParallelScale(own.ymag * dump.metres());
    }
    for (vtkRenderer* panel : panels) {
        panel->SetActiveCamera(camera);
        panel->ResetCameraClippingRange();
    }
}

void Picture::render() {
    for (const auto& panel : panels_) panel->ResetCameraClippingRange();
    window_->Render();
}

void Picture::writePng(const std::filesystem::path& path) {
    render();
    vtkNew<vtkWindowToImageFilter> grab;
    grab->SetInput(window_);
    grab->SetInputBufferTypeToRGB();
    grab->ReadFrontBufferOff();
    grab->ShouldRerenderOff();
    grab->Update();
    vtkImageData& image = *grab->GetOutput();
    const int* size = image.GetDimensions();
    host::Picture picture{static_cast<uint32_t>(size[0]), static_cast<uint32_t>(size[1])};
    const auto* row = static_cast<const glm::u8vec3*>(image.GetScalarPointer());
    for (uint32_t y = picture.height; y-- > 0; row += picture.width) std::copy(row, row + picture.width, &picture.at(0, y));
    host::writePng(path, picture);
}

vtkSmartPointer<vtkActor> addMesh(vtkRenderer& panel, vtkPolyData& mesh, const MeshLook& look, const std::string& byArray, vtkLookupTable* colours) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(&mesh);
    mapper->SetScalarVisibility(!byArray.empty());
    if (!byArray.empty()) {
        if (mesh.GetPointData()->HasArray(byArray.c_str()))
            mapper->SetScalarModeToUsePointFieldData();
        else
            mapper->SetScalarModeToUseCellFieldData();
        mapper->SelectColorArray(byArray.c_str());
        if (colours == nullptr) mapper->SetColorModeToDirectScalars();
        mapper->SetLookupTable(colours);
        mapper->SetUseLookupTableScalarRange(colours != nullptr);
    }
    const auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    vtkProperty& property = *actor->GetProperty();
    property.SetColor(look.colour.r, look.colour.g, look.colour.b);
    property.SetOpacity(look.opacity);
    property.SetLighting(look.lit);
    property.SetAmbient(0.35);
    property.SetDiffuse(0.65);
    property.SetInterpolationToFlat();
    property.SetLineWidth(float(look.edges > 0 ? look.edges : look.lineWidth));
    property.SetPointSize(float(look.pointSize));
    if (look.outlines) property.SetRepresentationToWireframe();
    if (look.edges > 0) {
        property.EdgeVisibilityOn();
        property.SetEdgeColor(kDark.r, kDark.g, kDark.b);
    }
    panel.AddActor(actor);
    return actor;
}

void addBall(vtkRenderer& panel, glm::dvec3 at, double radius, glm::dvec3 colour) {
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(at.x, at.y, at.z);
    ball->SetRadius(radius);
    ball->SetThetaResolution(32);
    ball->SetPhiResolution(24);
    ball->Update();
    addMesh(panel, *ball->GetOutput(), {.colour = colour});
}

void addScene(vtkRenderer& panel, const Dump& dump, std::span<const Corners> corners, double opacity, std::span<const uint32_t> without) {
    constexpr size_t kMost = 200000;
    std::vector<uint32_t> casters = largestCasters(corners, kMost);
    std::erase_if(casters, [&](uint32_t caster) { return std::binary_search(without.begin(), without.end(), caster); });
    if (!casters.empty()) addMesh(panel, *meshOf(dump, corners, casters), {.colour = kPale, .opacity = opacity});
    const double size = glm::length(dump.high() - dump.low()) * dump.metres();
    addBall(panel, lightMarkOf(dump), 0.012 * size, kYellow);
}

std::string grouped(uint64_t number) {
    std::string digits = std::to_string(number);
    for (size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, 1, ',');
    return digits;
}

}  // namespace gno::viz
