// SPDX-License-Identifier: MIT
// What other programs write: URIs in all their forms, extensions that are not read, compressed data with and without a copy. Nothing is passed over
// in silence.
#include <gtest/gtest.h>

#include <functional>

#include "host_min/scene/notices.hpp"
#include "host_min/scene/one_line.hpp"
#include "host_min/scene/uri.hpp"
#include "scene_builder.hpp"

namespace gno::host::test {
namespace {

/// A file of text and buffer 0 with this URI, or a GLB where there is none.
SceneFile withUri(const TemporaryFolder& folder, const Builder& builder, const std::string& uri) {
    Json json = builder.json;
    json["buffers"] = {{{"byteLength", builder.binary.size()}, {"uri", uri}}};
    return SceneFile::load(folder.write("scene.gltf", json.dump()));
}

Builder triangle() {
    Builder builder;
    builder.meshNode(kTriangle);
    return builder;
}

std::string percentEncoded(const std::string& bytes) {
    constexpr const char* kDigits = "0123456789abcdef";
    std::string text;
    for (const char c : bytes) text += {'%', kDigits[static_cast<unsigned char>(c) >> 4], kDigits[static_cast<unsigned char>(c) & 15]};
    return text;
}

TEST(Uris, NameFilesAsRfc3986Has) {
    const Builder builder = triangle();
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path() / "deep er");
    for (const auto& [file, uri] :
         std::vector<std::pair<std::string, std::string>>{{"plain.bin", "plain.bin"},
                                                          {"a+b.bin", "a+b.bin"},
                                                          {"a b.bin", "a%20b.bin"},
                                                          {"c d.bin", "c d.bin"},
                                                          {"100%.bin", "100%.bin"},
                                                          {"50%25.bin", "50%25.bin"},  // a name with what looks like an escape
                                                          {"e%41.bin", "e%2541.bin"},
                                                          {"\xC3\xBC.bin", "%C3%bc.bin"},
                                                          {"f.bin", "f.bin?version=2"},
                                                          {"g#1.bin", "g#1.bin"},
                                                          {"deep er/h.bin", "./deep%20er/h.bin"},
                                                          {"C:i.bin", "C:i.bin"}}) {
        folder.write(file, builder.binary);
        EXPECT_EQ(inputError([&] { (void)withUri(folder, builder, uri); }), "") << uri;
        std::filesystem::remove(folder.path() / file);
        EXPECT_NE(inputError([&] { (void)withUri(folder, builder, uri); }).find("(" + uri + ")"), std::string::npos) << "named as written";
    }
}

TEST(Uris, HoldDataInAnyForm) {
    const Builder builder = triangle();
    const TemporaryFolder folder;
    const std::string base64 = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
    for (const std::string& uri :
         {"data:application/octet-stream;base64," + base64, "data:application/octet-stream;charset=utf-8;base64," + base64, "data:;base64," + base64,
          "data:application/gltf-buffer;name=\"a;b\";BASE64," + base64, "DATA:Application/Octet-Stream;Base64," + base64,
          "data:model/anything;base64 ," + base64.substr(0, 20) + "%0A " + base64.substr(20),
          "data:application/octet-stream," + percentEncoded(builder.binary), "data:," + percentEncoded(builder.binary)}) {
        const Frame frame = withUri(folder, builder, uri).evaluate(0, 0);
        ASSERT_EQ(frame.triangles.size(), 1u) << uri;
        EXPECT_NEAR(world(frame, 0).b.x, 1, 1e-5) << uri;
    }
}

TEST(Uris, Base64OfEveryLength) {
    const auto bytes = [](const std::string& uri) {
        const auto read = dataUriBytes(uri);
        return read ? std::string(read->begin(), read->end()) : std::string("none");
    };
    EXPECT_EQ(bytes("data:;base64,"), "");
    EXPECT_EQ(bytes("data:;base64,Zg=="), "f");
    EXPECT_EQ(bytes("data:;base64,Zg"), "f");
    EXPECT_EQ(bytes("data:;base64,Zm8="), "fo");
    EXPECT_EQ(bytes("data:;base64,Zm8%3D"), "fo");
    EXPECT_EQ(bytes("data:;base64,Zm9v"), "foo");
    EXPECT_EQ(bytes("data:;base64,+/+/"), "\xFB\xFF\xBF");
    EXPECT_EQ(bytes("data:,a+b%20c%zz"), "a+b c%zz");
    EXPECT_EQ(bytes("dat:,a"), "none");
    EXPECT_EQ(bytes("data.bin"), "none");
    for (const char* wrong : {"data:;base64,Z", "data:;base64,Zg=", "data:;base64,Zg===", "data:;base64,Zm9v=", "data:;base64,Zm9v====",
                              "data:;base64,Z-9v", "data:;base64", "data:"})
        EXPECT_NE(inputError([&] { (void)dataUriBytes(wrong); }), "") << wrong;
}

TEST(OneLine, ShowsNoRawBytes) {
    EXPECT_EQ(oneLine("a\nb\tc\rd"), "a\\nb\\tc\\rd");
    EXPECT_EQ(oneLine("\x1B[31mred\x7F"), "\\x1B[31mred\\x7F");
    EXPECT_EQ(oneLine("gr\xC3\xBC\xC3\x9F\xE2\x82\xAC\xF0\x9F\x98\x80"), "gr\xC3\xBC\xC3\x9F\xE2\x82\xAC\xF0\x9F\x98\x80");
    EXPECT_EQ(oneLine("\xC3(\xFF\xC0\x8A\xED\xA0\x80\xF5\x80\x80\x80"), "\\xC3(\\xFF\\xC0\\x8A\\xED\\xA0\\x80\\xF5\\x80\\x80\\x80");
    EXPECT_EQ(oneLine("\xC2\x9B"
                      "31m \xE2\x80\xAE"),
              "\\xC2\\x9B31m \\xE2\\x80\\xAE")
        << "another way to begin an escape, and writing turned round";
    EXPECT_EQ(oneLine("\xE2\x82"), "\\xE2\\x82") << "a character cut in half";
    EXPECT_EQ(oneLine(std::string(300, 'x')), std::string(200, 'x') + "...");
    EXPECT_EQ(oneLine("blanks  "), "blanks");
    EXPECT_EQ(counted(1, "triangle"), "1 triangle");
    EXPECT_EQ(counted(0, "triangle"), "0 triangles");
}

TEST(Notice, OfASubjectIsGivenOnce) {
    Notices notices;
    EXPECT_TRUE(notices.add("one: first"));
    EXPECT_FALSE(notices.add("one: second"));
    EXPECT_TRUE(notices.add("two"));
    EXPECT_EQ(notices.lines(), (std::vector<std::string>{"one: first", "two"}));
    for (int i = 0; i < 100; ++i) notices.add("subject " + std::to_string(i) + ": told");
    EXPECT_EQ(notices.lines().size(), Notices::kMost + 1);
    EXPECT_EQ(notices.lines().back(), "more of this kind: 70 lines left out");
    EXPECT_EQ(enumerated({{0, "a"}, {2, ""}, {5, "b"}}), "0 (a), 2, 5 (b)");
    EXPECT_EQ(enumerated({{0, ""}, {1, ""}, {2, ""}, {3, ""}, {4, ""}, {5, ""}}), "0, 1, 2, 3 and 2 more");
}

TEST(Extensions, ThatAreNotReadAreTold) {
    Builder builder = triangle();
    builder.json["extensionsRequired"] = {"KHR_texture_transform", "KHR_mesh_quantization", "EXT_texture_webp"};
    builder.json["extensionsUsed"] = {"EXT_texture_webp", "KHR_materials_unlit", "KHR_node_visibility", "KHR_lights_punctual",
                                      "VENDOR_\x1B"
                                      "odd"};
    builder.json["nodes"][0]["extensions"]["MSFT_lod"] = {{"ids", {0}}};  // named nowhere
    const Frame frame = frameOf(builder);
    EXPECT_EQ(noticeOf(frame, "extension EXT_texture_webp"), "not read; it concerns materials, textures or metadata");
    EXPECT_EQ(noticeOf(frame, "extension KHR_materials_unlit"), "not read; it concerns materials, textures or metadata");
    EXPECT_EQ(noticeOf(frame, "extension VENDOR_\\x1Bodd"), "not read, gnomon does not know it");
    EXPECT_EQ(noticeOf(frame, "extension MSFT_lod"), "not read, gnomon does not know it");
    size_t count = 0;
    for (const std::string& notice : frame.facts.notices) count += notice.starts_with("extension ");
    EXPECT_EQ(count, 4u) << "once each, and none of those that are read";
    for (const Json& wrong : {Json(7), Json({7})}) {
        builder.json["extensionsUsed"] = wrong;
        EXPECT_NE(inputError([&] { (void)frameOf(builder); }).find("extensionsUsed"), std::string::npos);
    }
}

/// A triangle whose positions are in a placeholder (buffer 1), compressed into the first bytes of buffer 0.
struct Compressed : Builder {
    explicit Compressed(const char* name = "EXT_meshopt_compression") {
        meshNode(kTriangle);
        json["bufferViews"][0] = {{"buffer", 1}, {"byteLength", 36}, {"extensions", {{name, source}}}};
        json["buffers"] = {{{"byteLength", binary.size()}}, {{"byteLength", 36}, {"extensions", {{name, {{"fallback", true}}}}}}};
        json["extensionsUsed"] = {name};
    }
    Json source{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", 36}, {"byteStride", 12}, {"mode", "ATTRIBUTES"}, {"count", 3}};
    [[nodiscard]] std::string bytes() const { return glbOf(json.dump(), binary); }
    [[nodiscard]] std::string refusal() const {
        return inputError([&] { (void)loadBytes(bytes()); });
    }
};

TEST(Meshopt, WithoutACopyIsRefusedByName) {
    for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
        const Compressed file(name);
        EXPECT_NE(file.refusal().find(std::string("buffer view 0 has its data in ") + name + " alone"), std::string::npos) << file.refusal();
    }
    Compressed first;  // a placeholder in the place of the GLB's own buffer
    first.json["bufferViews"][0]["buffer"] = 0;
    std::swap(first.json["buffers"][0], first.json["buffers"][1]);
    EXPECT_NE(first.refusal().find("EXT_meshopt_compression alone"), std::string::npos) << first.refusal();
    Compressed same;  // no placeholder at all: the view names the compressed bytes
    same.json["bufferViews"][0]["buffer"] = 0;
    EXPECT_NE(same.refusal().find("EXT_meshopt_compression alone"), std::string::npos) << same.refusal();
    Compressed unmarked;
    unmarked.json["buffers"][1].erase("extensions");
    EXPECT_NE(unmarked.refusal().find("EXT_meshopt_compression alone"), std::string::npos) << unmarked.refusal();
    Compressed wrong;
    wrong.json["buffers"][1]["extensions"]["EXT_meshopt_compression"]["fallback"] = 1;
    EXPECT_EQ(wrong.refusal().find("fallback is neither"), std::string::npos) << "of the first buffer alone it matters";
    wrong.json["buffers"][0]["extensions"]["EXT_meshopt_compression"]["fallback"] = 1;
    EXPECT_NE(wrong.refusal().find("fallback is neither true nor false"), std::string::npos) << wrong.refusal();
}

TEST(Meshopt, WithACopyIsReadAndTold) {
    Compressed file;
    file.json["buffers"][1]["uri"] = "data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
    const Frame frame = loadBytes(file.bytes()).evaluate(0, 0);
    EXPECT_NEAR(world(frame, 0).c.y, 1, 1e-5);
    EXPECT_EQ(noticeOf(frame, "extension EXT_meshopt_compression"), "data are read where the file has an uncompressed copy");
    Compressed unneeded;  // what nobody reads may be compressed
    const int real = unneeded.view(bytesOf(kTriangle));
    unneeded.json["buffers"][0]["byteLength"] = unneeded.binary.size();
    unneeded.json["accessors"][0]["bufferView"] = real;
    const int normals = unneeded.accessor(0, kF32, 3, "VEC3");
    unneeded.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = normals;
    EXPECT_EQ(unneeded.refusal(), "");
}

/// A triangle with a Draco stream beside its accessors.
Builder dracoFile() {
    Builder builder;
    builder.meshNode(kTriangle, {0, 1, 2});
    const int stream = builder.view("DRACO");
    builder.json["extensionsUsed"] = {"KHR_draco_mesh_compression"};
    builder.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", stream},
                                                                                              {"attributes", {{"POSITION", 0}}}};
    return builder;
}

TEST(Draco, WithoutACopyIsRefusedByName) {
    for (const int accessor : {0, 1}) {  // positions, indices
        Builder builder = dracoFile();
        builder.json["accessors"][accessor].erase("bufferView");
        const std::string text = inputError([&] { (void)frameOf(builder); });
        EXPECT_NE(text.find("mesh 0 primitive 0 has its data in KHR_draco_mesh_compression alone"), std::string::npos) << text;
    }
}

TEST(Draco, WithACopyIsReadAndTold) {
    Builder builder = dracoFile();
    builder.json["accessors"].push_back({{"componentType", kF32}, {"count", 3}, {"type", "VEC3"}});
    builder.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = 2;
    const Frame frame = frameOf(builder);
    EXPECT_EQ(frame.triangles.size(), 1u);
    EXPECT_EQ(noticeOf(frame, "extension KHR_draco_mesh_compression"), "the file's uncompressed copy is read");
    builder.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = 7;
    EXPECT_NE(inputError([&] { (void)frameOf(builder); }).find("is not an object"), std::string::npos);
}

TEST(Told, WhatStandsInForWhatTheSceneLacks) {
    Builder builder = triangle();
    const Frame bare = frameOf(builder);
    EXPECT_EQ(noticeOf(bare, "lights"),
              "the scene has none; made two: light 0, a point light above on the right, and light 1, directional from the upper left");
    EXPECT_EQ(noticeOf(bare, "camera"), "the scene has none; made one that sees all of it");
    EXPECT_EQ(bare.facts.notices.size(), 2u);
    builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
    builder.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
    const int node = builder.node({{"camera", 0}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}}, false);
    builder.json["scenes"].push_back({{"nodes", {node}}});
    const Frame another = frameOf(builder);
    EXPECT_TRUE(noticeOf(another, "lights").starts_with("the scene has none (the file has 1 that stand in no shown part of it); made two"));
    EXPECT_TRUE(noticeOf(another, "camera").starts_with("the scene has none (the file has 1 that"));
    EXPECT_EQ(noticeOf(another, "scenes"), "scene 0 of 2 is shown, counted from 0");
    builder.json["scenes"][0]["nodes"].push_back(node);
    EXPECT_EQ(noticeOf(frameOf(builder), "lights"), "");
    EXPECT_EQ(noticeOf(frameOf(builder), "camera"), "");
}

TEST(Told, WhatOfLightsIsNotUsed) {
    Builder builder = triangle();
    builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}, {"range", 5}, {"name", "lamp"}},
                                                                   {{"type", "spot"}, {"spot", {{"outerConeAngle", 0.5}}}, {"intensity", 3}},
                                                                   {{"type", "directional"}, {"name", "sun"}}};
    const auto place = [&](int light, Json more) {
        more["extensions"]["KHR_lights_punctual"]["light"] = light;
        return builder.node(more);
    };
    place(0, Json::object());
    place(1, {{"name", "torch"}});
    const int sun = place(2, Json::object());
    place(0, {{"translation", {1, 1, 1}}});
    const Frame frame = frameOf(builder);
    EXPECT_EQ(noticeOf(frame, "range of lights 0 (lamp), 3 (lamp)"), "not used, the light reaches as far as the scene");
    EXPECT_EQ(noticeOf(frame, "cone of light 1 (torch)"), "not used in mask and picture, which are those of a point light");
    EXPECT_EQ(noticeOf(frame, "intensity of light 1 (torch)"), "not used, pictures show every light equally bright");
    EXPECT_EQ(noticeOf(frame, "direction of light 2 (sun)"), "");
    builder.json["nodes"][sun]["scale"] = {0, 0, 0};
    EXPECT_EQ(noticeOf(frameOf(builder), "direction of light 2 (sun)"), "its node has a scale of 0, so it has none; taken for one along -z");
}

TEST(Told, WhatOfMeshesIsLeftOut) {
    Builder builder = triangle();
    builder.meshNode({0, 0, 0, 1, 1, 1, 2, 2, 2});
    builder.meshNode(kTriangle);
    builder.json["meshes"][2]["primitives"][0]["mode"] = 1;
    builder.node({{"mesh", builder.mesh({{"attributes", {{"NORMAL", 0}}}})}});
    const Frame frame = frameOf(builder);
    EXPECT_EQ(noticeOf(frame, "triangles without area on the grid"), "1 of 2, neither seen nor casting");
    EXPECT_EQ(noticeOf(frame, "points and lines"), "1 primitive, not drawn and casting nothing");
    EXPECT_EQ(noticeOf(frame, "primitives without POSITION"), "1, left out");
}

}  // namespace
}  // namespace gno::host::test
