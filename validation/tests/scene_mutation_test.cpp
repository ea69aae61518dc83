// SPDX-License-Identifier: MIT
// Small valid files, broken at random: each mutant loads and evaluates, or is an InputError of one line. Nothing else may happen; run it with
// sanitizers (-DGNOMON_SANITIZE=ON) to see that nothing else does. GNOMON_SEED and GNOMON_MUTANTS repeat or lengthen a run.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "scene_builder.hpp"
#include "tiny_png.hpp"

namespace gno::host::test {
namespace {

uint64_t setting(const char* name, uint64_t otherwise) {
    const char* text = std::getenv(name);
    return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

Builder plainFile() {
    Builder builder;
    builder.json["materials"] = {
        {{"name", "m"}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 1}}, {"baseColorTexture", {{"index", 0}}}}}}};
    builder.json["textures"] = {{{"source", 0}}};
    builder.json["images"] = {{{"bufferView", 0}, {"mimeType", "image/png"}}};
    builder.meshNode(kCube, kCubeIndices, {{"scale", {2, 3, 4}}});
    builder.json["meshes"][0]["primitives"][0]["material"] = 0;
    return builder;
}

Builder quantizedFile() {
    Builder builder;
    builder.json["extensionsRequired"] = {"KHR_mesh_quantization", "EXT_mesh_gpu_instancing"};
    std::vector<int16_t> positions;
    for (size_t i = 0; i < kCube.size(); ++i) {
        positions.push_back(static_cast<int16_t>(kCube[i] * 1000));
        if (i % 3 == 2) positions.push_back(0);
    }
    const int sparseAt = builder.view(bytesOf(std::vector<uint8_t>{7})), sparseValue = builder.view(bytesOf(std::vector<int16_t>{2000, 2000, 2000}));
    const int position = builder.accessor(
        builder.view(bytesOf(positions), 8), kI16, 8, "VEC3",
        {{"normalized", true},
         {"sparse", {{"count", 1}, {"indices", {{"bufferView", sparseAt}, {"componentType", kU8}}}, {"values", {{"bufferView", sparseValue}}}}}});
    const int indices = builder.u16(kCubeIndices);
    const int translations = builder.positions({0, 0, 0, 5, 0, 0, 0, 5, 0});
    builder.node({{"mesh", builder.mesh({{"attributes", {{"POSITION", position}}}, {"indices", indices}})},
                  {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", translations}}}}}}}});
    builder.node({{"mesh", builder.mesh({{"attributes", {{"POSITION", position}}}, {"mode", 5}})}});
    return builder;
}

Builder animatedFile() {
    Builder builder;
    builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}},
                                                                   {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.2}}}}};
    builder.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}, {"zfar", 100}}}},
                               {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0.1}, {"zfar", 100}}}}};
    builder.meshNode(kCube, kCubeIndices);
    builder.node({{"camera", 0}, {"translation", {0, 0, 9}}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}}, false);
    builder.node({{"camera", 1}, {"children", {1}}, {"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}});
    builder.json["nodes"][0]["extensions"]["KHR_node_visibility"] = {{"visible", true}};
    const int input = builder.floats({0, 1}, "SCALAR", 1), move = builder.positions({0, 0, 0, 1, 2, 3}),
              turn = builder.floats({0, 0, 0, 1, 0, 1, 0, 0}, "VEC4", 4);
    const int cubic = builder.positions(std::vector<float>(18, 0.5f)), shown = builder.accessor(builder.view("\1\2"), kU8, 2, "SCALAR");
    const auto pointing = [](const char* pointer) {
        return Json{{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", pointer}}}}}};
    };
    builder.json["animations"] = {{{"samplers",
                                    {{{"input", input}, {"output", move}},
                                     {{"input", input}, {"output", turn}},
                                     {{"input", input}, {"output", cubic}, {"interpolation", "CUBICSPLINE"}},
                                     {{"input", input}, {"output", shown}, {"interpolation", "STEP"}}}},
                                   {"channels",
                                    {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}},
                                     {{"sampler", 1}, {"target", {{"node", 2}, {"path", "rotation"}}}},
                                     {{"sampler", 2}, {"target", {{"node", 2}, {"path", "scale"}}}},
                                     {{"sampler", 1}, {"target", pointing("/nodes/0/rotation")}},
                                     {{"sampler", 3}, {"target", pointing("/nodes/0/extensions/KHR_node_visibility/visible")}}}}}};
    return builder;
}

Builder skinnedFile() {
    Builder builder;
    builder.meshNode(kCube, kCubeIndices, {{"skin", 0}});
    auto& primitive = builder.json["meshes"][0]["primitives"][0];
    const int joints = builder.accessor(
        builder.view(bytesOf(std::vector<uint8_t>{0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0})),
        kU8, 8, "VEC4");
    const int weights = builder.floats(std::vector<float>(32, 0.25f), "VEC4", 4);
    const int target = builder.positions(std::vector<float>(24, 0.125f));
    primitive["attributes"].update({{"JOINTS_0", joints}, {"WEIGHTS_0", weights}});
    primitive["targets"] = {{{"POSITION", target}}};
    builder.json["meshes"][0]["weights"] = {0.5};
    const int base = builder.node({{"children", {2}}}), tip = builder.node({{"translation", {0, 1, 0}}}, false);
    std::vector<float> inverse;
    for (int j = 0; j < 2; ++j) inverse.insert(inverse.end(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    const int matrices = builder.floats(inverse, "MAT4", 16);
    builder.add("skins", {{"joints", {base, tip}}, {"inverseBindMatrices", matrices}, {"skeleton", base}});
    const int input = builder.floats({0, 1}, "SCALAR", 1), output = builder.floats({0, 1}, "SCALAR", 1);
    builder.json["animations"] = {{{"samplers", {{{"input", input}, {"output", output}, {"interpolation", "STEP"}}}},
                                   {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}}}}};
    return builder;
}

Builder leafyFile() {
    Builder builder;
    builder.json["materials"] = {
        {{"alphaMode", "MASK"},
         {"pbrMetallicRoughness",
          {{"baseColorTexture",
            {{"index", 0}, {"texCoord", 1}, {"extensions", {{"KHR_texture_transform", {{"offset", {0.5, 0.5}}, {"scale", {2, 2}}}}}}}}}},
         {"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", 0.5}, {"transmissionTexture", {{"index", 0}, {"texCoord", 1}}}}}}}}};
    builder.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
    builder.json["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}}};
    const int image = builder.view(tinyPng(4, 4, std::string(64, '\x5A')));
    builder.json["images"] = {{{"bufferView", image}, {"mimeType", "image/png"}}};
    builder.meshNode(kCube, kCubeIndices);
    auto& primitive = builder.json["meshes"][0]["primitives"][0];
    const int uv = builder.floats(std::vector<float>{0, 0, 1, 0, 0, 1, 1, 1, 0, 0, 1, 0, 0, 1, 1, 1}, "VEC2", 2);
    const int colours = builder.floats(std::vector<float>(32, 0.75f), "VEC4", 4);
    primitive["attributes"].update({{"TEXCOORD_1", uv}, {"COLOR_0", colours}});
    primitive["material"] = 0;
    return builder;
}

// Positions and indices with a compressed copy each that is not needed, and a material of the older kind.
Builder compressedFile() {
    Builder builder;
    builder.meshNode(kCube, kCubeIndices);
    builder.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = {{"buffer", 1},      {"byteOffset", 0},      {"byteLength", 8},
                                                                               {"byteStride", 12}, {"mode", "ATTRIBUTES"}, {"count", 8}};
    auto& primitive = builder.json["meshes"][0]["primitives"][0];
    primitive["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 1}, {"attributes", {{"POSITION", 0}}}};
    const int image = builder.view(tinyPng(2, 2, std::string(16, '\x5A'))), uv = builder.floats(std::vector<float>(16, 0.5f), "VEC2", 2);
    primitive["attributes"]["TEXCOORD_0"] = uv;
    primitive["material"] = 0;
    builder.json["materials"] = {
        {{"alphaMode", "BLEND"},
         {"extensions",
          {{"KHR_materials_pbrSpecularGlossiness",
            {{"diffuseFactor", {1, 1, 1, 0.5}},
             {"diffuseTexture", {{"index", 0}, {"texCoord", 0}, {"extensions", {{"KHR_texture_transform", {{"scale", {2, 2}}}}}}}}}}}}}};
    builder.json["textures"] = {{{"source", 0}}};
    builder.json["images"] = {{{"bufferView", image}}};
    builder.json["buffers"] = {{{"byteLength", builder.binary.size()}},
                               {{"byteLength", 8}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
    return builder;
}

std::string base64(std::string bytes) {
    const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const size_t padding = (3 - bytes.size() % 3) % 3;
    bytes.append(padding, '\0');
    std::string text;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        const auto at = [&](size_t k) { return static_cast<unsigned>(static_cast<unsigned char>(bytes[i + k])); };
        const unsigned group = at(0) << 16 | at(1) << 8 | at(2);
        for (int shift = 18; shift >= 0; shift -= 6) text.push_back(digits[group >> shift & 63]);
    }
    text.replace(text.size() - padding, padding, padding, '=');
    return text;
}

class Mutator {
public:
    explicit Mutator(uint64_t seed) : random_(seed) {}

    std::string mutant(const Builder& from, std::string& what) {
        Builder builder = from;
        if (builder.json.count("buffers") == 0) builder.json["buffers"] = {{{"byteLength", builder.binary.size()}}};
        std::string text = builder.json.dump();
        switch (below(9)) {
            case 8:
                what = "text file with base64";
                builder.json["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(builder.binary);
                return flipped(builder.json.dump());
            case 0:
                what = "bytes of the JSON";
                return glbOf(flipped(text), builder.binary);
            case 1:
                what = "bytes of the binary";
                return glbOf(text, flipped(builder.binary));
            case 2:
                what = "truncated";
                text = glbOf(text, builder.binary);
                return text.substr(0, below(text.size()));
            case 3: {
                what = "chunk length";
                std::string bytes = glbOf(text, builder.binary);
                const size_t places[]{8, 12, 20 + (text.size() + 3) / 4 * 4};
                return bytes.replace(places[below(3)], 4, word(below(2) ? random_() : below(bytes.size() * 2)));
            }
            case 4:
                what = "floats of the binary";
                return glbOf(text, strangeFloats(builder.binary));
            case 5:
                what = "two numbers and bytes";
                changeNumbers(builder.json, 2);
                return glbOf(builder.json.dump(), flipped(builder.binary));
            case 6:
                what = "a member gone or replaced";
                changeMember(builder.json);
                return glbOf(builder.json.dump(), builder.binary);
            default:
                what = "numbers";
                changeNumbers(builder.json, 1 + below(3));
                return glbOf(builder.json.dump(), builder.binary);
        }
    }

private:
    size_t below(size_t end) { return random_() % end; }

    std::string flipped(std::string bytes) {
        for (size_t i = 0, count = 1 + below(4); i < count && !bytes.empty(); ++i) bytes[below(bytes.size())] ^= static_cast<char>(1 << below(8));
        return bytes;
    }
    std::string strangeFloats(std::string bytes) {
        const float strange[]{NAN, INFINITY, -INFINITY, 3e38f, -3e38f, 1e-45f, -0.0f, 1e30f, 1.5e20f};
        for (size_t i = 0, count = 1 + below(3); i < count; ++i) std::memcpy(bytes.data() + below(bytes.size() / 4) * 4, &strange[below(9)], 4);
        return bytes;
    }
    void collect(Json& value, std::vector<Json*>& numbers, std::vector<Json*>& containers) {
        if (value.is_number()) numbers.push_back(&value);
        if (!value.is_structured()) return;
        if (!value.empty()) containers.push_back(&value);
        for (Json& entry : value) collect(entry, numbers, containers);
    }
    Json strange() {
        const Json values[]{-1,
                            0,
                            1,
                            2,
                            7,
                            255,
                            65535,
                            65536,
                            1 << 24,
                            2147483647,
                            -2147483648ll,
                            4294967295ll,
                            4294967296ll,
                            9223372036854775807ll,
                            18446744073709551615ull,
                            1e300,
                            -1e300,
                            1e-300,
                            0.5,
                            1e30,
                            3e9,
                            "text",
                            nullptr,
                            true,
                            Json::array(),
                            Json::object(),
                            5120,
                            5126,
                            5130};
        return values[below(std::size(values))];
    }
    void changeNumbers(Json& json, size_t count) {
        std::vector<Json*> numbers, containers;
        collect(json, numbers, containers);
        for (size_t i = 0; i < count; ++i) *numbers[below(numbers.size())] = strange();
    }
    void changeMember(Json& json) {
        std::vector<Json*> numbers, containers;
        collect(json, numbers, containers);
        Json& container = *containers[below(containers.size())];
        auto member = container.begin();
        std::advance(member, static_cast<long>(below(container.size())));
        if (below(2))
            container.erase(member);
        else
            *member = strange();
    }

    std::mt19937_64 random_;
};

TEST(Mutation, LoadsOrIsRefusedInOneLine) {
    const uint64_t seed = setting("GNOMON_SEED", 20250131), mutants = setting("GNOMON_MUTANTS", 1600);
    std::printf("seed %llu, %llu mutants\n", static_cast<unsigned long long>(seed), static_cast<unsigned long long>(mutants));
    const Builder files[]{plainFile(), quantizedFile(), animatedFile(), skinnedFile(), leafyFile(), compressedFile()};
    const TemporaryFolder folder;
    Mutator mutator(seed);
    uint64_t loaded = 0, refused = 0;
    for (const Builder& file : files) ASSERT_GT(frameOf(file, 7).triangles.size(), 0u);
    for (uint64_t i = 0; i < mutants; ++i) {
        std::string what;
        const auto path = folder.write("mutant.glb", mutator.mutant(files[i % std::size(files)], what));
        try {
            const SceneFile scene = SceneFile::load(path);
            for (const uint32_t frame : {0u, 7u, 1000u}) {
                const Frame got = scene.evaluate(frame, scene.cameraCount() - 1);
                ASSERT_EQ(got.closed.size(), got.triangles.size());
                for (const Triangle& t : got.triangles)
                    for (const glm::vec3& p : {t.a, t.b, t.c}) ASSERT_TRUE(std::abs(p.x) <= 1 && std::abs(p.y) <= 1 && std::abs(p.z) <= 1);
                for (const Light& light : got.lights) ASSERT_TRUE(std::isfinite(glm::dot(light.homogeneous, light.homogeneous)));
                ASSERT_TRUE(std::isfinite(got.camera.clipFromGrid(1)[3][2]));
            }
            ++loaded;
        } catch (const InputError& error) {
            const std::string text = error.what();
            ASSERT_EQ(text.find('\n'), std::string::npos) << text;
            ASSERT_NE(text.find("mutant.glb: "), std::string::npos) << text;
            ++refused;
        } catch (const std::exception& error) {
            FAIL() << "mutant " << i << " (" << what << "): " << error.what();
        }
    }
    std::printf("%llu loaded, %llu refused\n", static_cast<unsigned long long>(loaded), static_cast<unsigned long long>(refused));
    EXPECT_GT(loaded, mutants / 20);  // a loader that refuses everything proves nothing
    EXPECT_GT(refused, mutants / 20);
}

}  // namespace
}  // namespace gno::host::test
