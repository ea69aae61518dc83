// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host_min/error.hpp"
#include "host_min/scene/one_line.hpp"
#include "host_min/scene/scene_data.hpp"

namespace gno::host {

glm::dmat4 composed(const glm::dvec3& translation, const glm::dquat& rotation, const glm::dvec3& scale) {
    const glm::dmat3 turn = glm::mat3_cast(rotation);
    return {glm::dvec4(turn[0] * scale.x, 0.0), glm::dvec4(turn[1] * scale.y, 0.0), glm::dvec4(turn[2] * scale.z, 0.0),
            glm::dvec4(translation, 1.0)};
}

void checkMatrix(const glm::dmat4& matrix, const std::string& what) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!(std::abs(matrix[column][row]) <= kLargestNumber))
                throw InputError(fmt::format("the matrix of {} is not finite, or exceeds 1e30", what));
}

namespace {

int checkReference(int index, size_t count, const char* what, size_t node) {
    if (index >= static_cast<int>(count)) throw InputError(fmt::format("node {}: {} {} does not exist, there are {}", node, what, index, count));
    return index < 0 ? -1 : index;
}

glm::dvec3 vec3At(const std::vector<double>& values, size_t at) { return {values[at], values[at + 1], values[at + 2]}; }

// glTF's order is x, y, z, w. A quaternion of length 0 turns nothing.
glm::dquat quatAt(const std::vector<double>& values, size_t at) {
    const glm::dquat q(values[at + 3], values[at], values[at + 1], values[at + 2]);
    const double length = glm::length(q);
    return length > 0 && std::isfinite(length) ? q / length : glm::dquat(1, 0, 0, 0);
}

void readTransform(const tinygltf::Node& from, NodeData& to) {
    if (from.matrix.size() == 16) {
        to.hasMatrix = true;
        for (size_t i = 0; i < 16; ++i) to.matrix[static_cast<int>(i / 4)][static_cast<int>(i % 4)] = from.matrix[i];
        // The parts stand in for what an animation of the node leaves alone.
        glm::dmat3 turn(to.matrix);
        to.translation = glm::dvec3(to.matrix[3]);
        for (int axis = 0; axis < 3; ++axis) to.scale[axis] = glm::length(turn[axis]);
        if (glm::determinant(turn) < 0) to.scale.x = -to.scale.x;
        if (to.scale.x * to.scale.y * to.scale.z != 0) {
            for (int axis = 0; axis < 3; ++axis) turn[axis] /= to.scale[axis];
            to.rotation = glm::normalize(glm::quat_cast(turn));
        }
        return;
    }
    if (from.translation.size() == 3) to.translation = vec3At(from.translation, 0);
    if (from.scale.size() == 3) to.scale = vec3At(from.scale, 0);
    if (from.rotation.size() == 4) to.rotation = quatAt(from.rotation, 0);
}

void readInstances(const tinygltf::Value& extension, Accessors& accessors, uint64_t& instances, NodeData& node, const std::string& what) {
    if (!extension.IsObject() || !extension.Has("attributes")) return;
    const tinygltf::Value& attributes = extension.Get("attributes");
    const std::vector<double>* parts[3] = {};
    size_t count = 0;
    const char* names[3] = {"TRANSLATION", "ROTATION", "SCALE"};
    for (int part = 0; part < 3; ++part) {
        if (!attributes.Has(names[part])) continue;
        const bool isRotation = part == 1;
        parts[part] = &accessors.values(attributes.Get(names[part]).Get<int>(), isRotation ? TINYGLTF_TYPE_VEC4 : TINYGLTF_TYPE_VEC3,
                                        what + " " + names[part]);
        const size_t entries = parts[part]->size() / (isRotation ? 4 : 3);
        if (count != 0 && entries != count) throw InputError(fmt::format("{}: EXT_mesh_gpu_instancing has attributes of different lengths", what));
        count = entries;
    }
    if (count == 0) return;
    instances += count;
    if (instances > kMostInstances) throw InputError(fmt::format("the file has more than {} mesh instances", kMostInstances));
    node.instances.assign(count, glm::dmat4(1.0));
    for (size_t i = 0; i < count; ++i) {
        node.instances[i] =
            composed(parts[0] ? vec3At(*parts[0], i * 3) : glm::dvec3(0.0), parts[1] ? quatAt(*parts[1], i * 4) : glm::dquat(1, 0, 0, 0),
                     parts[2] ? vec3At(*parts[2], i * 3) : glm::dvec3(1.0));
        checkMatrix(node.instances[i], fmt::format("{} instance {}", what, i));
    }
}

NodeData readNode(const tinygltf::Model& model, size_t index, Accessors& accessors, const std::vector<MeshData>& meshes, uint64_t& instances) {
    const tinygltf::Node& from = model.nodes[index];
    const std::string what = fmt::format("node {}", index);
    NodeData node;
    node.name = oneLine(from.name);
    readTransform(from, node);
    checkMatrix(node.hasMatrix ? node.matrix : composed(node.translation, node.rotation, node.scale), what);
    node.mesh = checkReference(from.mesh, model.meshes.size(), "mesh", index);
    node.skin = checkReference(from.skin, model.skins.size(), "skin", index);
    node.camera = checkReference(from.camera, model.cameras.size(), "camera", index);
    if (const auto light = from.extensions.find("KHR_lights_punctual"); light != from.extensions.end()) {
        if (!light->second.Has("light")) throw InputError(what + ": KHR_lights_punctual names no light");
        node.light = checkReference(light->second.Get("light").Get<int>(), model.lights.size(), "light", index);
    }
    if (const auto visibility = from.extensions.find("KHR_node_visibility"); visibility != from.extensions.end())
        node.isVisible = !visibility->second.Has("visible") || visibility->second.Get("visible").Get<bool>();  // guardJson saw that it is one
    if (node.mesh >= 0) {
        const MeshData& mesh = meshes[static_cast<size_t>(node.mesh)];
        node.weights = from.weights.empty() ? mesh.weights : from.weights;
        if (node.weights.size() != mesh.weights.size())
            throw InputError(fmt::format("{} has {} weights for {} morph targets", what, node.weights.size(), mesh.weights.size()));
        for (const double weight : node.weights)
            if (!(std::abs(weight) <= kLargestNumber)) throw InputError(what + ": a weight is not finite");
        if (const auto many = from.extensions.find("EXT_mesh_gpu_instancing"); many != from.extensions.end())
            readInstances(many->second, accessors, instances, node, what);
    }
    return node;
}

// Parents before children; every node has one parent at most, and nobody is their own ancestor.
void orderNodes(const tinygltf::Model& model, SceneFile::Data& data) {
    auto& nodes = data.nodes;
    for (size_t i = 0; i < nodes.size(); ++i) {
        for (const int child : model.nodes[i].children) {
            if (child < 0 || static_cast<size_t>(child) >= nodes.size())
                throw InputError(fmt::format("node {}: child {} does not exist, there are {} nodes", i, child, nodes.size()));
            if (nodes[static_cast<size_t>(child)].parent >= 0) throw InputError(fmt::format("node {} has two parents", child));
            nodes[static_cast<size_t>(child)].parent = static_cast<int>(i);
        }
    }
    for (size_t i = 0; i < nodes.size(); ++i)
        if (nodes[i].parent < 0) data.order.push_back(static_cast<uint32_t>(i));
    for (size_t done = 0; done < data.order.size(); ++done)
        for (const int child : model.nodes[data.order[done]].children) data.order.push_back(static_cast<uint32_t>(child));
    if (data.order.size() != nodes.size()) throw InputError("the nodes form a cycle");
}

void markScene(const tinygltf::Model& model, SceneFile::Data& data) {
    auto& nodes = data.nodes;
    if (model.scenes.empty()) {
        for (NodeData& node : nodes) node.inScene = true;
        return;
    }
    const int scene = std::max(model.defaultScene, 0);
    if (static_cast<size_t>(scene) >= model.scenes.size())
        throw InputError(fmt::format("scene {} does not exist, there are {}", scene, model.scenes.size()));
    for (const auto& each : model.scenes)
        for (const int root : each.nodes)
            if (root < 0 || static_cast<size_t>(root) >= nodes.size())
                throw InputError(fmt::format("a scene names node {}, there are {}", root, nodes.size()));
    for (const int root : model.scenes[static_cast<size_t>(scene)].nodes) nodes[static_cast<size_t>(root)].inScene = true;
    for (const uint32_t i : data.order)
        if (nodes[i].parent >= 0 && nodes[static_cast<size_t>(nodes[i].parent)].inScene) nodes[i].inScene = true;
}

}  // namespace

void loadNodes(const tinygltf::Model& model, Accessors& accessors, SceneFile::Data& data) {
    uint64_t instances = 0;
    for (size_t i = 0; i < model.nodes.size(); ++i) data.nodes.push_back(readNode(model, i, accessors, data.meshes, instances));
    orderNodes(model, data);
    markScene(model, data);
    for (size_t i = 0; i < data.nodes.size(); ++i) {
        const NodeData& node = data.nodes[i];
        if (!node.inScene) continue;
        if (node.mesh >= 0) data.meshNodes.push_back(static_cast<uint32_t>(i));
        if (node.light >= 0) data.lightNodes.push_back(static_cast<uint32_t>(i));
        if (node.camera >= 0) data.cameraNodes.push_back(static_cast<uint32_t>(i));
    }
    for (const uint32_t i : data.meshNodes) {
        const NodeData& node = data.nodes[i];
        if (node.skin < 0) continue;
        const size_t joints = data.skins[static_cast<size_t>(node.skin)].joints.size();
        for (const PrimitiveData& primitive : data.meshes[static_cast<size_t>(node.mesh)].primitives)
            if (primitive.jointCount > joints)
                throw InputError(fmt::format("node {}: its mesh uses joint {}, its skin has {}", i, primitive.jointCount - 1, joints));
    }
}

}  // namespace gno::host
