// SPDX-License-Identifier: MIT
// A scene while it is being made: what a GLB file holds, without its encoding.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "scenes/generator/mesh.hpp"
#include "scenes/generator/numbers.hpp"

namespace gno::scenes {

inline constexpr int kFrames = 60;  ///< keyframes of the animation, at frame / 30 seconds

/// 8 bits a channel: red, green and blue in sRGB, alpha; rows from the top.
struct Texture {
    uint32_t width = 0, height = 0;
    std::vector<uint8_t> rgba;
    bool nearest = false;  ///< the filter; bilinear otherwise
    int wrap = 10497;      ///< glTF's number, for both axes: 10497 repeat, 33648 mirrored, 33071 clamp
};

struct Material {
    std::string name;
    glm::dvec3 color;  ///< linear
    std::string alphaMode{};
    double opacity = 1, cutoff = 0.5, transmission = 0;
    int texture = -1;
    bool doubleSided = false;  ///< seen from behind as well: thin things, and rooms that are seen from inside; what lets light through always is
};

struct Part {
    uint32_t material = 0;
    Mesh mesh;
};

/// Meshes are shared: several nodes may show one.
struct Model {
    std::string name;
    std::vector<Part> parts;

    [[nodiscard]] size_t triangleCount() const;
    /// The part of `material`, made when it is missing. Valid until the next call.
    Mesh& of(uint32_t material);
};

struct Light {
    std::string type;  ///< glTF: point, directional, spot; a node's -z axis is the direction
    glm::dvec3 color{1};
    double intensity = 1;             ///< candela, or lux of a directional light
    double inner = 0, outer = 0.785;  ///< spot: half angles, radians
};

struct Node {
    std::string name;
    glm::dvec3 translation{0};
    glm::dquat rotation{1, 0, 0, 0};
    glm::dvec3 scale{1};
    int parent = -1, model = -1, light = -1;
    bool camera = false;
};

/// Where a node is at a time in [0, 1] of the animation.
struct Pose {
    glm::dvec3 translation{0};
    glm::dquat rotation{1, 0, 0, 0};
};

struct Track {
    int node;
    bool moves, turns;
    std::array<Pose, kFrames> poses;
};

struct Draft {
    std::vector<Texture> textures;
    std::vector<Material> materials;
    std::vector<Model> models;
    std::vector<Node> nodes;  ///< parents before their children
    std::vector<Light> lights;
    std::vector<Track> tracks;
    double yfov = 0.8, znear = 0.05;

    uint32_t material(const std::string& name, const glm::dvec3& color);
    uint32_t material(const Material& material);
    int model(Model model);  ///< its index; empty parts are dropped
    int place(int model, const glm::dvec3& translation, const glm::dquat& rotation = {1, 0, 0, 0}, const glm::dvec3& scale = glm::dvec3(1),
              int parent = -1);
    /// Adds a model that stands in one place only, with its vertices in world space.
    int placeOnce(Model model);
    void animate(int node, bool moves, bool turns, const std::function<Pose(double)>& pose);

    /// The camera flies along eye(t) and looks at target(t).
    void camera(const std::function<glm::dvec3(double)>& eye, const std::function<glm::dvec3(double)>& target);
    /// `reach` is a distance at which a white surface is well lit.
    void pointLight(const glm::dvec3& color, double reach, const std::function<glm::dvec3(double)>& position);
    /// `towards(t)` points to the sun.
    void sun(const glm::dvec3& color, const std::function<glm::dvec3(double)>& towards);
    void spotLight(const glm::dvec3& color, double reach, double halfAngle, const std::function<glm::dvec3(double)>& position,
                   const std::function<glm::dvec3(double)>& target);

    [[nodiscard]] size_t triangleCount() const;  ///< of all nodes
};

/// 0 at t = 0, 1 at t = 1, with no jerk at the ends.
double ease(double t);

}  // namespace gno::scenes
