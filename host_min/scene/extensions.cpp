// SPDX-License-Identifier: MIT
#include "host_min/scene/extensions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "host_min/error.hpp"
#include "host_min/scene/one_line.hpp"

namespace gno::host {

namespace {

using Json = nlohmann::json;

constexpr std::string_view kDraco = "KHR_draco_mesh_compression", kPointer = "KHR_animation_pointer";
constexpr std::array<std::string_view, 11> kRead{"KHR_lights_punctual",
                                                 "KHR_mesh_quantization",
                                                 "EXT_mesh_gpu_instancing",
                                                 "KHR_materials_transmission",
                                                 "KHR_materials_pbrSpecularGlossiness",
                                                 "KHR_texture_transform",
                                                 "KHR_node_visibility",
                                                 kPointer,
                                                 kDraco,
                                                 "EXT_meshopt_compression",
                                                 "KHR_meshopt_compression"};

bool isCompression(std::string_view name) { return name == kDraco || name.ends_with("_meshopt_compression"); }

// Extensions that change materials, textures or metadata, never a triangle.
bool changesNoGeometry(std::string_view name) {
    constexpr std::array<std::string_view, 6> prefixes{"KHR_materials_", "EXT_materials_", "ADOBE_materials_",
                                                       "KHR_texture_",   "EXT_texture_",   "KHR_xmp"};
    return name == "MSFT_texture_dds" || std::any_of(prefixes.begin(), prefixes.end(), [&](auto p) { return name.starts_with(p); });
}

std::vector<std::string> namesIn(const Json& root, const char* list) {
    const auto found = root.find(list);
    if (found == root.end()) return {};
    if (!found->is_array()) throw InputError(fmt::format("{} is not an array", list));
    std::vector<std::string> names;
    for (const Json& entry : *found) {
        if (!entry.is_string()) throw InputError(fmt::format("{} holds something that is no name", list));
        names.push_back(entry.get<std::string>());
    }
    return names;
}

const Json* extensionOf(const Json& object, std::string_view name) {
    const auto extensions = object.find("extensions");
    if (extensions == object.end()) return nullptr;
    const auto found = extensions->find(name);
    return found == extensions->end() ? nullptr : &*found;
}

const Json& listOf(const Json& root, const char* key) {
    static const Json none = Json::array();
    const auto found = root.find(key);
    return found == root.end() ? none : *found;
}

/// It has bytes of its own; without any it would be all zero.
bool hasBytes(const Json& accessors, const Json& index) {
    const auto number = index.get<uint64_t>();
    return number >= accessors.size() || accessors[number].contains("bufferView") || accessors[number].contains("sparse");  // the former: told later
}

bool isReadAttribute(std::string_view name) {
    return name == "POSITION" || name == "COLOR_0" || name.starts_with("TEXCOORD_") || name.starts_with("JOINTS_") || name.starts_with("WEIGHTS_");
}

/// Whether something that we read of this primitive is in its compressed data only.
bool needsDraco(const Json& primitive, const Json& accessors) {
    if (const auto indices = primitive.find("indices"); indices != primitive.end() && !hasBytes(accessors, *indices)) return true;
    for (const auto& [name, accessor] : primitive.at("attributes").items())
        if (isReadAttribute(name) && !hasBytes(accessors, accessor)) return true;
    return false;
}

struct Target {
    uint64_t node;
    std::string path;
};

/// "/nodes/7/translation" and the like; nullopt: something else.
std::optional<Target> nodeTarget(std::string_view pointer) {
    constexpr std::string_view kNodes = "/nodes/", kVisible = "extensions/KHR_node_visibility/visible";
    if (!pointer.starts_with(kNodes)) return std::nullopt;
    pointer.remove_prefix(kNodes.size());
    Target target{};
    const auto [end, error] = std::from_chars(pointer.data(), pointer.data() + pointer.size(), target.node);
    const auto length = static_cast<size_t>(end - pointer.data());
    if (error != std::errc{} || length >= pointer.size() || pointer[length] != '/') return std::nullopt;
    const std::string_view member = pointer.substr(length + 1);
    for (const std::string_view path : {"translation", "rotation", "scale", "weights"})
        if (member == path) target.path = path;
    if (member == kVisible) target.path = "visible";
    if (target.path.empty()) return std::nullopt;
    return target;
}

/// Makes it an ordinary channel, or returns what it aims at in vain.
std::optional<std::string> resolve(Json& channel, size_t nodeCount, const std::string& what) {
    const auto found = channel.find("target");
    if (found == channel.end() || !found->is_object()) throw InputError(what + " has no target");
    Json& target = *found;
    const auto path = target.find("path");
    if (path == target.end() || !path->is_string()) throw InputError(what + " has no path");
    if (const Json* extension = extensionOf(target, kPointer); extension != nullptr && *path == "pointer") {
        const auto pointer = extension->find("pointer");
        if (pointer == extension->end() || !pointer->is_string()) throw InputError(what + ": its KHR_animation_pointer has no pointer");
        const auto text = pointer->get<std::string>();
        const std::optional<Target> aim = nodeTarget(text);
        if (!aim) return oneLine(text);
        if (aim->node >= nodeCount)
            throw InputError(fmt::format("{}: {}: node {} does not exist, there are {}", what, oneLine(text), aim->node, nodeCount));
        target = {{"node", aim->node}, {"path", aim->path}};
        return std::nullopt;
    }
    constexpr std::array<std::string_view, 4> kPaths{"translation", "rotation", "scale", "weights"};
    const auto name = path->get<std::string>();
    if (std::find(kPaths.begin(), kPaths.end(), name) == kPaths.end()) return oneLine(name);
    if (!target.contains("node")) return name + " of no node";
    return std::nullopt;
}

}  // namespace

bool isReadExtension(std::string_view name) { return std::find(kRead.begin(), kRead.end(), name) != kRead.end(); }

void checkRequiredExtensions(const Json& root) {
    for (const std::string& name : namesIn(root, "extensionsRequired"))
        if (isCompression(name) || (!isReadExtension(name) && !changesNoGeometry(name)))
            throw InputError(fmt::format("it requires the extension {}, which gnomon does not read; export the model without it", oneLine(name)));
}

void tellOfExtensions(const Json& root, const std::set<std::string>& met, Notices& notices) {
    std::vector<std::string> names = namesIn(root, "extensionsRequired"), used = namesIn(root, "extensionsUsed");
    names.insert(names.end(), used.begin(), used.end());
    names.insert(names.end(), met.begin(), met.end());
    for (const std::string& name : names)
        if (!isReadExtension(name))
            notices.add(fmt::format("extension {}: not read{}", oneLine(name),
                                    changesNoGeometry(name) ? "; it concerns materials, textures or metadata" : ", gnomon does not know it"));
}

void checkCompression(const Json& root, Notices& notices) {
    const Json &meshes = listOf(root, "meshes"), &accessors = listOf(root, "accessors");
    for (size_t m = 0; m < meshes.size(); ++m) {
        const Json& primitives = listOf(meshes[m], "primitives");
        for (size_t p = 0; p < primitives.size(); ++p) {
            if (extensionOf(primitives[p], kDraco) == nullptr) continue;
            if (needsDraco(primitives[p], accessors))
                throw InputError(fmt::format(
                    "mesh {} primitive {} has its data in {} alone, which gnomon does not read; export the model without it", m, p, kDraco));
            notices.add(fmt::format("extension {}: the file's uncompressed copy is read", kDraco));
        }
    }
    for (const Json& view : listOf(root, "bufferViews"))
        if (const auto extensions = view.find("extensions"); extensions != view.end())
            if (const char* name = meshoptOf(*extensions))
                notices.add(fmt::format("extension {}: data are read where the file has an uncompressed copy", name));
}

void resolvePointers(Json& root, Notices& notices) {
    const auto animations = root.find("animations");
    if (animations == root.end()) return;
    const size_t nodeCount = listOf(root, "nodes").size();
    std::vector<std::string> leftAlone;
    for (size_t a = 0; a < animations->size(); ++a) {
        const auto channels = (*animations)[a].find("channels");
        if (channels == (*animations)[a].end()) continue;
        Json kept = Json::array();
        for (size_t c = 0; c < channels->size(); ++c) {
            const std::optional<std::string> aim = resolve((*channels)[c], nodeCount, fmt::format("animation {} channel {}", a, c));
            if (!aim)
                kept.push_back(std::move((*channels)[c]));
            else if (std::find(leftAlone.begin(), leftAlone.end(), *aim) == leftAlone.end())
                leftAlone.push_back(*aim);
        }
        *channels = std::move(kept);
    }
    for (const std::string& aim : leftAlone) notices.add(fmt::format("animation of {}: not applied", aim));
}

bool isFallbackBuffer(const Json& buffer) {
    const auto extensions = buffer.find("extensions");
    if (extensions == buffer.end() || !extensions->is_object()) return false;
    const char* name = meshoptOf(*extensions);
    if (name == nullptr) return false;
    const Json& extension = extensions->at(name);
    if (!extension.is_object()) throw InputError(fmt::format("{} is not an object", name));
    const auto fallback = extension.find("fallback");
    if (fallback == extension.end()) return false;
    if (!fallback->is_boolean()) throw InputError(fmt::format("{}: fallback is neither true nor false", name));
    return fallback->get<bool>();
}

}  // namespace gno::host
