// SPDX-License-Identifier: MIT
// What a camera sees, and which casters front-face culling may drop because of it: one-sided faces, holes, meshes that the camera is in.
#include <gtest/gtest.h>

#include <algorithm>

#include "host_min/frame/inputs.hpp"
#include "scene_builder.hpp"
#include "tiny_png.hpp"
#include "validation/support/device_test.hpp"

namespace gno {
namespace {

using host::test::Builder;
using host::test::Json;

constexpr uint32_t kSize = 64;

/// A square [-1, 1]^2 in the plane z, facing +z, with texture coordinates; material -1: none.
void addSquare(Builder& builder, float z, int material) {
    const int positions = builder.positions({-1, -1, z, 1, -1, z, -1, 1, z, 1, 1, z}), uv = builder.floats({0, 0, 1, 0, 0, 1, 1, 1}, "VEC2", 2);
    Json primitive = {{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", uv}}}, {"indices", builder.u16({0, 1, 2, 2, 1, 3})}};
    if (material >= 0) primitive["material"] = material;
    builder.node({{"mesh", builder.mesh(primitive)}});
}

/// Looking along -z from `z`; a directional light that shines with the camera.
void addCamera(Builder& builder, double z, bool fromBehind = false, double znear = 0.01) {
    builder.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", znear}}}}};
    builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "directional"}}};
    Json node = {{"camera", 0}, {"translation", {0, 0, z}}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}};
    if (fromBehind) node["rotation"] = {0, 1, 0, 0};
    builder.node(node);
}

/// The left half of the picture lets everything through, the right one nothing.
int addHalf(Builder& builder, Json material) {
    const int view = builder.view(host::test::tinyPng(2, 1, std::string("\xFF\xFF\xFF\x00\xFF\xFF\xFF\xFF", 8)));
    builder.json["images"] = {{{"bufferView", view}, {"mimeType", "image/png"}}};
    builder.json["samplers"] = {{{"magFilter", 9728}}};
    builder.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
    material["pbrMetallicRoughness"] = {{"baseColorTexture", {{"index", 0}}}};
    return builder.add("materials", material);
}

struct Seen {
    uint64_t samples = 0;
    std::vector<uint64_t> of;  ///< view samples per caster
};

Seen seenBy(const Builder& builder) {
    const host::Frame frame = host::test::frameOf(builder);
    host::FrameInputs inputs(test::passes(), frame, kSize, kSize);
    inputs.setLight(frame.lights[0].homogeneous, host::Cull::none);
    Seen seen{inputs.sampleCount() + inputs.facingAwayCount(), std::vector<uint64_t>(frame.triangles.size(), 0)};
    for (const host::OracleSample& pixel : inputs.pixels())
        if (pixel.own < seen.of.size()) ++seen.of[pixel.own];
    return seen;
}

TEST(CameraSees, FrontsOfOneSidedFacesOnly) {
    for (const bool doubleSided : {false, true})
        for (const bool fromBehind : {false, true}) {
            Builder builder;
            builder.json["materials"] = {{{"doubleSided", doubleSided}}};
            addSquare(builder, 0, 0);
            addCamera(builder, fromBehind ? -3 : 3, fromBehind);
            const Seen seen = seenBy(builder);
            if (fromBehind && !doubleSided)
                EXPECT_EQ(seen.samples, 0u);
            else
                EXPECT_GT(seen.samples, kSize * kSize / 4u);
        }
    Builder mirrored;  // a mirrored node keeps its front
    addSquare(mirrored, 0, -1);
    mirrored.json["nodes"][0]["scale"] = {-1, 1, 1};
    addCamera(mirrored, 3);
    EXPECT_GT(seenBy(mirrored).samples, kSize * kSize / 4u);
}

TEST(CameraSees, ThroughHoles) {
    Builder whole;
    addSquare(whole, 0, -1);
    addCamera(whole, 3);
    const uint64_t all = seenBy(whole).samples;
    for (const char* mode : {"MASK", "BLEND"}) {
        SCOPED_TRACE(mode);
        Builder builder;
        addSquare(builder, 0, addHalf(builder, {{"alphaMode", mode}}));
        addCamera(builder, 3);
        EXPECT_EQ(seenBy(builder).samples, all / 2);
        addSquare(builder, -0.001f, -1);  // close behind: the picture is full again
        const Seen full = seenBy(builder);
        EXPECT_NEAR(double(full.samples), double(all), double(all) / 50);
        EXPECT_GT(full.of.at(2) + full.of.at(3), all * 2 / 5);
        EXPECT_GT(full.of.at(0) + full.of.at(1), all * 2 / 5);
    }
    Builder glass;  // transmission alone makes no hole
    glass.json["materials"] = {{{"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", 1}}}}}}};
    addSquare(glass, 0, 0);
    addCamera(glass, 3);
    EXPECT_EQ(seenBy(glass).samples, all);
}

/// A cube [0, 1]^3 on a floor, lit and seen obliquely from above (or from `eye`, looking along -z).
struct Cube : Builder {
    explicit Cube(glm::dvec3 eye, const Json& material = Json::object(), double znear = 0.01) {
        json["materials"] = {material};
        meshNode(host::test::kCube, host::test::kCubeIndices);
        json["meshes"][0]["primitives"][0]["material"] = 0;
        meshNode({-4, -0.5f, -4, -4, -0.5f, 4, 4, -0.5f, 4, 4, -0.5f, -4}, {0, 1, 2, 0, 2, 3});
        json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1.2}, {"znear", znear}}}}};
        json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
        node({{"camera", 0}, {"translation", {eye.x, eye.y, eye.z}}});
        node({{"translation", {0.3, 5, 0.4}}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    }
};

struct Culled {
    uint64_t casters = 0, wrong = 0;
    std::string leftWhole;
    std::vector<uint32_t> mask;
};

Culled shadeWith(const host::Frame& frame, host::Cull cull) {
    host::FrameInputs inputs(test::passes(), frame, kSize, kSize);
    inputs.setLight(frame.lights[0].homogeneous, cull);
    host::Technique& technique = host::techniqueByName("d-hybrid");
    host::StructureCache structures;
    const std::vector<std::string> none;
    Culled result{inputs.casterCount(), 0, inputs.leftWhole(), {}};
    result.mask =
        technique.run(inputs, structures, host::Settings(technique.info().settings, none), {host::Precision::certified, 1, false, false}).visibility;
    std::vector<host::OracleSample> samples;
    std::vector<uint32_t> got;
    for (size_t i = 0; i < result.mask.size(); ++i) {
        if (inputs.pixels()[i].own > GNO_NO_CASTER) continue;
        samples.push_back(inputs.pixels()[i]);
        got.push_back(result.mask[i]);
    }
    const host::OracleAnswer answer = host::makeOracle()->ask({frame.triangles, {}, inputs.light(), samples}, [](double) {});
    for (size_t i = 0; i < got.size(); ++i) result.wrong += got[i] != (answer.inShadow[i] ? GNO_VISIBILITY_SHADOW : GNO_VISIBILITY_LIT);
    return result;
}

TEST(FrontCull, DropsOnlyWhatNobodyMisses) {
    const Json glass = {{"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", 0.5}}}}}};
    const struct {
        const char* name;
        Cube cube;
        bool drops;
    } cases[] = {{"outside", Cube({0.5, 0.5, 3}), true},
                 {"inside", Cube({0.5, 0.5, 0.8}), false},
                 {"outside, its near plane cuts a face", Cube({0.5, 0.5, 1.4}, Json::object(), 0.5), false},
                 {"outside, its near plane ends before the face", Cube({0.5, 0.5, 1.4}, Json::object(), 0.3), true},
                 {"outside, its near plane lies inside", Cube({0.5, 0.5, 1.02}, Json::object(), 0.1), false},
                 {"glass", Cube({0.5, 0.5, 3}, glass), false},
                 {"alpha-tested", Cube({0.5, 0.5, 3}, {{"alphaMode", "MASK"}}), false}};
    for (const auto& each : cases) {
        SCOPED_TRACE(each.name);
        const host::Frame frame = host::test::frameOf(each.cube);
        const Culled whole = shadeWith(frame, host::Cull::none), culled = shadeWith(frame, host::Cull::front);
        EXPECT_EQ(whole.wrong, 0u);
        EXPECT_EQ(culled.wrong, 0u);
        EXPECT_EQ(culled.mask, whole.mask);
        EXPECT_EQ(culled.leftWhole.empty(), each.drops) << culled.leftWhole;
        EXPECT_EQ(culled.casters < whole.casters, each.drops);
    }
}

TEST(FrontCull, TheOracleFindsAnIllegalOne) {  // what the program no longer does: all faces that face the light are dropped, the camera is inside
    Cube cube({0.5, 0.5, 0.8});
    cube.json["materials"][0]["doubleSided"] = true;  // so that the inside is seen
    cube.json["nodes"][3]["translation"] = {0.4, 0.6, 3};
    const host::Frame frame = host::test::frameOf(cube);
    host::FrameInputs inputs(test::passes(), frame, kSize, kSize);
    inputs.setLight(frame.lights[0].homogeneous, host::Cull::none);
    std::vector<host::OracleSample> samples;
    for (const host::OracleSample& pixel : inputs.pixels())
        if (pixel.own <= GNO_NO_CASTER) samples.push_back(pixel);
    std::vector<uint8_t> kept(frame.triangles.size(), 1);
    for (size_t i = 0; i < 12; ++i) {
        const host::Triangle& t = frame.triangles[i];
        kept[i] = glm::dot(glm::cross(t.b - t.a, t.c - t.a), glm::vec3(frame.lights[0].homogeneous) - t.a) <= 0;
    }
    const auto ask = [&](std::span<const uint8_t> casters) {
        return host::makeOracle()->ask({frame.triangles, casters, inputs.light(), samples}, [](double) {}).inShadow;
    };
    EXPECT_GT(samples.size(), 100u);
    EXPECT_NE(ask(kept), ask({}));
}

}  // namespace
}  // namespace gno
