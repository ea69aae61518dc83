// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "scene_builder.hpp"

namespace gno::host::test {
namespace {

void expectNear(glm::dvec3 got, glm::dvec3 want, double tolerance = 1e-6) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(got[axis], want[axis], tolerance) << "axis " << axis;
}

void expectTriangle(const Frame& frame, size_t index, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
    ASSERT_LT(index, frame.triangles.size());
    const WorldTriangle t = world(frame, index);
    expectNear(t.a, a);
    expectNear(t.b, b);
    expectNear(t.c, c);
}

const glm::dvec3 kA(0, 0, 0), kB(1, 0, 0), kC(0, 1, 0);

TEST(Geometry, PlainTriangle) {
    Builder builder;
    builder.meshNode(kTriangle);
    const Frame frame = frameOf(builder);
    expectTriangle(frame, 0, kA, kB, kC);
    EXPECT_EQ(frame.triangles.size(), 1u);
    EXPECT_EQ(frame.material, std::vector<uint32_t>{0});
    EXPECT_EQ(frame.object, std::vector<uint32_t>{0});
    EXPECT_EQ(frame.closed, std::vector<uint8_t>{0});
    EXPECT_EQ(frame.facts.trianglesInFile, 1u);
    EXPECT_EQ(frame.facts.objects, 1u);
    expectNear(frame.grid.world(frame.low), kA);
    expectNear(frame.grid.world(frame.high), {1, 1, 0});
}

TEST(Geometry, IndexTypes) {
    for (const int type : {kU8, kU16, kU32}) {
        Builder builder;
        const std::string indices = type == kU8    ? bytesOf(std::vector<uint8_t>{2, 0, 1})
                                    : type == kU16 ? bytesOf(std::vector<uint16_t>{2, 0, 1})
                                                   : bytesOf(std::vector<uint32_t>{2, 0, 1});
        const int accessor = builder.accessor(builder.view(indices), type, 3, "SCALAR");
        builder.node({{"mesh", builder.mesh({{"attributes", {{"POSITION", builder.positions(kTriangle)}}}, {"indices", accessor}})}});
        expectTriangle(frameOf(builder), 0, kC, kA, kB);
    }
}

TEST(Geometry, InterleavedWithOffsets) {
    Builder builder;
    std::vector<float> rows;
    for (size_t v = 0; v < 3; ++v) {
        rows.insert(rows.end(), {9.f, 9.f});  // something else first
        rows.insert(rows.end(), kTriangle.begin() + static_cast<long>(v * 3), kTriangle.begin() + static_cast<long>(v * 3 + 3));
    }
    const int position = builder.accessor(builder.view(bytesOf(rows), 20), kF32, 3, "VEC3", {{"byteOffset", 8}});
    builder.node({{"mesh", builder.mesh({{"attributes", {{"POSITION", position}}}})}});
    expectTriangle(frameOf(builder), 0, kA, kB, kC);
}

TEST(Geometry, QuantizedPositions) {
    struct Case {
        int type;
        bool normalized;
        double one;  // what 100 means
    };
    for (const Case& c : {Case{kI8, false, 100}, Case{kI8, true, 100 / 127.0}, Case{kU8, true, 100 / 255.0}, Case{kI16, false, 100},
                          Case{kI16, true, 100 / 32767.0}, Case{kU16, true, 100 / 65535.0}}) {
        Builder builder;
        builder.json["extensionsRequired"] = builder.json["extensionsUsed"] = {"KHR_mesh_quantization"};
        const bool isByte = c.type == kI8 || c.type == kU8;
        const std::vector<int> raw{0, 0, 0, 0, 100, 0, 0, 0, 0, 100, 0, 0};  // padded to a stride of four components
        const std::string bytes =
            isByte ? bytesOf(std::vector<int8_t>(raw.begin(), raw.end())) : bytesOf(std::vector<int16_t>(raw.begin(), raw.end()));
        const int position = builder.accessor(builder.view(bytes, isByte ? 4 : 8), c.type, 3, "VEC3", {{"normalized", c.normalized}});
        builder.node({{"mesh", builder.mesh({{"attributes", {{"POSITION", position}}}})}});
        const WorldTriangle t = world(frameOf(builder), 0);
        EXPECT_NEAR(t.b.x, c.one, c.one * 1e-6) << c.type << c.normalized;
        EXPECT_NEAR(t.c.y, c.one, c.one * 1e-6) << c.type << c.normalized;
    }
}

TEST(Geometry, SparsePositions) {
    for (const bool hasBase : {true, false}) {
        Builder builder;
        const int indices = builder.view(bytesOf(std::vector<uint16_t>{1, 2}));
        const int values = builder.view(bytesOf(std::vector<float>{5, 0, 0, 0, 7, 0}));
        const int base = builder.view(bytesOf(kTriangle));
        const int position = builder.accessor(
            base, kF32, 3, "VEC3",
            {{"sparse", {{"count", 2}, {"indices", {{"bufferView", indices}, {"componentType", kU16}}}, {"values", {{"bufferView", values}}}}}});
        if (!hasBase) builder.json["accessors"][position].erase("bufferView");
        builder.node({{"mesh", builder.mesh({{"attributes", {{"POSITION", position}}}})}});
        expectTriangle(frameOf(builder), 0, kA, {5, 0, 0}, {0, 7, 0});
    }
}

TEST(Geometry, StripsAndFansKeepTheirWinding) {
    // A zigzag over the unit square in the plane z = 0; every triangle of a strip has to face +z.
    Builder strip;
    strip.node(
        {{"mesh", strip.mesh({{"attributes", {{"POSITION", strip.positions({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0})}}}, {"mode", 5}})}});
    const Frame strips = frameOf(strip);
    ASSERT_EQ(strips.triangles.size(), 3u);
    Builder fan;
    fan.node({{"mesh", fan.mesh({{"attributes", {{"POSITION", fan.positions({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0})}}}, {"mode", 6}})}});
    const Frame fans = frameOf(fan);
    ASSERT_EQ(fans.triangles.size(), 2u);
    for (const Frame* frame : {&strips, &fans})
        for (const Triangle& t : frame->triangles) EXPECT_GT(glm::cross(t.b - t.a, t.c - t.a).z, 0);
    expectTriangle(strips, 1, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
    expectTriangle(fans, 1, kA, {1, 1, 0}, {0, 1, 0});
}

TEST(Geometry, PointsAndLinesAreCountedOnly) {
    Builder builder;
    builder.meshNode(kTriangle);
    for (const int mode : {0, 1, 2, 3})
        builder.node({{"mesh", builder.mesh({{"attributes", {{"POSITION", builder.positions(kTriangle)}}}, {"mode", mode}})}});
    const Frame frame = frameOf(builder);
    EXPECT_EQ(frame.triangles.size(), 1u);
    EXPECT_EQ(frame.facts.pointOrLinePrimitives, 4u);
}

TEST(Geometry, HierarchyMultipliesMatrices) {
    Builder builder;
    builder.meshNode(kTriangle, {}, {{"scale", {2, 3, 1}}});
    builder.json["scenes"][0]["nodes"] = {2};
    builder.node({{"children", {0}}, {"rotation", {0, 0, std::sqrt(0.5), std::sqrt(0.5)}}}, false);  // a quarter turn about z
    builder.node({{"children", {1}}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 10, 20, 30, 1}}}, false);
    expectTriangle(frameOf(builder), 0, {10, 20, 30}, {10, 22, 30}, {7, 20, 30});
}

TEST(Geometry, NegativeDeterminantFlipsWinding) {
    Builder builder;
    builder.meshNode(kTriangle, {}, {{"scale", {-1, 1, 1}}});
    const Frame frame = frameOf(builder);
    expectTriangle(frame, 0, kA, kC, {-1, 0, 0});
    EXPECT_GT(glm::cross(frame.triangles[0].b - frame.triangles[0].a, frame.triangles[0].c - frame.triangles[0].a).z, 0);
}

TEST(Geometry, OnlyTheDefaultSceneIsDrawn) {
    Builder builder;
    builder.meshNode(kTriangle);
    builder.meshNode(kCube, kCubeIndices);
    builder.json["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1}}}};
    builder.json["scene"] = 1;
    EXPECT_EQ(frameOf(builder).triangles.size(), 12u);
    builder.json.erase("scene");
    EXPECT_EQ(frameOf(builder).triangles.size(), 1u);
    builder.json.erase("scenes");
    EXPECT_EQ(frameOf(builder).triangles.size(), 13u);
}

TEST(Geometry, GpuInstancing) {
    Builder builder;
    builder.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    const int translation = builder.positions({0, 0, 0, 10, 0, 0});
    const int scale = builder.positions({1, 1, 1, 2, 2, 2});
    builder.meshNode(kTriangle, {},
                     {{"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", translation}, {"SCALE", scale}}}}}}}});
    const Frame frame = frameOf(builder);
    EXPECT_EQ(frame.object, (std::vector<uint32_t>{0, 1}));
    expectTriangle(frame, 0, kA, kB, kC);
    expectTriangle(frame, 1, {10, 0, 0}, {12, 0, 0}, {10, 2, 0});
}

TEST(Geometry, MaterialsAndTheDefaultOne) {
    Builder builder;
    builder.json["materials"] = {
        {{"name", "glass"}, {"alphaMode", "BLEND"}, {"doubleSided", true}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 0.5, 0, 1}}}}},
        {{"alphaCutoff", 0.25}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}},
        {{"alphaMode", "MASK"}}};
    builder.json["textures"] = {{{"source", 0}}};
    builder.json["images"] = {{{"uri", "is not there.png"}}};
    builder.meshNode(kTriangle);
    builder.json["meshes"][0]["primitives"].push_back(builder.json["meshes"][0]["primitives"][0]);
    builder.json["meshes"][0]["primitives"][1]["material"] = 1;
    const SceneFile scene = loadBytes(builder.glb());
    ASSERT_EQ(scene.materials().size(), 4u);
    EXPECT_EQ(scene.materials()[0].name, "glass");
    EXPECT_EQ(scene.materials()[0].alpha, Material::Alpha::blend);
    EXPECT_TRUE(scene.materials()[0].doubleSided);
    EXPECT_EQ(scene.materials()[0].baseColor, glm::vec4(1, 0.5, 0, 1));
    EXPECT_FALSE(scene.materials()[0].textured);
    EXPECT_EQ(scene.materials()[1].alpha, Material::Alpha::opaque);
    EXPECT_EQ(scene.materials()[1].alphaCutoff, 0.25f);
    EXPECT_TRUE(scene.materials()[1].textured);
    EXPECT_EQ(scene.materials()[2].alpha, Material::Alpha::mask);
    EXPECT_EQ(scene.evaluate(0, 0).material, (std::vector<uint32_t>{3, 1}));
}

TEST(Geometry, TextFilesWithDataAndExternalBuffers) {
    Builder builder;
    builder.meshNode(kTriangle);
    const TemporaryFolder folder;
    folder.write("my buffer.bin", builder.binary);
    builder.json["buffers"] = {{{"byteLength", builder.binary.size()}, {"uri", "my%20buffer.bin"}}};
    expectTriangle(SceneFile::load(folder.write("external.gltf", builder.json.dump(2))).evaluate(0, 0), 0, kA, kB, kC);

    // 36 bytes of kTriangle in base64
    builder.json["buffers"][0]["uri"] = "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
    expectTriangle(loadBytes(builder.json.dump(), "data.gltf").evaluate(0, 0), 0, kA, kB, kC);
}

// Near 2^24 these coordinates are still exact in double, so the scene far away has to be the same bit by bit.
TEST(Geometry, FarFromTheOriginNothingChanges) {
    const double far = 1 << 23;
    Builder near, away;
    for (Builder* builder : {&near, &away}) {
        builder->meshNode(kCube, kCubeIndices, {{"scale", {0.375, 0.75, 1.125}}});
        builder->meshNode({0.1f, 0.2f, 0.3f, 1.7f, 0.4f, 0.5f, -0.6f, 2.5f, 0.8f});
        builder->json["scenes"][0]["nodes"] = {2};
    }
    near.node({{"children", {0, 1}}}, false);
    away.node({{"children", {0, 1}}, {"translation", {far, -far, 2 * far}}}, false);
    const Frame one = frameOf(near), other = frameOf(away);
    ASSERT_EQ(one.triangles.size(), other.triangles.size());
    EXPECT_EQ(one.grid.exponent, other.grid.exponent);
    EXPECT_EQ(other.grid.origin - one.grid.origin, glm::dvec3(far, -far, 2 * far));
    for (size_t i = 0; i < one.triangles.size(); ++i) {
        EXPECT_EQ(one.triangles[i].a, other.triangles[i].a);
        EXPECT_EQ(one.triangles[i].b, other.triangles[i].b);
        EXPECT_EQ(one.triangles[i].c, other.triangles[i].c);
    }
}

TEST(Geometry, ExtremeScalesGiveTheSameGridPositions) {
    Builder plain;
    plain.meshNode(kCube, kCubeIndices);
    const Frame want = frameOf(plain);
    for (const int power : {-100, -14, 23, 90}) {
        Builder builder;
        const double size = std::ldexp(1.0, power);
        builder.meshNode(kCube, kCubeIndices, {{"scale", {size, size, size}}});
        const Frame got = frameOf(builder);
        EXPECT_EQ(got.grid.exponent, want.grid.exponent + power);
        ASSERT_EQ(got.triangles.size(), want.triangles.size());
        for (size_t i = 0; i < want.triangles.size(); ++i) EXPECT_EQ(got.triangles[i].a, want.triangles[i].a);
    }
}

TEST(Geometry, EvaluatingTwiceGivesTheSame) {
    Builder builder;
    builder.meshNode(kCube, kCubeIndices);
    const SceneFile scene = loadBytes(builder.glb());
    const Frame one = scene.evaluate(0, 0), other = scene.evaluate(5, 0);
    ASSERT_EQ(one.triangles.size(), other.triangles.size());
    for (size_t i = 0; i < one.triangles.size(); ++i) EXPECT_EQ(one.triangles[i].c, other.triangles[i].c);
    EXPECT_EQ(scene.lastKeyframe(), 0.0);
}

}  // namespace
}  // namespace gno::host::test
