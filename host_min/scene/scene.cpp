// SPDX-License-Identifier: MIT
#include "host_min/scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "host_min/error.hpp"
#include "host_min/scene/gltf_file.hpp"
#include "host_min/scene/notices.hpp"
#include "host_min/scene/one_line.hpp"
#include "host_min/scene/scene_data.hpp"

namespace gno::host {

namespace {

void countTriangles(SceneFile::Data& data) {
    for (const uint32_t i : data.meshNodes) {
        const NodeData& node = data.nodes[i];
        const MeshData& mesh = data.meshes[static_cast<size_t>(node.mesh)];
        data.facts.trianglesInFile += mesh.triangleCount * node.instances.size();
        data.facts.objects += static_cast<uint32_t>(node.instances.size());
        data.facts.pointOrLinePrimitives += mesh.pointOrLinePrimitives * node.instances.size();
        if (data.facts.trianglesInFile > kMostTriangles) throw InputError(fmt::format("the scene has more than {} triangles", kMostTriangles));
    }
    if (data.facts.trianglesInFile > 0) return;
    const bool isHidden = std::any_of(data.nodes.begin(), data.nodes.end(), [](const NodeData& n) { return n.inScene && n.mesh >= 0; });
    throw InputError(isHidden && data.meshNodes.empty() ? "all meshes of the scene are hidden (KHR_node_visibility)" : "the scene has no triangles");
}

// What no frame shows does not count. It may be shown by an animation of the node or of one above it.
void leaveOutHidden(SceneFile::Data& data) {
    std::vector<uint8_t> shown(data.nodes.size());
    for (size_t i = 0; i < shown.size(); ++i) shown[i] = data.nodes[i].isVisible;
    for (const ClipData& clip : appliedClips(data))
        for (const ChannelData& channel : clip.channels)
            if (channel.path == ChannelData::Path::visible) shown[channel.node] = 1;
    for (const uint32_t i : data.order)
        if (data.nodes[i].parent >= 0 && !shown[static_cast<size_t>(data.nodes[i].parent)]) shown[i] = 0;
    for (std::vector<uint32_t>* nodes : {&data.meshNodes, &data.lightNodes}) std::erase_if(*nodes, [&](uint32_t node) { return !shown[node]; });
}

// The box of frame 0; of everything where nothing is visible in it.
Box firstFrameBox(const SceneFile::Data& data) {
    Pose pose = poseAt(data, 0.0);
    const Box box = triangleBox(data, pose);
    if (!box.isEmpty()) return box;
    pose.visible.assign(pose.visible.size(), 1);
    return triangleBox(data, pose);
}

std::unique_ptr<SceneFile::Data> loadData(const std::filesystem::path& path, const std::string& animation) {
    auto data = std::make_unique<SceneFile::Data>();
    data->path = path;
    nlohmann::json lists;
    const tinygltf::Model model = openGltf(path, data->notices, lists);
    Accessors accessors(model);
    Textures textures(model, lists, folderOf(path), data->notices);
    uint64_t triangles = 0, displacements = 0;
    for (size_t i = 0; i < model.meshes.size(); ++i) {
        data->meshes.push_back(loadMesh(model, i, accessors, textures));
        triangles += data->meshes.back().triangleCount;
        displacements += data->meshes.back().displacements;
        if (triangles > kMostTriangles) throw InputError(fmt::format("the file has more than {} triangles", kMostTriangles));
        if (displacements > kMostDisplacements) throw InputError("the file has too many morph targets");
        data->facts.morphTargets += static_cast<uint32_t>(data->meshes.back().targetCount);
    }
    data->look = textures.take();
    data->skins = loadSkins(model, accessors);
    loadLightsAndCameras(model, *data);
    loadNodes(model, accessors, *data);
    data->clips = loadAnimations(model, accessors, *data, data->notices);
    if (!animation.empty()) data->clip = clipByWord(data->clips, animation);
    leaveOutHidden(*data);
    data->facts.animations = static_cast<uint32_t>(model.animations.size());
    data->facts.skins = static_cast<uint32_t>(model.skins.size());
    data->facts.lightsInFile = static_cast<uint32_t>(data->lightNodes.size());
    data->facts.camerasInFile = static_cast<uint32_t>(data->cameraNodes.size());
    countTriangles(*data);
    data->firstFrame = firstFrameBox(*data);
    tellOfScene(model, *data);
    data->facts.notices = data->notices.lines();
    return data;
}

// What goes wrong with a file is told with its path.
template <typename Work>
auto withPath(const std::filesystem::path& path, Work&& work) {
    try {
        return work();
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", oneLine(path.string()), error.what()));
    } catch (const std::bad_alloc&) {
        throw WorkError(fmt::format("{}: not enough memory", oneLine(path.string())));
    }
}

}  // namespace

SceneFile::SceneFile(std::unique_ptr<Data> data) : data_(std::move(data)) {}
SceneFile::SceneFile(SceneFile&&) noexcept = default;
SceneFile& SceneFile::operator=(SceneFile&&) noexcept = default;
SceneFile::~SceneFile() = default;

SceneFile SceneFile::load(const std::filesystem::path& path, const std::string& animation) {
    return withPath(path, [&] { return SceneFile(loadData(path, animation)); });
}

const std::filesystem::path& SceneFile::path() const { return data_->path; }
const std::vector<Material>& SceneFile::materials() const { return data_->look->materials; }
uint32_t SceneFile::cameraCount() const { return std::max(1u, data_->facts.camerasInFile); }
uint32_t SceneFile::lightCount() const { return data_->lightNodes.empty() ? 2u : data_->facts.lightsInFile; }

double SceneFile::lastKeyframe() const {
    double last = 0;
    for (const ClipData& clip : appliedClips(*data_)) last = std::max(last, clip.lastKeyframe());
    return last;
}

std::vector<Clip> SceneFile::clips() const {
    std::vector<Clip> all;
    for (const ClipData& clip : data_->clips) all.push_back({clip.name, clip.lastKeyframe()});
    return all;
}

std::optional<uint32_t> SceneFile::clip() const {
    if (data_->clips.empty() || data_->clip == kAllClips) return std::nullopt;
    return static_cast<uint32_t>(data_->clip);
}

Frame SceneFile::evaluate(uint32_t frame, uint32_t camera) const { return evaluate(frame, View{camera}); }

Frame SceneFile::evaluate(uint32_t frame, const View& view) const {
    return withPath(data_->path, [&] {
        if (view.camera >= cameraCount())
            throw InputError(fmt::format("camera {} does not exist; the scene has {}, counted from 0", view.camera, cameraCount()));
        if (view.light && *view.light >= lightCount())
            throw InputError(fmt::format("light {} does not exist; the scene has {}, counted from 0", *view.light, lightCount()));
        return evaluateFrame(*data_, frame / kFramesPerSecond, view);
    });
}

}  // namespace gno::host
