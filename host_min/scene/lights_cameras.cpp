// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host_min/error.hpp"
#include "host_min/scene/one_line.hpp"
#include "host_min/scene/scene_data.hpp"

namespace gno::host {

namespace {

// What a file without lights or cameras gets, from the box of all triangles in frame 0 (so that nothing moves with an animation):
//   centre c, diagonal d = |high - low|
//   light 0, point        at c + d * (0.7, 0.8, 0.1): right of the camera, above
//   light 1, directional  towards the light (-0.6, 0.8, 0.35): from the upper left
//   camera, perspective   yfov 0.8 rad, at c + r * normalize(0.55, 0.45, 1), r = 1.02 * (d / 2) / sin(0.4), looking at c, y up;
//                         znear = (r - d / 2) / 2, zfar infinite. The bounding sphere fits for every aspect >= 1.
constexpr glm::dvec3 kDefaultPoint{0.7, 0.8, 0.1};
constexpr glm::dvec3 kDefaultTowards{-0.6, 0.8, 0.35};
constexpr glm::dvec3 kDefaultView{0.55, 0.45, 1.0};
constexpr double kDefaultFov = 0.8, kDefaultMargin = 1.02;

glm::dvec3 centreOf(const Box& box) { return box.low * 0.5 + box.high * 0.5; }
double diagonalOf(const Box& box) { return glm::length(box.high - box.low); }
glm::dvec3 defaultPoint(const Box& box) { return centreOf(box) + diagonalOf(box) * kDefaultPoint; }

void check(bool ok, const std::string& what) {
    if (!ok) throw InputError(what);
}

Light readLight(const tinygltf::Light& from, size_t index) {
    const std::string what = fmt::format("light {}", index);
    Light light;
    light.name = oneLine(from.name);
    if (from.type == "point")
        light.kind = Light::Kind::point;
    else if (from.type == "directional")
        light.kind = Light::Kind::directional;
    else if (from.type == "spot")
        light.kind = Light::Kind::spot;
    else
        throw InputError(fmt::format("{}: unknown type {}; KHR_lights_punctual has point, directional and spot", what, oneLine(from.type)));
    if (from.color.size() == 3)
        light.color = glm::vec3(static_cast<float>(from.color[0]), static_cast<float>(from.color[1]), static_cast<float>(from.color[2]));
    check(std::isfinite(light.color.x) && std::isfinite(light.color.y) && std::isfinite(light.color.z), what + ": its colour is not finite");
    light.intensity = static_cast<float>(from.intensity);
    check(std::isfinite(light.intensity) && light.intensity >= 0, what + ": its intensity is negative or not finite");
    if (light.kind == Light::Kind::spot) {
        light.innerCone = static_cast<float>(from.spot.innerConeAngle);
        light.outerCone = static_cast<float>(from.spot.outerConeAngle);
        check(light.innerCone >= 0 && light.outerCone >= light.innerCone && light.outerCone > 0 && light.outerCone < 1.5708f,
              what + ": its cone angles do not satisfy 0 <= inner <= outer <= pi/2, outer > 0");
    }
    return light;
}

Camera readCamera(const tinygltf::Camera& from, size_t index) {
    const std::string what = fmt::format("camera {}", index);
    const auto isLength = [](double value) { return value > 0 && value <= kLargestNumber; };
    Camera camera;
    camera.name = oneLine(from.name);
    camera.perspective = from.type == "perspective";
    if (camera.perspective) {
        camera.yfov = from.perspective.yfov;
        camera.znear = from.perspective.znear;
        camera.zfar = from.perspective.zfar;
        camera.fileAspect = from.perspective.aspectRatio;
        check(camera.fileAspect >= 0 && camera.fileAspect <= kLargestNumber, what + ": aspectRatio is not positive");
        check(camera.yfov > 0 && camera.yfov < 3.1415926, what + ": yfov is not between 0 and pi");
        check(isLength(camera.znear), what + ": znear is not positive");
        check(camera.zfar == 0 || (camera.zfar > camera.znear && isLength(camera.zfar)), what + ": zfar is not beyond znear");
        return camera;
    }
    camera.xmag = std::abs(from.orthographic.xmag);
    camera.ymag = std::abs(from.orthographic.ymag);
    camera.znear = from.orthographic.znear;
    camera.zfar = from.orthographic.zfar;
    check(isLength(camera.xmag) && isLength(camera.ymag), what + ": xmag or ymag is zero or not finite");
    camera.fileAspect = camera.xmag / camera.ymag;
    check(camera.znear >= 0 && camera.zfar > camera.znear && isLength(camera.zfar), what + ": znear and zfar do not satisfy 0 <= znear < zfar");
    return camera;
}

// Unit vector along v; `otherwise` when v has no direction.
glm::dvec3 unit(glm::dvec3 v, glm::dvec3 otherwise) {
    const double size = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(size > 0)) return otherwise;
    return glm::normalize(v / size);
}

// A rotation whose columns are right, up and backward: z as given, y as close to `up` as can be.
glm::dmat3 looking(glm::dvec3 backward, glm::dvec3 up) {
    const glm::dvec3 z = unit(backward, {0, 0, 1});
    const glm::dvec3 fallback = std::abs(z.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, -1);
    up = unit(up, fallback);
    if (glm::length(glm::cross(up, z)) < 1e-9) up = fallback;
    const glm::dvec3 x = glm::normalize(glm::cross(up, z));
    return {x, glm::cross(z, x), z};
}

glm::dmat4 placed(const glm::dmat3& turn, glm::dvec3 position) {
    glm::dmat4 result(turn);
    result[3] = glm::dvec4(position, 1.0);
    return result;
}

std::vector<PlacedLight> defaultLights(const Box& box) {
    PlacedLight point{{}, defaultPoint(box), {0, 0, 1}};
    point.light.name = "default point light";
    point.light.isDefault = true;
    PlacedLight directional{point.light, {}, kDefaultTowards};
    directional.light.name = "default directional light";
    directional.light.kind = Light::Kind::directional;
    return {point, directional};
}

Camera defaultCamera(const Box& box) {
    const double radius = diagonalOf(box) / 2;
    const double distance = kDefaultMargin * radius / std::sin(kDefaultFov / 2);
    const glm::dvec3 backward = glm::normalize(kDefaultView);
    Camera camera;
    camera.name = "default camera";
    camera.isDefault = true;
    camera.yfov = kDefaultFov;
    camera.gridFromCamera = placed(looking(backward, {0, 1, 0}), centreOf(box) + distance * backward);
    camera.znear = (distance - radius) / 2;
    return camera;
}

}  // namespace

void loadLightsAndCameras(const tinygltf::Model& model, SceneFile::Data& data) {
    for (size_t i = 0; i < model.lights.size(); ++i) data.lights.push_back(readLight(model.lights[i], i));
    for (size_t i = 0; i < model.cameras.size(); ++i) data.cameras.push_back(readCamera(model.cameras[i], i));
}

std::vector<PlacedLight> lightsAt(const SceneFile::Data& data, const Pose& pose) {
    if (data.lightNodes.empty()) return defaultLights(data.firstFrame);
    std::vector<PlacedLight> lights;
    for (const uint32_t node : data.lightNodes) {
        const glm::dmat4& world = pose.world[node];
        PlacedLight placed{data.lights[static_cast<size_t>(data.nodes[node].light)], world[3], unit(world[2], {0, 0, 1})};  // it shines along -z
        placed.light.axis = glm::vec3(-placed.towards);
        if (!data.nodes[node].name.empty()) placed.light.name = data.nodes[node].name;
        lights.push_back(std::move(placed));
    }
    return lights;
}

Camera cameraAt(const SceneFile::Data& data, const Pose& pose, uint32_t index) {
    if (data.cameraNodes.empty()) return defaultCamera(data.firstFrame);
    const uint32_t node = data.cameraNodes[index];
    Camera camera = data.cameras[static_cast<size_t>(data.nodes[node].camera)];
    const glm::dmat4& world = pose.world[node];
    camera.gridFromCamera = placed(looking(glm::dvec3(world[2]), glm::dvec3(world[1])), glm::dvec3(world[3]));
    if (!data.nodes[node].name.empty()) camera.name = data.nodes[node].name;
    return camera;
}

Camera onGrid(Camera camera, const Grid& grid) {
    camera.gridFromCamera[3] = glm::dvec4((glm::dvec3(camera.gridFromCamera[3]) - grid.origin) * grid.scale(), 1.0);
    for (double* length : {&camera.znear, &camera.zfar, &camera.xmag, &camera.ymag}) *length *= grid.scale();
    return camera;
}

}  // namespace gno::host
