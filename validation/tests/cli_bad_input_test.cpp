// SPDX-License-Identifier: MIT
// Bad files and bad words: exit code 2, one line that says what is wrong, nothing in the output folder.
#include <limits>

#include "validation/tests/cli_child.hpp"
#include "validation/tests/tiny_png.hpp"

namespace gno::test {
namespace {

using host::test::Json;
using host::test::kTriangle;

std::string meshWith(const std::vector<float>& positions, const std::vector<uint16_t>& indices, size_t indexCount) {
    Builder builder;
    builder.meshNode(positions, indices);
    builder.json["accessors"][1]["count"] = indexCount;
    return builder.glb();
}

void expectBadFile(const std::string& name, const std::string& bytes, const std::string& part = {}) {
    const Stage stage;
    const std::string scene = stage.write(name, bytes);
    expectRefusal(stage, stage.shade({scene, "--size", "16x16"}), 2, part);
    const Outcome effects = stage.run({"effects", scene});
    expectRefusal(stage, effects, 2, part);
}

TEST(BadFile, Empty) { expectBadFile("empty.glb", ""); }
TEST(BadFile, Text) { expectBadFile("text.glb", "not a model\n"); }
TEST(BadFile, EmptyGltf) { expectBadFile("empty.gltf", ""); }
TEST(BadFile, HalfOfIt) {
    const std::string whole = smallScene().glb();
    expectBadFile("half.glb", whole.substr(0, whole.size() / 2));
}
TEST(BadFile, HalfOfAShippedOne) {
    const std::string whole = readFile(sceneFile("table_fan"));
    ASSERT_GT(whole.size(), 100000u);
    expectBadFile("half.glb", whole.substr(0, whole.size() / 2));
}
TEST(BadFile, AnotherMagic) { expectBadFile("magic.glb", "XXXX" + smallScene().glb().substr(4)); }
TEST(BadFile, UnfinishedJson) { expectBadFile("json.gltf", R"({"asset":{"version":"2.0"})"); }
TEST(BadFile, NoTriangles) {
    Builder builder;
    builder.json["scenes"][0]["nodes"] = Json::array();
    expectBadFile("no_triangles.glb", builder.glb(), "triangle");
}
TEST(BadFile, IndexPastTheEnd) { expectBadFile("index.glb", meshWith(kTriangle, {0, 1, 7}, 3)); }
TEST(BadFile, AccessorPastTheEnd) { expectBadFile("accessor.glb", meshWith(kTriangle, {0, 1, 2}, 3000000)); }
TEST(BadFile, NotANumber) { expectBadFile("nan.glb", meshWith({std::numeric_limits<float>::quiet_NaN(), 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2}, 3)); }
TEST(BadFile, Infinite) { expectBadFile("infinite.glb", meshWith({std::numeric_limits<float>::infinity(), 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2}, 3)); }
TEST(BadFile, NeedsDraco) {
    Builder builder = smallScene();
    builder.json["extensionsRequired"] = builder.json["extensionsUsed"] = {"KHR_draco_mesh_compression"};
    expectBadFile("draco.glb", builder.glb(), "KHR_draco_mesh_compression");
}
/// One triangle of a leaf: masked, with this image.
Builder leaf(const std::string& png) {
    Builder builder = smallScene();
    builder.json["materials"] = {{{"alphaMode", "MASK"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    builder.json["textures"] = {{{"source", 0}}};
    const int view = builder.view(png);
    builder.json["images"] = {{{"bufferView", view}, {"mimeType", "image/png"}}};
    const size_t vertices = builder.json["accessors"][builder.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"].get<size_t>()]["count"];
    const int uv = builder.floats(std::vector<float>(2 * vertices, 0.25f), "VEC2", 2);
    auto& primitive = builder.json["meshes"][0]["primitives"][0];
    primitive["material"] = 0;
    primitive["attributes"]["TEXCOORD_0"] = uv;
    return builder;
}
TEST(BadFile, ATruncatedImage) {
    const std::string png = host::test::tinyPng(2, 2, std::string(16, '\x7F'));
    const Stage stage;
    EXPECT_EQ(stage.run({"effects", stage.write("leaf.glb", leaf(png).glb())}).code, 0) << "a whole one is read";
    expectBadFile("truncated.glb", leaf(png.substr(0, png.size() / 2)).glb(), "image 0");
}
TEST(BadFile, NoImageThere) {
    Builder builder = leaf("");
    builder.json["images"] = {{{"uri", "absent.png"}}};
    expectBadFile("image.glb", builder.glb(), "absent.png");
}
TEST(BadFile, TooFewTextureCoordinates) {
    Builder builder = leaf(host::test::tinyPng(1, 1, "leaf"));
    const int uv = builder.floats({0, 0}, "VEC2", 2);
    builder.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = uv;
    expectBadFile("coordinates.glb", builder.glb(), "TEXCOORD_0");
}
TEST(BadFile, NoArea) {
    Builder builder;
    builder.meshNode({0, 0, 0, 1, 1, 1, 2, 2, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0});
    expectBadFile("flat.glb", builder.glb(), "area");
}
TEST(BadFile, ANameWithALineEndInIt) { expectBadFile("two\nlines.glb", "not a model\n"); }

struct Words {
    std::string name;
    std::vector<std::string> words;
    std::string part;  ///< what the line must hold
};

const std::vector<Words> kWrongWords{
    {"UnknownTechnique", {"--technique", "psvv"}, "psvv"},
    {"PlannedTechnique", {"--technique", "zpass"}, "not in this build yet"},
    {"NoTechnique", {"--technique", ","}, "--technique"},
    {"UnknownPrecision", {"--precision", "exact-ish"}, "exact-ish"},
    {"UnknownKey", {"--technique", "d-hybrid", "--set", "stakc=12"}, "stack"},
    {"UnknownKeyOfAuto", {"--set", "stakc=12"}, "stack"},
    {"KeyOfAnother", {"--technique", "d-stackless", "--set", "stack=12"}, "seed"},
    {"BadValue", {"--technique", "d-hybrid", "--set", "stack=many"}, "1..64"},
    {"ShadowMapTooSmall", {"--technique", "shadow-map", "--precision", "published", "--set", "map=511"}, "512..8192"},
    {"ShadowMapTooLarge", {"--technique", "shadow-map", "--precision", "published", "--set", "map=8193"}, "512..8192"},
    {"ShadowMapFit", {"--technique", "shadow-map", "--precision", "published", "--set", "fit=tight"}, "uniform|focused"},
    {"ShadowMapFaces", {"--technique", "shadow-map", "--precision", "published", "--set", "faces=none"}, "both|back|front"},
    {"ShadowMapBias", {"--technique", "shadow-map", "--precision", "published", "--set", "bias=-0.5"}, "0.0..64.0"},
    {"ShadowMapCannotBeCertified", {"--technique", "shadow-map"}, "no precision certified"},
    {"ForestCells", {"--technique", "forest", "--set", "cells=3"}, "1|4|8"},
    {"ForestPoolTooSmall",
     {"--technique", "forest", "--set", "pool=1", "--size", "32x32", "--dump", "--json", "record.jsonl"},
     "pairs of cell and caster"},
    {"ForestCannotBePublished", {"--technique", "forest", "--precision", "published"}, "no precision published"},
    {"LightGridNest", {"--technique", "light-grid", "--set", "nest=1000001"}, "0..1000000"},
    {"LightGridPoolTooSmall",
     {"--technique", "light-grid", "--set", "pool=1", "--size", "32x32", "--dump", "--json", "record.jsonl"},
     "pairs of cell and caster"},
    {"LightGridCannotBePublished", {"--technique", "light-grid", "--precision", "published"}, "no precision published"},
    {"KeyTwice", {"--set", "seed=1", "--set", "seed=2"}, "twice"},
    {"NoValue", {"--set", "seed"}, "KEY=VALUE"},
    {"SizeZero", {"--size", "0x0"}, "at least 1"},
    {"SizeWords", {"--size", "big"}, "WIDTHxHEIGHT"},
    {"SizeOverTheLimit", {"--size", "100000x100000"}, "limit"},
    {"NegativeSize", {"--size", "-4x4"}, "--size"},
    {"UnknownOption", {"--frobnicate"}, "--frobnicate"},
    {"SecondScene", {"second.glb"}, "second.glb"},
    {"LightOutOfRange", {"--light", "99"}, "99"},
    {"CameraOutOfRange", {"--camera", "99"}, "99"},
    {"NegativeLight", {"--light", "-1"}, "--light"},
    {"TraceWords", {"--dump", "--trace", "here"}, "write X,Y"},
    {"TraceOutside", {"--size", "16x16", "--dump", "--trace", "16,0"}, "0 to 15"},
    {"TraceWithoutDump", {"--trace", "1,1"}, "--dump"},
    {"FrameWords", {"--frame", "first"}, "--frame"},
    {"FramesBackwards", {"--frame", "2..1"}, "before"},
    {"FramesWithoutEnd", {"--frame", "0.."}, "--frame 0..: write A or A..B"},
    {"AnimationOfAFileWithout", {"--animation", "Walk"}, "--animation Walk: the file has no animations"},
    {"KeyOfSetAsAnOption", {"--cull", "front"}, "write --set cull=front"},
    {"KeyOfSetWithASign", {"--stack=3"}, "write --set stack=3"},
    {"KeyOfSetWithoutValue", {"--cull"}, "write --set cull=VALUE"},
    {"ControlCharacters", {"--camera", "a\x1b[2Jb"}, "--camera a\\x1B[2Jb:"},
    {"RepeatZero", {"--repeat", "0"}, "--repeat"},
    {"OptionWithoutValue", {"--size"}, "--size"},
};

class WrongWords : public testing::TestWithParam<Words> {};

TEST_P(WrongWords, AreRefused) {
    const Stage stage;
    std::vector<std::string> arguments{stage.write("scene.glb", smallScene().glb())};
    const bool last = GetParam().name == "OptionWithoutValue";
    std::vector<std::string> words = GetParam().words;
    if (last) {
        arguments.insert(arguments.begin(), "shade");
        arguments.insert(arguments.end(), words.begin(), words.end());
        expectRefusal(stage, stage.run(arguments), 2, GetParam().part);
    } else {
        arguments.insert(arguments.end(), words.begin(), words.end());
        expectRefusal(stage, stage.shade(arguments), 2, GetParam().part);
    }
}

INSTANTIATE_TEST_SUITE_P(Shade, WrongWords, testing::ValuesIn(kWrongWords), [](const auto& parameter) { return parameter.param.name; });

TEST(BadPath, Scene) {
    const Stage stage;
    expectRefusal(stage, stage.shade({(stage.path() / "absent.glb").string()}), 2, "absent.glb");
    expectRefusal(stage, stage.shade({stage.path().string()}), 2);
    expectRefusal(stage, stage.shade({""}), 2);
    expectRefusal(stage, stage.run({"effects", (stage.path() / "absent.glb").string()}), 2, "absent.glb");
}

TEST(TooMany, WorkGroups) {
    const Stage stage;
    std::vector<float> grid;  // 70 000 triangles: more than Vulkan's 65 535 work groups of one
    for (int i = 0; i < 70000; ++i) {
        const float x = float(i % 300), y = float(i / 300);
        grid.insert(grid.end(), {x, y, 0, x + 0.5f, y, 0, x, y + 0.5f, 0});
    }
    Builder builder;
    builder.meshNode(grid);
    expectRefusal(stage, stage.shade({stage.write("grid.glb", builder.glb()), "--size", "16x16", "--technique", "d-stackless", "--set", "group=1"}),
                  2, "use at least 2");
}

TEST(BadCommand, Words) {
    const Stage stage;
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{}, {"shadow"}, {"shade"}, {"effects"}, {"device", "--fast"}, {""}})
        expectRefusal(stage, stage.run(words), 2, "--help");
}

}  // namespace
}  // namespace gno::test
