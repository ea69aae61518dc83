// SPDX-License-Identifier: MIT
#include <tiny_gltf.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>
#include <system_error>

#include "host_min/error.hpp"
#include "scenes/generator/glb.hpp"

namespace gno::scenes {
namespace {

std::vector<double> list(const glm::dvec3& v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }

std::vector<double> list(const glm::dquat& q) {
    return {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z), static_cast<float>(q.w)};
}

/// Appends arrays to buffer 0, each with a view and an accessor of its own.
class Encoder {
public:
    tinygltf::Model file;

    Encoder() { file.buffers.emplace_back(); }

    int addView(const void* bytes, size_t length, int target) {
        auto& data = file.buffers[0].data;
        while (data.size() % 4 != 0) data.push_back(0);
        tinygltf::BufferView view;
        view.buffer = 0;
        view.byteOffset = data.size();
        view.byteLength = length;
        view.target = target;
        const auto* first = static_cast<const unsigned char*>(bytes);
        data.insert(data.end(), first, first + length);
        file.bufferViews.push_back(view);
        return static_cast<int>(file.bufferViews.size()) - 1;
    }

    template <class T>
    int add(const std::vector<T>& values, int componentType, int type, size_t components, int target) {
        tinygltf::Accessor accessor;
        accessor.bufferView = addView(values.data(), values.size() * sizeof(T), target);
        accessor.componentType = componentType;
        accessor.type = type;
        accessor.count = values.size() / components;
        file.accessors.push_back(accessor);
        return static_cast<int>(file.accessors.size()) - 1;
    }

    int addFloats(const std::vector<float>& values, int type, size_t components, int target, bool bounds) {
        const int index = add(values, TINYGLTF_COMPONENT_TYPE_FLOAT, type, components, target);
        if (!bounds) return index;
        std::vector<double> low(components, std::numeric_limits<double>::infinity());
        std::vector<double> high(components, -std::numeric_limits<double>::infinity());
        for (size_t i = 0; i < values.size(); ++i) {
            low[i % components] = std::min<double>(low[i % components], values[i]);
            high[i % components] = std::max<double>(high[i % components], values[i]);
        }
        file.accessors.back().minValues = low;
        file.accessors.back().maxValues = high;
        return index;
    }

    tinygltf::Primitive primitive(const Part& part) {
        tinygltf::Primitive primitive;
        primitive.mode = TINYGLTF_MODE_TRIANGLES;
        primitive.material = static_cast<int>(part.material);
        std::vector<float> floats;
        for (const glm::vec3& p : part.mesh.positions) floats.insert(floats.end(), {p.x, p.y, p.z});
        primitive.attributes["POSITION"] = addFloats(floats, TINYGLTF_TYPE_VEC3, 3, TINYGLTF_TARGET_ARRAY_BUFFER, true);
        if (!part.mesh.uv.empty()) {
            floats.clear();
            for (const glm::vec2& uv : part.mesh.uv) floats.insert(floats.end(), {uv.x, uv.y});
            primitive.attributes["TEXCOORD_0"] = addFloats(floats, TINYGLTF_TYPE_VEC2, 2, TINYGLTF_TARGET_ARRAY_BUFFER, false);
        }
        const std::vector<uint32_t>& wide = part.mesh.indices;
        if (part.mesh.positions.size() < 65535) {
            std::vector<uint16_t> narrow;
            for (const uint32_t i : wide) narrow.push_back(static_cast<uint16_t>(i));
            primitive.indices = add(narrow, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_SCALAR, 1, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
        } else {
            primitive.indices = add(wide, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR, 1, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
        }
        return primitive;
    }

    void addTexture(const Texture& from) {
        const std::string png = encodePng(from);
        tinygltf::Image image;
        image.mimeType = "image/png";
        image.bufferView = addView(png.data(), png.size(), 0);
        file.images.push_back(image);
        tinygltf::Sampler sampler;
        sampler.magFilter = from.nearest ? TINYGLTF_TEXTURE_FILTER_NEAREST : TINYGLTF_TEXTURE_FILTER_LINEAR;
        sampler.wrapS = sampler.wrapT = from.wrap;
        file.samplers.push_back(sampler);
        tinygltf::Texture texture;
        texture.source = texture.sampler = static_cast<int>(file.images.size()) - 1;
        file.textures.push_back(texture);
    }

    void addMaterial(const Material& from) {
        tinygltf::Material out;
        out.name = from.name;
        std::vector<double> color = list(from.color);
        color.push_back(static_cast<float>(from.opacity));
        out.pbrMetallicRoughness.baseColorFactor = color;
        out.pbrMetallicRoughness.baseColorTexture.index = from.texture;
        out.pbrMetallicRoughness.metallicFactor = 0;
        if (!from.alphaMode.empty()) out.alphaMode = from.alphaMode;
        out.doubleSided = from.doubleSided || !from.alphaMode.empty();
        if (from.alphaMode == "MASK") out.alphaCutoff = static_cast<float>(from.cutoff);
        if (from.transmission > 0) {
            out.extensions["KHR_materials_transmission"] = tinygltf::Value(
                tinygltf::Value::Object{{"transmissionFactor", tinygltf::Value(static_cast<double>(static_cast<float>(from.transmission)))}});
            const std::string name = "KHR_materials_transmission";
            if (std::find(file.extensionsUsed.begin(), file.extensionsUsed.end(), name) == file.extensionsUsed.end())
                file.extensionsUsed.push_back(name);
        }
        file.materials.push_back(out);
    }

    void addChannel(tinygltf::Animation& animation, const Track& track, const char* path, int times, int values) {
        tinygltf::AnimationSampler sampler;
        sampler.input = times;
        sampler.output = values;
        sampler.interpolation = "LINEAR";
        animation.samplers.push_back(sampler);
        tinygltf::AnimationChannel channel;
        channel.sampler = static_cast<int>(animation.samplers.size()) - 1;
        channel.target_node = track.node;
        channel.target_path = path;
        animation.channels.push_back(channel);
    }

    void addAnimation(const Draft& draft) {
        std::vector<float> times;
        for (int i = 0; i < kFrames; ++i) times.push_back(static_cast<float>(i / 30.0));
        const int input = addFloats(times, TINYGLTF_TYPE_SCALAR, 1, 0, true);
        tinygltf::Animation animation;
        animation.name = "show";
        for (const Track& track : draft.tracks) {
            std::vector<float> moves;
            std::vector<float> turns;
            for (const Pose& pose : track.poses) {
                for (const double v : list(pose.translation)) moves.push_back(static_cast<float>(v));
                for (const double v : list(pose.rotation)) turns.push_back(static_cast<float>(v));
            }
            if (track.moves) addChannel(animation, track, "translation", input, addFloats(moves, TINYGLTF_TYPE_VEC3, 3, 0, false));
            if (track.turns) addChannel(animation, track, "rotation", input, addFloats(turns, TINYGLTF_TYPE_VEC4, 4, 0, false));
        }
        file.animations.push_back(animation);
    }
};

void addLights(tinygltf::Model& file, const Draft& draft) {
    for (const Light& light : draft.lights) {
        tinygltf::Light out;
        out.type = light.type;
        out.name = light.type;
        out.color = list(light.color);
        out.intensity = light.intensity;
        if (light.type == "spot") {
            out.spot.innerConeAngle = light.inner;
            out.spot.outerConeAngle = light.outer;
        }
        file.lights.push_back(out);
    }
}

void addNodes(tinygltf::Model& file, const Draft& draft) {
    tinygltf::Scene scene;
    for (const Node& node : draft.nodes) {
        tinygltf::Node out;
        out.name = node.name;
        if (node.translation != glm::dvec3(0)) out.translation = list(node.translation);
        if (node.rotation != glm::dquat(1, 0, 0, 0)) out.rotation = list(node.rotation);
        if (node.scale != glm::dvec3(1)) out.scale = list(node.scale);
        out.mesh = node.model;
        if (node.camera) out.camera = 0;
        if (node.light >= 0)
            out.extensions["KHR_lights_punctual"] = tinygltf::Value(tinygltf::Value::Object{{"light", tinygltf::Value(node.light)}});
        const int index = static_cast<int>(file.nodes.size());
        if (node.parent < 0)
            scene.nodes.push_back(index);
        else
            file.nodes[static_cast<size_t>(node.parent)].children.push_back(index);
        file.nodes.push_back(out);
    }
    file.scenes.push_back(scene);
    file.defaultScene = 0;
}

}  // namespace

std::string encodeGlb(const Draft& draft, const std::string& name) {
    Encoder encoder;
    tinygltf::Model& file = encoder.file;
    file.asset.version = "2.0";
    file.asset.generator = "gnomon-scenes " + name;
    for (const Texture& texture : draft.textures) encoder.addTexture(texture);
    for (const Material& material : draft.materials) encoder.addMaterial(material);
    for (const Model& model : draft.models) {
        tinygltf::Mesh mesh;
        mesh.name = model.name;
        for (const Part& part : model.parts) mesh.primitives.push_back(encoder.primitive(part));
        file.meshes.push_back(mesh);
    }
    tinygltf::Camera camera;
    camera.type = "perspective";
    camera.name = "camera";
    camera.perspective.yfov = draft.yfov;
    camera.perspective.znear = draft.znear;
    file.cameras.push_back(camera);
    addLights(file, draft);
    addNodes(file, draft);
    encoder.addAnimation(draft);
    std::ostringstream stream;
    tinygltf::TinyGLTF writer;
    if (!writer.WriteGltfSceneToStream(&file, stream, false, true)) throw host::WorkError("tinygltf could not encode the scene " + name);
    return stream.str();
}

void writeFile(const std::filesystem::path& path, const std::string& bytes) {
    std::filesystem::path beside = path;
    beside += ".part";
    std::error_code error;
    if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
    {
        std::ofstream file(beside, std::ios::binary | std::ios::trunc);
        file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        file.close();
        if (!file) {
            std::filesystem::remove(beside, error);
            throw host::WorkError("cannot write " + beside.string() + ": check the folder and the free space");
        }
    }
    std::filesystem::rename(beside, path, error);
    if (error) {
        const std::string reason = error.message();
        std::filesystem::remove(beside, error);
        throw host::WorkError("cannot rename " + beside.string() + " to " + path.string() + ": " + reason);
    }
}

}  // namespace gno::scenes
