// SPDX-License-Identifier: MIT
// Node animations. One clip of a file is applied, or all in file order, so that a later one wins.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "host_min/error.hpp"
#include "host_min/scene/one_line.hpp"
#include "host_min/scene/scene_data.hpp"

namespace gno::host {

namespace {

using Path = ChannelData::Path;
using Interpolation = ChannelData::Interpolation;

void checkTimes(const std::vector<double>& times, const std::string& what) {
    for (size_t i = 0; i < times.size(); ++i) {
        if (!(std::abs(times[i]) <= kLargestNumber)) throw InputError(fmt::format("{}: time {} is not finite", what, i));
        if (i > 0 && times[i] < times[i - 1]) throw InputError(fmt::format("{}: times do not rise", what));
    }
}

bool readPath(const std::string& name, Path& path) {
    if (name == "translation")
        path = Path::translation;
    else if (name == "rotation")
        path = Path::rotation;
    else if (name == "scale")
        path = Path::scale;
    else if (name == "weights")
        path = Path::weights;
    else if (name == "visible")
        path = Path::visible;  // resolvePointers
    else
        return false;
    return true;
}

Interpolation readInterpolation(const std::string& name, const std::string& what) {
    if (name == "LINEAR" || name.empty()) return Interpolation::linear;
    if (name == "STEP") return Interpolation::step;
    if (name == "CUBICSPLINE") return Interpolation::cubic;
    throw InputError(what + ": unknown interpolation; glTF has LINEAR, STEP and CUBICSPLINE");
}

// The value between two keys, `width` numbers, written to `out`.
void between(const ChannelData& channel, size_t key, double seconds, double* out) {
    const size_t width = channel.width;
    const std::vector<double>& times = *channel.times;
    const double span = times[key + 1] - times[key];
    const double t = span > 0 ? (seconds - times[key]) / span : 0.0;
    if (channel.interpolation == Interpolation::cubic) {
        const double* a = channel.values->data() + key * width * 3;  // in-tangent, value, out-tangent
        const double* b = a + width * 3;
        const double t2 = t * t, t3 = t2 * t;
        for (size_t i = 0; i < width; ++i)
            out[i] = (2 * t3 - 3 * t2 + 1) * a[width + i] + span * (t3 - 2 * t2 + t) * a[2 * width + i] + (3 * t2 - 2 * t3) * b[width + i] +
                     span * (t3 - t2) * b[i];
        return;
    }
    const double* a = channel.values->data() + key * width;
    const double* b = a + width;
    if (channel.interpolation == Interpolation::step) {
        std::copy(a, a + width, out);
    } else if (channel.path == Path::rotation) {
        const glm::dquat q = glm::slerp(glm::normalize(glm::dquat(a[3], a[0], a[1], a[2])), glm::normalize(glm::dquat(b[3], b[0], b[1], b[2])), t);
        out[0] = q.x, out[1] = q.y, out[2] = q.z, out[3] = q.w;
    } else {
        for (size_t i = 0; i < width; ++i) out[i] = a[i] + (b[i] - a[i]) * t;
    }
}

void sample(const ChannelData& channel, double seconds, std::vector<double>& out) {
    const std::vector<double>& times = *channel.times;
    out.resize(channel.width);
    const auto later = std::upper_bound(times.begin(), times.end(), seconds);
    const bool isCubic = channel.interpolation == Interpolation::cubic;
    if (later != times.begin() && later != times.end()) {
        between(channel, static_cast<size_t>(later - times.begin()) - 1, seconds, out.data());
        return;
    }
    const size_t key = later == times.begin() ? 0 : times.size() - 1;
    const double* value = channel.values->data() + (isCubic ? key * 3 + 1 : key) * channel.width;
    std::copy(value, value + channel.width, out.begin());
}

}  // namespace

std::vector<ClipData> loadAnimations(const tinygltf::Model& model, Accessors& accessors, const SceneFile::Data& data, Notices& notices) {
    std::vector<ClipData> clips;
    for (size_t a = 0; a < model.animations.size(); ++a) {
        const tinygltf::Animation& animation = model.animations[a];
        ClipData& clip = clips.emplace_back();
        clip.name = oneLine(animation.name);
        for (size_t c = 0; c < animation.channels.size(); ++c) {
            const auto& from = animation.channels[c];
            const std::string what = fmt::format("animation {} channel {}", a, c);
            ChannelData channel;
            if (from.sampler < 0 || static_cast<size_t>(from.sampler) >= animation.samplers.size())
                throw InputError(fmt::format("{}: sampler {} does not exist, there are {}", what, from.sampler, animation.samplers.size()));
            if (from.target_node < 0 || !readPath(from.target_path, channel.path)) continue;  // resolvePointers told of it
            if (static_cast<size_t>(from.target_node) >= data.nodes.size())
                throw InputError(fmt::format("{}: node {} does not exist, there are {}", what, from.target_node, data.nodes.size()));
            channel.node = static_cast<uint32_t>(from.target_node);
            const bool isWeights = channel.path == Path::weights, isVisible = channel.path == Path::visible;
            channel.width = isWeights ? data.nodes[channel.node].weights.size() : channel.path == Path::rotation ? 4 : isVisible ? 1 : 3;
            if (channel.width == 0) {
                notices.add(fmt::format("animation of the weights of node {}: not applied, its mesh has no morph targets", channel.node));
                continue;
            }
            const auto& sampler = animation.samplers[static_cast<size_t>(from.sampler)];
            channel.interpolation = readInterpolation(sampler.interpolation, what);
            if (isVisible && channel.interpolation != Interpolation::step)
                throw InputError(what + ": a visibility is true or false, its interpolation has to be STEP");
            channel.times = accessors.shared(sampler.input, TINYGLTF_TYPE_SCALAR, what + " input");
            checkTimes(*channel.times, what);
            const int type = isWeights || isVisible ? TINYGLTF_TYPE_SCALAR : channel.width == 4 ? TINYGLTF_TYPE_VEC4 : TINYGLTF_TYPE_VEC3;
            channel.values = accessors.shared(sampler.output, type, what + " output");
            const size_t wanted = channel.times->size() * channel.width * (channel.interpolation == Interpolation::cubic ? 3 : 1);
            if (channel.values->size() != wanted)
                throw InputError(
                    fmt::format("{}: {} numbers for {} times, {} are needed", what, channel.values->size(), channel.times->size(), wanted));
            for (const double value : *channel.values)
                if (!(std::abs(value) <= kLargestNumber)) throw InputError(what + ": a value is not finite");
            clip.channels.push_back(std::move(channel));
        }
    }
    return clips;
}

double ClipData::lastKeyframe() const {
    double last = 0;
    for (const ChannelData& channel : channels) last = std::max(last, channel.times->back());
    return last;
}

int clipByWord(const std::vector<ClipData>& clips, const std::string& word) {
    if (clips.empty()) throw InputError(fmt::format("--animation {}: the file has no animations", oneLine(word)));
    if (word == "all") return kAllClips;
    size_t number = clips.size();
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error == std::errc{} && end == word.data() + word.size() && number < clips.size()) return static_cast<int>(number);
    std::vector<std::pair<size_t, std::string>> all;
    int found = -1, same = 0;
    for (size_t i = 0; i < clips.size(); ++i) {
        all.emplace_back(i, clips[i].name);
        if (clips[i].name != oneLine(word)) continue;
        found = static_cast<int>(i);
        ++same;
    }
    if (same == 1) return found;
    if (same > 1) throw InputError(fmt::format("--animation {}: {} animations are called so; give the number", oneLine(word), same));
    throw InputError(fmt::format("--animation {}: there is none; the file has {}", oneLine(word), enumerated(all)));
}

std::span<const ClipData> appliedClips(const SceneFile::Data& data) {
    const std::span all(data.clips);
    return data.clip == kAllClips || all.empty() ? all : all.subspan(static_cast<size_t>(data.clip), 1);
}

Pose poseAt(const SceneFile::Data& data, double seconds) {
    struct Local {
        glm::dvec3 translation, scale;
        glm::dquat rotation;
        bool hasMatrix;
    };
    std::vector<Local> local;
    Pose pose;
    local.reserve(data.nodes.size());
    pose.weights.reserve(data.nodes.size());
    pose.visible.reserve(data.nodes.size());
    for (const NodeData& node : data.nodes) {
        local.push_back({node.translation, node.scale, node.rotation, node.hasMatrix});
        pose.weights.push_back(node.weights);
        pose.visible.push_back(node.isVisible);
    }
    std::vector<double> value;
    const auto apply = [&](const ChannelData& channel) {
        sample(channel, seconds, value);
        if (channel.path == Path::weights) {
            pose.weights[channel.node] = value;
            return;
        }
        if (channel.path == Path::visible) {
            pose.visible[channel.node] = value[0] != 0;
            return;
        }
        Local& target = local[channel.node];
        target.hasMatrix = false;
        if (channel.path == Path::translation) target.translation = {value[0], value[1], value[2]};
        if (channel.path == Path::scale) target.scale = {value[0], value[1], value[2]};
        if (channel.path == Path::rotation) {
            const glm::dquat q(value[3], value[0], value[1], value[2]);
            const double length = glm::length(q);
            if (length > 0) target.rotation = q / length;  // NaN or zero, between opposite keys: the node keeps its rotation
        }
    };
    for (const ClipData& clip : appliedClips(data))
        for (const ChannelData& channel : clip.channels) apply(channel);
    pose.world.resize(data.nodes.size());
    for (const uint32_t i : data.order) {
        const NodeData& node = data.nodes[i];
        const glm::dmat4 own = local[i].hasMatrix ? node.matrix : composed(local[i].translation, local[i].rotation, local[i].scale);
        pose.world[i] = node.parent < 0 ? own : pose.world[static_cast<size_t>(node.parent)] * own;
        if (node.parent >= 0 && !pose.visible[static_cast<size_t>(node.parent)]) pose.visible[i] = 0;
        if (node.inScene) checkMatrix(pose.world[i], fmt::format("node {}", i));
    }
    return pose;
}

}  // namespace gno::host
