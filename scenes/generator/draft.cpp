// SPDX-License-Identifier: MIT
#include "scenes/generator/draft.hpp"

#include <algorithm>
#include <utility>

namespace gno::scenes {

size_t Model::triangleCount() const {
    size_t count = 0;
    for (const Part& part : parts) count += part.mesh.triangleCount();
    return count;
}

Mesh& Model::of(uint32_t material) {
    for (Part& part : parts)
        if (part.material == material) return part.mesh;
    parts.push_back({material, {}});
    return parts.back().mesh;
}

uint32_t Draft::material(const std::string& name, const glm::dvec3& color) { return material({name, color}); }

uint32_t Draft::material(const Material& added) {
    materials.push_back(added);
    return static_cast<uint32_t>(materials.size() - 1);
}

int Draft::model(Model added) {
    std::erase_if(added.parts, [](const Part& part) { return part.mesh.indices.empty(); });
    models.push_back(std::move(added));
    return static_cast<int>(models.size()) - 1;
}

int Draft::place(int which, const glm::dvec3& translation, const glm::dquat& rotation, const glm::dvec3& scale, int parent) {
    Node node;
    if (which >= 0) node.name = models[static_cast<size_t>(which)].name;
    node.translation = translation;
    node.rotation = rotation;
    node.scale = scale;
    node.parent = parent;
    node.model = which;
    nodes.push_back(std::move(node));
    return static_cast<int>(nodes.size()) - 1;
}

int Draft::placeOnce(Model added) {
    if (added.triangleCount() == 0) return -1;
    return place(model(std::move(added)), glm::dvec3(0));
}

void Draft::animate(int node, bool moves, bool turns, const std::function<Pose(double)>& pose) {
    Track track{node, moves, turns, {}};
    glm::dquat before(1, 0, 0, 0);
    for (size_t i = 0; i < kFrames; ++i) {
        Pose now = pose(static_cast<double>(i) / (kFrames - 1));
        if (glm::dot(now.rotation, before) < 0) now.rotation = -now.rotation;  // the short way between keyframes
        before = now.rotation;
        track.poses[i] = now;
    }
    Node& moved = nodes[static_cast<size_t>(node)];
    if (moves) moved.translation = track.poses[0].translation;
    if (turns) moved.rotation = track.poses[0].rotation;
    tracks.push_back(track);
}

void Draft::camera(const std::function<glm::dvec3(double)>& eye, const std::function<glm::dvec3(double)>& target) {
    const int node = place(-1, {});
    nodes.back().name = "camera";
    nodes.back().camera = true;
    animate(node, true, true, [&](double t) { return Pose{eye(t), lookAt(eye(t), target(t))}; });
}

void Draft::pointLight(const glm::dvec3& color, double reach, const std::function<glm::dvec3(double)>& position) {
    const int node = place(-1, {});
    nodes.back().name = "point light";
    nodes.back().light = static_cast<int>(lights.size());
    lights.push_back({"point", color, 3 * reach * reach, 0, 0});
    animate(node, true, false, [&](double t) { return Pose{position(t), {1, 0, 0, 0}}; });
}

void Draft::sun(const glm::dvec3& color, const std::function<glm::dvec3(double)>& towards) {
    const int node = place(-1, {});
    nodes.back().name = "sun";
    nodes.back().light = static_cast<int>(lights.size());
    lights.push_back({"directional", color, 3, 0, 0});
    animate(node, false, true, [&](double t) { return Pose{glm::dvec3(0), lookAt(towards(t), glm::dvec3(0))}; });
}

void Draft::spotLight(const glm::dvec3& color, double reach, double halfAngle, const std::function<glm::dvec3(double)>& position,
                      const std::function<glm::dvec3(double)>& target) {
    const int node = place(-1, {});
    nodes.back().name = "spot";
    nodes.back().light = static_cast<int>(lights.size());
    lights.push_back({"spot", color, 3 * reach * reach, halfAngle * 0.75, halfAngle});
    animate(node, true, true, [&](double t) { return Pose{position(t), lookAt(position(t), target(t))}; });
}

size_t Draft::triangleCount() const {
    size_t count = 0;
    for (const Node& node : nodes)
        if (node.model >= 0) count += models[static_cast<size_t>(node.model)].triangleCount();
    return count;
}

double ease(double t) { return t * t * (3 - 2 * t); }

}  // namespace gno::scenes
