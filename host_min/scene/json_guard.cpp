// SPDX-License-Identifier: MIT
#include "host_min/scene/json_guard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "host_min/error.hpp"
#include "host_min/scene/extensions.hpp"
#include "host_min/scene/one_line.hpp"

namespace gno::host {

namespace {

using Json = nlohmann::json;
using Names = std::vector<std::string_view>;

constexpr int kDeepest = 64;  // glTF itself needs about 10; tinygltf recurses

bool isOneOf(const Names& names, std::string_view name) { return std::find(names.begin(), names.end(), name) != names.end(); }

void checkDepth(std::string_view text) {
    int depth = 0;
    bool inString = false;
    for (size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (inString) {
            if (c == '\\') ++i;
            if (c == '"') inString = false;
        } else if (c == '"') {
            inString = true;
        } else if (c == '{' || c == '[') {
            if (++depth > kDeepest) throw InputError(fmt::format("its JSON is nested more than {} levels deep", kDeepest));
        } else if (c == '}' || c == ']') {
            --depth;
        }
    }
}

void checkVersion(const Json& root) {
    const auto asset = root.find("asset");
    if (asset == root.end() || !asset->is_object()) throw InputError("not a glTF file: its JSON has no asset object");
    const auto version = asset->find("version");
    if (version == asset->end() || !version->is_string()) throw InputError("not a glTF file: its JSON has no asset.version");
    if (!version->get<std::string>().starts_with("2."))
        throw InputError(fmt::format("glTF version {} is not supported, only 2.0; convert the file", oneLine(version->get<std::string>())));
}

void checkWhole(const Json& value, std::string_view what) {
    if (value.is_number_unsigned() && value.get<uint64_t>() < (1ull << 31)) return;
    throw InputError(
        fmt::format("{} is {}, not a whole number in [0, 2^31)", what, oneLine(value.dump(-1, ' ', true, Json::error_handler_t::replace))));
}

void checkWholeMembers(const Json& object, std::string_view what) {
    if (!object.is_object()) throw InputError(fmt::format("{} is not an object", what));
    for (const auto& [key, value] : object.items()) checkWhole(value, fmt::format("{}.{}", what, oneLine(key)));
}

void checkNumbers(const Json& value, std::string_view what, size_t length) {
    const bool ok = value.is_array() && (length == 0 || value.size() == length) &&
                    std::all_of(value.begin(), value.end(), [](const Json& v) { return v.is_number(); });
    if (ok) return;
    if (length == 0) throw InputError(fmt::format("{} is not an array of numbers", what));
    throw InputError(fmt::format("{} is not an array of {} numbers", what, length));
}

void checkMember(std::string_view key, const Json& value) {
    static const Names whole{
        "buffer",   "bufferView", "byteLength", "byteOffset", "byteStride", "count",  "componentType",       "mesh",     "skin",  "camera",
        "material", "mode",       "sampler",    "node",       "input",      "output", "inverseBindMatrices", "skeleton", "scene", "light",
        "index",    "texCoord"};
    static const Names lists{"accessors", "animations", "buffers",    "bufferViews", "cameras", "channels", "lights",
                             "materials", "meshes",     "primitives", "samplers",    "scenes",  "skins"};
    if (isOneOf(whole, key)) checkWhole(value, key);
    if (key == "indices" && !value.is_object()) checkWhole(value, key);
    if (key == "visible" && !value.is_boolean()) throw InputError("KHR_node_visibility: visible is neither true nor false");
    if (key == "diffuseTexture" || key == "transmissionTexture") {  // tinygltf passes empty objects over
        if (!value.is_object()) throw InputError(fmt::format("{} is no object", key));
        if (!value.contains("index")) throw InputError(fmt::format("{} has no index", key));
    }
    if (key == "attributes") checkWholeMembers(value, key);
    if (key == "matrix") checkNumbers(value, key, 16);
    if (key == "rotation") checkNumbers(value, key, 4);
    if (key == "translation" || key == "scale" || key == "color") checkNumbers(value, key, 3);
    if (key == "weights") checkNumbers(value, key, 0);
    const bool isList = isOneOf(lists, key);
    if (!isList && key != "children" && key != "joints" && key != "nodes" && key != "targets") return;
    if (!value.is_array()) throw InputError(fmt::format("{} is not an array", key));
    for (const Json& entry : value) {
        if (key == "primitives" && (!entry.is_object() || !entry.contains("attributes"))) throw InputError("a mesh primitive has no attributes");
        if (key == "targets")
            checkWholeMembers(entry, key);
        else if (isList && !entry.is_object())
            throw InputError(fmt::format("{} holds something that is no object", key));
        else if (!isList && !(key == "nodes" && entry.is_object()))
            checkWhole(entry, key);
    }
}

// `met`: extensions that were taken out.
void pruneAndCheck(Json& value, std::set<std::string>& met) {
    if (value.is_array()) {
        for (Json& entry : value) pruneAndCheck(entry, met);
        return;
    }
    if (!value.is_object()) return;
    for (const char* key :
         {"extras", "normalTexture", "occlusionTexture", "emissiveTexture", "metallicRoughnessTexture", "specularGlossinessTexture", "min", "max"})
        value.erase(key);
    if (const auto extensions = value.find("extensions"); extensions != value.end()) {
        if (!extensions->is_object()) throw InputError("extensions is not an object");
        for (auto it = extensions->begin(); it != extensions->end();) {
            if (!isReadExtension(it.key())) met.insert(it.key());
            it = isReadExtension(it.key()) ? std::next(it) : extensions->erase(it);
        }
    }
    for (auto& [key, member] : value.items()) {
        if (isReadExtension(key) && !member.is_object()) throw InputError(fmt::format("{} is not an object", key));
        if (key == "KHR_texture_transform") continue;         // its scale and rotation are not a node's; Textures checks them
        if (key.ends_with("_meshopt_compression")) continue;  // its mode is not a primitive's; only that it is there matters
        checkMember(key, member);
        pruneAndCheck(member, met);
    }
}

}  // namespace

std::string guardJson(std::string_view text, Notices& notices, Json& lists) {
    checkDepth(text);
    Json root;
    try {
        root = Json::parse(text.begin(), text.end());
    } catch (const Json::exception& error) {
        throw InputError("its JSON is broken: " + oneLine(error.what()));
    }
    if (!root.is_object()) throw InputError("not a glTF file: its JSON is not an object");
    checkVersion(root);
    checkRequiredExtensions(root);
    // Top-level lists that tinygltf need not see; animations[].samplers is another thing and stays.
    lists = Json::object();
    for (const char* key : {"buffers", "images", "textures", "samplers"}) {
        const auto found = root.find(key);
        if (found == root.end()) continue;
        lists[key] = std::move(*found);
        root.erase(found);
    }
    std::set<std::string> met;
    pruneAndCheck(root, met);
    tellOfExtensions(root, met, notices);
    checkCompression(root, notices);
    resolvePointers(root, notices);
    return root.dump();
}

}  // namespace gno::host
