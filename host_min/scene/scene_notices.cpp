// SPDX-License-Identifier: MIT
// What is told of a scene that was read without fault: what of it is not used, what stands in for what it lacks.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host_min/scene/one_line.hpp"
#include "host_min/scene/scene_data.hpp"

namespace gno::host {

namespace {

using Numbered = std::vector<std::pair<size_t, std::string>>;

/// Lights of the scene, by the numbers of --light, for which `is` holds.
template <class Is>
Numbered lightsThat(const tinygltf::Model& model, const SceneFile::Data& data, Is&& is) {
    Numbered lights;
    for (size_t i = 0; i < data.lightNodes.size(); ++i) {
        const NodeData& node = data.nodes[data.lightNodes[i]];
        const auto& light = model.lights[static_cast<size_t>(node.light)];
        if (is(light)) lights.emplace_back(i, node.name.empty() ? oneLine(light.name) : node.name);
    }
    return lights;
}

void tellOfLights(const tinygltf::Model& model, SceneFile::Data& data) {
    const auto tell = [&](const char* what, const Numbered& lights, const char* instead) {
        if (!lights.empty()) data.notices.add(fmt::format("{} of light{} {}: {}", what, lights.size() == 1 ? "" : "s", enumerated(lights), instead));
    };
    tell("range", lightsThat(model, data, [](const auto& light) { return light.range > 0; }), "not used, the light reaches as far as the scene");
    tell("cone", lightsThat(model, data, [](const auto& light) { return light.type == "spot"; }),
         "not used in mask and picture, which are those of a point light");
    tell("intensity", lightsThat(model, data, [](const auto& light) { return light.intensity != 1; }),
         "not used, pictures show every light equally bright");
}

void tellOfDefaults(SceneFile::Data& data) {
    const auto elsewhere = [&](size_t inScene, int NodeData::*member) -> std::string {
        const auto all = static_cast<size_t>(std::count_if(data.nodes.begin(), data.nodes.end(), [&](const NodeData& n) { return n.*member >= 0; }));
        return all > inScene ? fmt::format(" (the file has {} that stand in no shown part of it)", all - inScene) : std::string();
    };
    if (data.lightNodes.empty())
        data.notices.add(fmt::format(
            "lights: the scene has none{}; made two: light 0, a point light above on the right, and light 1, directional from the upper left",
            elsewhere(0, &NodeData::light)));
    if (data.cameraNodes.empty())
        data.notices.add(fmt::format("camera: the scene has none{}; made one that sees all of it", elsewhere(0, &NodeData::camera)));
}

void tellOfMeshes(const tinygltf::Model& model, SceneFile::Data& data) {
    if (data.facts.pointOrLinePrimitives > 0)
        data.notices.add(fmt::format("points and lines: {}, not drawn and casting nothing", counted(data.facts.pointOrLinePrimitives, "primitive")));
    size_t without = 0;
    for (const auto& mesh : model.meshes)
        without += static_cast<size_t>(std::count_if(mesh.primitives.begin(), mesh.primitives.end(), [](const auto& p) {
            return p.mode >= TINYGLTF_MODE_TRIANGLES && p.attributes.count("POSITION") == 0;
        }));
    if (without > 0) data.notices.add(fmt::format("primitives without POSITION: {}, left out", without));
}

}  // namespace

void tellOfScene(const tinygltf::Model& model, SceneFile::Data& data) {
    if (model.scenes.size() > 1)
        data.notices.add(fmt::format("scenes: scene {} of {} is shown, counted from 0", std::max(model.defaultScene, 0), model.scenes.size()));
    if (data.clips.size() > 1 && data.clip != kAllClips) {
        const std::string& name = data.clips[static_cast<size_t>(data.clip)].name;
        data.notices.add(fmt::format("animation: number {}{} of {} is taken; --animation N|NAME|all takes another, gnomon effects lists them",
                                     data.clip, name.empty() ? "" : " (" + name + ")", data.clips.size()));
    }
    tellOfDefaults(data);
    tellOfLights(model, data);
    tellOfMeshes(model, data);
}

std::vector<std::string> frameNotices(const SceneFile::Data& data, const Pose& pose, const Frame& frame) {
    Notices notices;
    if (frame.facts.zeroArea > 0)
        notices.add(fmt::format("triangles without area on the grid: {} of {}, neither seen nor casting", frame.facts.zeroArea,
                                frame.facts.zeroArea + frame.triangles.size()));
    const auto hasNoDirection = [&](uint32_t node) { return pose.world[node][2] == glm::dvec4(0.0); };
    for (size_t i = 0; i < data.lightNodes.size(); ++i) {
        const uint32_t node = data.lightNodes[i];
        const Light& light = frame.lights[i];
        const std::string name = fmt::format("light {}{}", i, light.name.empty() ? "" : " (" + light.name + ")");
        if (light.kind == Light::Kind::directional && hasNoDirection(node))
            notices.add(fmt::format("direction of {}: its node has a scale of 0, so it has none; taken for one along -z", name));
        if (!pose.visible[node]) notices.add(fmt::format("{}: hidden in this frame; asked for, it shines nevertheless", name));
    }
    return notices.lines();
}

}  // namespace gno::host
