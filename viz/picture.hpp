// SPDX-License-Identifier: MIT
// A window of panels that show one scene, with a title above and notes below: written as a PNG without being shown, or shown with a slider. Make a
// Display (display.hpp) before the first one.
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkLookupTable.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <glm/glm.hpp>

#include "viz/colours.hpp"
#include "viz/scene_mesh.hpp"

namespace gno::viz {

enum class View { camera, overview };  ///< the frame's own camera; one that sees the whole box

struct PictureSize {
    int width = 1600, height = 1000;
    int columns = 1, rows = 1;  ///< of panels
};

/// What a slider changes.
struct Slider {
    std::string title;
    int least = 0, most = 1, start = 1;
    std::function<void(int)> moved;
};

class Picture {
public:
    Picture(const PictureSize& size, const std::string& title, bool onScreen = false);

    [[nodiscard]] vtkRenderer& panel(int index) { return *panels_.at(size_t(index)); }
    void panelTitle(int index, const std::string& text);
    /// A line at the bottom; each call adds one.
    void note(const std::string& text);
    /// "subtree minimum distance [m]" beside a panel.
    void legend(int index, vtkLookupTable& colours, const std::string& title);
    void legend(int index, const std::vector<Kind>& kinds);
    /// One camera for these panels (none: all). An overview sees all of `focus`, a box on the grid.
    void lookAt(const Dump& dump, View view, const Box& focus, const std::vector<int>& panels = {});

    void writePng(const std::filesystem::path& path);
    /// Shows it until the user closes it, or for `closeAfter` seconds (0: no end). onScreen only.
    void show(const Slider& slider, double closeAfter);

private:
    void render();
    void placeOverview(vtkCamera& camera, const Dump& dump, const Box& focus, vtkRenderer& panel) const;
    vtkSmartPointer<vtkRenderWindow> window_;
    vtkSmartPointer<vtkRenderer> frame_;
    std::vector<vtkSmartPointer<vtkRenderer>> panels_;
    std::map<const vtkRenderer*, double> legendWidths_;  ///< of colour bars, as a share of the panel
    int notes_ = 0;
};

struct MeshLook {
    glm::dvec3 colour = kPale;
    double opacity = 1;
    double edges = 0;       ///< line width of the cells' outlines; 0: none
    bool outlines = false;  ///< of the cells, instead of the cells
    bool lit = true;
    double lineWidth = 1, pointSize = 4;
};

/// Coloured by an array of this name (of points where they have one, else of cells) through a table; without a table it holds bytes: red, green,
/// blue, opacity. `byArray` empty: the look's colour.
vtkSmartPointer<vtkActor> addMesh(vtkRenderer& panel, vtkPolyData& mesh, const MeshLook& look, const std::string& byArray = {},
                                  vtkLookupTable* colours = nullptr);

/// The scene faint behind what matters, and its light as a yellow ball. `without` (ascending): casters that are drawn otherwise.
void addScene(vtkRenderer& panel, const Dump& dump, std::span<const Corners> corners, double opacity, std::span<const uint32_t> without = {});
void addBall(vtkRenderer& panel, glm::dvec3 at, double radius, glm::dvec3 colour);

/// "20,000"
std::string grouped(uint64_t number);

}  // namespace gno::viz
