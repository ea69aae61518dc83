// SPDX-License-Identifier: MIT
// A scene for what stands far away: a floor, a cube on it, a camera; made in a test.
#pragma once
#include <cmath>

#include "scene_builder.hpp"

namespace gno::host::test {

/// A floor, a cube on it that is no cube on the grid, and a camera that looks at it from above; lights are added by the tests.
class Street {
public:
    explicit Street(glm::dvec3 at = glm::dvec3(0), double distance = 7, double yfov = 0.7) {
        builder.json["extensionsUsed"] = {"KHR_lights_punctual"};
        const Json place = {{"translation", {at.x, at.y, at.z}}};
        builder.meshNode({-10, 0, -10, 10, 0, -10, -10, 0, 10, 10, 0, 10}, {0, 2, 1, 1, 2, 3}, place);
        Json cube = place;
        cube["scale"] = {0.7, 1.3, 0.9};
        builder.meshNode(kCube, kCubeIndices, cube);
        const glm::dvec3 eye = at + distance * glm::normalize(glm::dvec3(1, 4, 6));
        const double tilt = -std::asin(4 / std::sqrt(53.0)) / 2, turn = std::atan2(1.0, 6.0) / 2;
        // turn about y, then tilt about the camera's x
        builder.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", yfov}, {"znear", distance / 100}}}}};
        builder.node({{"camera", 0},
                      {"translation", {eye.x, eye.y, eye.z}},
                      {"rotation",
                       {std::cos(turn) * std::sin(tilt), std::sin(turn) * std::cos(tilt), -std::sin(turn) * std::sin(tilt),
                        std::cos(turn) * std::cos(tilt)}}});
    }
    void pointLight(glm::dvec3 at) {
        Json& lights = builder.json["extensions"]["KHR_lights_punctual"]["lights"];
        lights.push_back({{"type", "point"}});
        builder.node({{"translation", {at.x, at.y, at.z}}, {"extensions", {{"KHR_lights_punctual", {{"light", lights.size() - 1}}}}}});
    }
    void triangleAt(glm::dvec3 at, float size) { builder.meshNode({0, 0, 0, size, 0, 0, 0, size, 0}, {}, {{"translation", {at.x, at.y, at.z}}}); }
    [[nodiscard]] SceneFile file() const { return loadBytes(builder.glb()); }
    static constexpr uint32_t kWidth = 320, kHeight = 240;
    [[nodiscard]] Frame frame(std::optional<uint32_t> light = std::nullopt) const { return file().evaluate(0, View{0, kWidth, kHeight, light}); }

    Builder builder;
};

}  // namespace gno::host::test
