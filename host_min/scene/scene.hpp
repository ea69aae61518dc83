// SPDX-License-Identifier: MIT
// A glTF file as shadows see it: load once, then evaluate one frame after the other.
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "host_min/scene/grid.hpp"
#include "host_min/scene/material.hpp"

namespace gno::host {

/// A caster: three vertices on the grid, counter-clockwise seen from its front. A node with a negative determinant has its winding flipped.
struct Triangle {
    glm::vec3 a, b, c;
};

struct Light {
    enum class Kind { point, directional, spot };
    std::string name;
    Kind kind = Kind::point;
    glm::vec4 homogeneous{0, 0, 0, 1};  ///< on the grid: xyz position and w = 1, or direction towards the light (snapDirection) and w = 0
    glm::vec3 axis{0, 0, -1};           ///< spot: unit vector along which it shines
    glm::vec3 color{1};
    float intensity = 1;
    float innerCone = 0, outerCone = 0.7853981634f;  ///< spot, radians, half angles; shading only
    bool isDefault = false;                          ///< made by us, because the file has no light
    bool isFar = false;         ///< a point or spot light so far away that it is taken as directional; parallaxPixels says what that changes
    double parallaxPixels = 0;  ///< of a far light: no boundary in the picture moves by more
};

struct Camera {
    std::string name;
    bool perspective = true;
    glm::dmat4 gridFromCamera{1.0};  ///< camera looks along its -z, y up; rotation and translation only
    double yfov = 0.8;               ///< perspective: vertical field of view, radians
    double xmag = 1, ymag = 1;       ///< orthographic: half extents, grid units; xmag is replaced by ymag * aspect
    double znear = 0.01, zfar = 0;   ///< grid units; zfar = 0: infinite (perspective only)
    double fileAspect = 0;           ///< width / height that the file names, 0: none; not used, the picture's own goes before
    bool isDefault = false;

    /// Clip from grid position; Vulkan conventions: y down, depth reversed (1 at znear, 0 at zfar or infinity). `aspect` = width / height.
    [[nodiscard]] glm::dmat4 clipFromGrid(double aspect) const;
    /// Homogeneous viewer: xyz position and w = 1, or direction towards the viewer and w = 0 (orthographic), on the grid.
    [[nodiscard]] glm::dvec4 viewer() const;
};

/// What a frame is evaluated for: the camera, the picture's size (what counts as a pixel), the lights that its grid has to hold.
struct View {
    uint32_t camera = 0;
    uint32_t width = 1024, height = 1024;
    std::optional<uint32_t> light = std::nullopt;  ///< this one only; all of them without it
    std::optional<Grid> before = std::nullopt;     ///< the grid of the frame before: kept while it holds the scene and harms nothing
};

/// What putting positions on the grid does to a picture, measured on what its camera has before it (nothing is hidden by anything).
struct GridHarm {
    double movedPixels = 0;  ///< largest distance by which snapping moves a vertex, or a triangle that the picture's border cuts
    double lightArcsec = 0;  ///< largest angle by which it turns the direction to a light that was asked for; seconds of arc
    double reach = 0;        ///< how far the grid has to reach from its origin, world units
    int forLight = -1;       ///< the light that it has to reach so far for; -1: triangles
    bool changed = false;    ///< it is not the grid of View::before
};

inline constexpr double kHarmTold = 0.1, kHarmRefused = 1.0;  ///< pixels: from here on it is told, and refused
inline constexpr double kFarParallax = 0.01;                  ///< pixels: below, a far light is taken as directional,
inline constexpr double kFarTurn = 1e-5;                      ///< when no direction to it differs by more than this, radians, from that

/// What was seen while loading that a user may want to know.
struct SceneFacts {
    uint64_t trianglesInFile = 0;  ///< of all instances, before anything is left out
    uint64_t zeroArea = 0;         ///< triangles whose vertices are collinear on the grid: neither visible nor casters
    uint64_t duplicates = 0;       ///< triangles that stand in the caster list before with the same three positions (any order); kept
    uint64_t pointOrLinePrimitives = 0;
    uint64_t closedTriangles = 0;  ///< triangles of closed, consistently oriented meshes
    uint32_t objects = 0;          ///< mesh instances
    uint32_t lightsInFile = 0, camerasInFile = 0, animations = 0, skins = 0, morphTargets = 0;
    std::vector<std::string> notices;  ///< what is not used or taken for something else, one line each: "SUBJECT: what becomes of it"
};

/// One frame of a scene. All vectors with one entry per triangle have the same length and order.
struct Frame {
    Grid grid;
    GridHarm harm;
    std::vector<Triangle> triangles;          ///< on the grid, none with zero area
    std::vector<uint32_t> material;           ///< index into SceneFile::materials()
    std::vector<uint32_t> object;             ///< index of the mesh instance
    std::vector<uint32_t> surfaceOf;          ///< index into surfaces, or kOpaque; empty when all triangles are opaque
    std::vector<Surface> surfaces;            ///< of the triangles that are not
    std::shared_ptr<const MaterialSet> look;  ///< what surfaces refer to; null when all triangles are opaque
    std::vector<uint8_t> oneSided;            ///< 1: the camera sees its front only (glTF's doubleSided is false); it casts from both sides
    std::vector<uint8_t> closed;              ///< 1: the triangle belongs to a closed, consistently oriented mesh (front-face culling is legal)
    std::vector<Light> lights;                ///< at least one
    Camera camera;                            ///< the chosen one
    glm::vec3 low{0}, high{0};                ///< bounding box of the triangles, on the grid
    SceneFacts facts;
};

inline constexpr double kFramesPerSecond = 30.0;

/// An animation of the file.
struct Clip {
    std::string name;
    double lastKeyframe = 0;  ///< seconds
};

/// A loaded glTF 2.0 file (.gltf or .glb). Everything in it was checked: evaluating a frame cannot fail on its account.
class SceneFile {
public:
    /// Throws InputError: missing, truncated, not glTF, an accessor or index out of bounds, a required extension that changes geometry,
    /// no triangle at all, a position that is not finite; an image that cannot be read, or missing texture coordinates, of a material that
    /// is not opaque; `animation` (a number, a name or "all"; empty: the first one) means none of the file's.
    static SceneFile load(const std::filesystem::path& path, const std::string& animation = {});

    SceneFile(SceneFile&&) noexcept;
    SceneFile& operator=(SceneFile&&) noexcept;
    ~SceneFile();

    [[nodiscard]] const std::filesystem::path& path() const;
    [[nodiscard]] const std::vector<Material>& materials() const;  ///< the file's, glTF's default one, and the file's with vertex colours
    [[nodiscard]] uint32_t cameraCount() const;                    ///< at least 1: the default one when the file has none
    [[nodiscard]] uint32_t lightCount() const;                     ///< at least 1: defaults (0: point, 1: directional) when the file has none
    [[nodiscard]] double lastKeyframe() const;                     ///< of what is applied, seconds; 0 without animations
    [[nodiscard]] std::vector<Clip> clips() const;                 ///< all of the file
    [[nodiscard]] std::optional<uint32_t> clip() const;            ///< the applied one; none: all, or the file has none

    /// The scene at `frame` / kFramesPerSecond seconds (animations are clamped at their ends). Throws InputError when the camera or the light is out
    /// of range, or an animated position is not finite. Its grid is View::before's, or without one that of frame 0, as long as that holds all
    /// that it has to and moves nothing by kHarmTold; else one of its own.
    [[nodiscard]] Frame evaluate(uint32_t frame, const View& view) const;
    /// The same for all lights and a picture of 1024 x 1024.
    [[nodiscard]] Frame evaluate(uint32_t frame, uint32_t camera) const;

    struct Data;  ///< opaque; host_min/scene's own files know it

private:
    explicit SceneFile(std::unique_ptr<Data> data);
    std::unique_ptr<Data> data_;
};

}  // namespace gno::host
