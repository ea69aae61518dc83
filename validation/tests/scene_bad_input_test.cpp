// SPDX-License-Identifier: MIT
// Every bad file is an InputError of one line that names the file and says what is wrong.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "scene_builder.hpp"

namespace gno::host::test {
namespace {

void expectError(const std::string& text, const std::string& name, const std::string& words) {
    EXPECT_NE(text.find(words), std::string::npos) << "wanted: " << words << "\ngot: " << text;
    EXPECT_NE(text.find(name), std::string::npos) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
}

void expectBytesRefused(const std::string& bytes, const std::string& words, const std::string& name = "bad.glb") {
    expectError(inputError([&] { (void)loadBytes(bytes, name).evaluate(0, 0); }), name, words);
}

// A good scene with everything in it, spoilt by `spoil`.
void expectRefused(const std::string& words, const std::function<void(Builder&)>& spoil) {
    Builder builder;
    builder.meshNode(kTriangle, {0, 1, 2});
    ASSERT_EQ(frameOf(builder).triangles.size(), 1u);
    spoil(builder);
    SCOPED_TRACE(builder.json.dump());
    expectBytesRefused(builder.glb(), words);
}

std::string goodGlb() {
    Builder builder;
    builder.meshNode(kTriangle, {0, 1, 2});
    return builder.glb();
}

TEST(BadFile, OuterForm) {
    const std::string good = goodGlb();
    expectBytesRefused("", "is empty");
    expectBytesRefused("not a model\n", "not a glTF file");
    expectBytesRefused("XXXX" + good.substr(4), "not a glTF file");
    expectBytesRefused("glTF", "truncated");
    expectBytesRefused("{\"asset\":{\"version\":\"2.0\"", "JSON is broken", "bad.gltf");
    expectBytesRefused("[1, 2]", "not a glTF file", "bad.gltf");
    expectBytesRefused("{}", "no asset", "bad.gltf");
    expectBytesRefused(R"({"asset": {"version": "1.0"}})", "glTF version 1.0", "bad.gltf");
    expectBytesRefused(word(0x46546C67) + word(1) + good.substr(8), "GLB version 1");
    expectBytesRefused(std::string(1, '{') + std::string(100000, '['), "nested", "bad.gltf");
    expectBytesRefused("{\"asset\": {\"version\": \"2.0\"}, \"extras\": " + std::string(100000, '[') + std::string(100000, ']') + "}", "nested",
                       "bad.gltf");
    for (size_t length = 0; length < good.size(); ++length) EXPECT_NE(inputError([&] { (void)loadBytes(good.substr(0, length)); }), "") << length;
}

TEST(BadFile, Paths) {
    const TemporaryFolder folder;
    expectError(inputError([&] { (void)SceneFile::load(folder.path() / "absent.glb"); }), "absent.glb", "no such file");
    expectError(inputError([&] { (void)SceneFile::load(folder.path()); }), folder.path().filename(), "is a folder");
    expectError(inputError([&] { (void)SceneFile::load("/dev/null"); }), "/dev/null", "not a regular file");
    const auto locked = folder.write("locked.glb", goodGlb());
    std::filesystem::permissions(locked, std::filesystem::perms::none);
    if (geteuid() != 0) {  // root may read everything
        expectError(inputError([&] { (void)SceneFile::load(locked); }), "locked.glb", "cannot be opened");
    }
}

TEST(BadFile, ChunkLengths) {
    const std::string good = goodGlb();
    for (const size_t offset : {8, 12}) {
        for (const size_t value : {0xFFFFFFFFull, 0x7FFFFFFFull, 1ull << 20}) {
            std::string bad = good;
            bad.replace(offset, 4, word(value));
            EXPECT_NE(inputError([&] { (void)loadBytes(bad); }), "") << offset << " " << value;
        }
    }
    std::string noJson = good;
    noJson.replace(16, 4, word(0x004E4942));
    expectBytesRefused(noJson, "first GLB chunk");
}

TEST(BadBuffer, ExternalOnes) {
    Builder builder;
    builder.meshNode(kTriangle);
    const auto refuse = [&](const std::string& uri, size_t length, const std::string& words) {
        builder.json["buffers"] = {{{"byteLength", length}, {"uri", uri}}};
        expectBytesRefused(builder.json.dump(), words, "bad.gltf");
    };
    refuse("absent.bin", 36, "buffer 0 (absent.bin): no such file beside the model");
    refuse("absent%20one+two.bin", 36, "(absent%20one+two.bin)");
    refuse("data:application/octet-stream;base64,AAAA", 36, "byteLength is 36, its data have 3 bytes");
    refuse("/dev/zero", 36, "not a path beside the model");
    refuse("", 36, "not a path beside the model");
    refuse("a%00b.bin", 36, "zero byte");
    refuse("https://example.org/a.bin", 36, "nothing else");
    refuse("a\nb\x1b[2Jc.bin", 36, "(a\\nb\\x1B[2Jc.bin)");
    refuse("data:application/octet-stream;base64", 36, "no comma");
    refuse("data:application/octet-stream;base64,AA*A", 36, "none of base64");
    refuse("data:application/octet-stream;base64,AA=A", 36, "behind its padding");
    refuse("data:application/octet-stream;base64,AAAAA", 36, "truncated");
}

TEST(BadBuffer, Lists) {
    const auto spoil = [](const Json& buffers) { return [buffers](Builder& b) { b.json["buffers"] = buffers; }; };
    const auto refuse = [&](const std::string& words, const Json& buffers) {  // Builder::glb() would write its own
        Builder b;
        b.meshNode(kTriangle);
        spoil(buffers)(b);
        expectBytesRefused(glbOf(b.json.dump(), b.binary), words);
    };
    refuse("buffers is not an array", 7);
    refuse("buffer 0 is no object", Json::array({7}));
    refuse("whole number in [1, 2^31)", Json::array({Json::object()}));
    refuse("whole number in [1, 2^31)", {{{"byteLength", -1}}});
    refuse("whole number in [1, 2^31)", {{{"byteLength", 0}}});
    refuse("whole number in [1, 2^31)", {{{"byteLength", 36.5}}});
    refuse("its data have 36 bytes", {{{"byteLength", 40}}});
    refuse("its uri is no text", {{{"byteLength", 36}, {"uri", 7}}});
    refuse("buffer 0 does not exist", Json::array());
    Builder second;  // only the first buffer may be the GLB's own
    second.meshNode(kTriangle);
    second.json["bufferViews"][0]["buffer"] = 1;
    second.json["buffers"] = {{{"byteLength", 36}}, {{"byteLength", 36}}};
    expectBytesRefused(glbOf(second.json.dump(), second.binary), "buffer 1 refers to no data");
}

TEST(BadAccessor, Bounds) {
    expectRefused("past the end", [](Builder& b) { b.json["accessors"][0]["count"] = 3000000; });
    expectRefused("past the end", [](Builder& b) { b.json["accessors"][0]["count"] = 2147483647; });
    expectRefused("whole number", [](Builder& b) { b.json["accessors"][0]["count"] = 4294967299; });
    expectRefused("whole number", [](Builder& b) { b.json["accessors"][0]["count"] = -1; });
    expectRefused("whole number", [](Builder& b) { b.json["accessors"][0]["count"] = 2.5; });
    expectRefused("no elements", [](Builder& b) { b.json["accessors"][0]["count"] = 0; });
    expectRefused("past the end", [](Builder& b) { b.json["accessors"][0]["byteOffset"] = 4; });
    expectRefused("past the end", [](Builder& b) { b.json["accessors"][0]["byteOffset"] = 2147483647; });
    expectRefused("does not exist", [](Builder& b) { b.json["accessors"][0]["bufferView"] = 7; });
    expectRefused("more than the file has bytes", [](Builder& b) {
        b.json["accessors"][0].erase("bufferView");
        b.json["accessors"][0]["count"] = 2000000000;
    });
    expectRefused("not glTF", [](Builder& b) { b.json["accessors"][0]["componentType"] = 5130; });
    expectRefused("wrong type", [](Builder& b) { b.json["accessors"][0]["type"] = "VEC2"; });
    expectRefused("not valid glTF", [](Builder& b) { b.json["accessors"][0]["type"] = "VEC9"; });
    expectRefused("past the end of buffer", [](Builder& b) { b.json["bufferViews"][0]["byteLength"] = 1000; });
    expectRefused("past the end of buffer", [](Builder& b) { b.json["bufferViews"][0]["byteOffset"] = 2147483647; });
    expectRefused("does not exist", [](Builder& b) { b.json["bufferViews"][0]["buffer"] = 1; });
    expectRefused("byteStride", [](Builder& b) { b.json["bufferViews"][0]["byteStride"] = 8; });
    expectRefused("past the end", [](Builder& b) { b.json["bufferViews"][0]["byteStride"] = 16; });
    expectRefused("exceed", [](Builder& b) {
        b.json["buffers"] = {{{"byteLength", 36}}};
        b.json["accessors"][0]["count"] = 3;
        b.json["bufferViews"][0]["byteLength"] = 36;
        b.json["nodes"][0]["scale"] = {1e31, 1, 1};
    });
}

TEST(BadAccessor, Sparse) {
    const auto sparse = [](Builder& b, const Json& change) {
        Json entry = {{"count", 1},
                      {"indices", {{"bufferView", b.view(bytesOf(std::vector<uint16_t>{1}))}, {"componentType", kU16}}},
                      {"values", {{"bufferView", b.view(bytesOf(std::vector<float>{1, 0, 0}))}}}};
        entry.merge_patch(change);
        b.json["accessors"][0]["sparse"] = entry;
    };
    expectRefused("sparse values", [&](Builder& b) { sparse(b, {{"count", 4}}); });
    expectRefused("past the end", [&](Builder& b) { sparse(b, {{"count", 2}}); });
    expectRefused("component type", [&](Builder& b) { sparse(b, {{"indices", {{"componentType", kF32}}}}); });
    expectRefused("does not exist", [&](Builder& b) { sparse(b, {{"values", {{"bufferView", 99}}}}); });
    expectRefused("past its 3 elements", [&](Builder& b) {
        sparse(b, Json::object());
        const int view = b.view(bytesOf(std::vector<uint16_t>{3}));
        b.json["accessors"][0]["sparse"]["indices"]["bufferView"] = view;
    });
}

TEST(BadMesh, Indices) {
    expectRefused("index 7 is past its 3 vertices", [](Builder& b) {
        const int indices = b.u16({0, 1, 7});
        b.json["meshes"][0]["primitives"][0]["indices"] = indices;
    });
    expectRefused("index 9", [](Builder& b) {
        const int indices = b.u16({0, 1, 2, 9});  // the rest that makes no triangle
        b.json["meshes"][0]["primitives"][0]["indices"] = indices;
    });
    expectRefused("unsigned integers", [](Builder& b) { b.json["meshes"][0]["primitives"][0]["indices"] = 0; });
    expectRefused("accessor", [](Builder& b) { b.json["meshes"][0]["primitives"][0]["indices"] = 44; });
    expectRefused("does not exist", [](Builder& b) { b.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 44; });
    expectRefused("whole number", [](Builder& b) { b.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = "0"; });
    expectRefused("not glTF", [](Builder& b) { b.json["meshes"][0]["primitives"][0]["mode"] = 7; });
    expectRefused("no attributes", [](Builder& b) { b.json["meshes"][0]["primitives"][0].erase("attributes"); });
    expectRefused("material 3", [](Builder& b) { b.json["meshes"][0]["primitives"][0]["material"] = 3; });
}

TEST(BadMesh, PositionsThatAreNotFinite) {
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()}) {
        std::vector<float> positions = kTriangle;
        positions[4] = bad;
        Builder builder;
        builder.meshNode(positions);
        expectBytesRefused(builder.glb(), "not finite");
    }
}

TEST(BadMesh, MorphAndSkin) {
    expectRefused("morph target has 1 vertices", [](Builder& b) {
        const int target = b.positions({1, 2, 3});
        b.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", target}}};
    });
    expectRefused("weights for 0 morph targets", [](Builder& b) { b.json["meshes"][0]["weights"] = {1}; });
    expectRefused("weights for 0 morph targets", [](Builder& b) { b.json["nodes"][0]["weights"] = {1}; });
    expectRefused("one entry per vertex", [](Builder& b) {
        const int joints = b.accessor(b.view(bytesOf(std::vector<uint8_t>(8, 0))), kU8, 2, "VEC4");
        b.json["meshes"][0]["primitives"][0]["attributes"]["JOINTS_0"] = joints;
    });
    const auto skin = [](Builder& b, uint8_t joint, float weight) {
        const int joints = b.accessor(b.view(bytesOf(std::vector<uint8_t>(12, joint))), kU8, 3, "VEC4");
        const int weights = b.floats(std::vector<float>(12, weight), "VEC4", 4);
        b.json["meshes"][0]["primitives"][0]["attributes"].update({{"JOINTS_0", joints}, {"WEIGHTS_0", weights}});
        b.json["skins"] = {{{"joints", {0}}}};
        b.json["nodes"][0]["skin"] = 0;
    };
    expectRefused("uses joint 5, its skin has 1", [&](Builder& b) { skin(b, 5, 1); });
    expectRefused("weight is negative or not finite", [&](Builder& b) { skin(b, 0, -1); });
    expectRefused("weight is negative or not finite", [&](Builder& b) { skin(b, 0, NAN); });
    expectRefused("joint 9 is no node", [&](Builder& b) { skin(b, 0, 1), b.json["skins"][0]["joints"] = {9}; });
    expectRefused("has no joints", [&](Builder& b) { skin(b, 0, 1), b.json["skins"][0]["joints"] = Json::array(); });
    expectRefused("skin 1 does not exist", [&](Builder& b) { skin(b, 0, 1), b.json["nodes"][0]["skin"] = 1; });
    expectRefused("fewer inverse bind matrices", [&](Builder& b) {
        skin(b, 0, 1);
        const int one = b.floats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, "MAT4", 16);
        b.json["skins"][0].update({{"joints", {0, 0}}, {"inverseBindMatrices", one}});
    });
}

TEST(BadNode, References) {
    expectRefused("mesh 9 does not exist", [](Builder& b) { b.json["nodes"][0]["mesh"] = 9; });
    expectRefused("camera 0 does not exist", [](Builder& b) { b.json["nodes"][0]["camera"] = 0; });
    expectRefused("light 2 does not exist", [](Builder& b) { b.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 2; });
    expectRefused("child 5 does not exist", [](Builder& b) { b.json["nodes"][0]["children"] = {5}; });
    expectRefused("whole number", [](Builder& b) { b.json["nodes"][0]["mesh"] = 4294967296; });
    expectRefused("whole number", [](Builder& b) { b.json["nodes"][0]["mesh"] = -1; });
    expectRefused("scene 4 does not exist", [](Builder& b) { b.json["scene"] = 4; });
    expectRefused("names node 8", [](Builder& b) { b.json["scenes"][0]["nodes"] = {8}; });
    expectRefused("cycle", [](Builder& b) { b.json["nodes"][0]["children"] = {0}; });
    expectRefused("cycle", [](Builder& b) {
        b.node({{"children", {2}}}, false);
        b.node({{"children", {1}}}, false);
    });
    expectRefused("two parents", [](Builder& b) {
        b.node({{"children", {0}}}, false);
        b.node({{"children", {0}}}, false);
    });
}

TEST(BadNode, Transformations) {
    expectRefused("16 numbers", [](Builder& b) { b.json["nodes"][0]["matrix"] = {1, 0, 0}; });
    expectRefused("3 numbers", [](Builder& b) { b.json["nodes"][0]["scale"] = {1, 0}; });
    expectRefused("4 numbers", [](Builder& b) { b.json["nodes"][0]["rotation"] = {1, 0, 0, "x"}; });
    expectRefused("matrix of node 0", [](Builder& b) { b.json["nodes"][0]["translation"] = {1e300, 0, 0}; });
    expectRefused("matrix of node", [](Builder& b) {
        b.json["nodes"][0]["scale"] = {1e20, 1e20, 1e20};
        b.node({{"children", {0}}, {"scale", {1e20, 1e20, 1e20}}});
        b.json["scenes"][0]["nodes"] = {1};
    });
    expectRefused("not finite, or exceeds", [](Builder& b) {
        b.json["meshes"][0]["weights"] = Json::array(), b.json["nodes"][0]["scale"] = {1e30, 1e30, 1e30},
        b.binary.replace(12, 4, bytesOf(std::vector<float>{10}));
    });
}

TEST(BadAnimation, ChannelsAndSamplers) {
    const auto spoil = [](const std::function<void(Builder&, Json&)>& change) {
        return [change](Builder& b) {
            const int input = b.floats({0, 1}, "SCALAR", 1), output = b.positions({0, 0, 0, 1, 1, 1});
            b.json["animations"] = {{{"samplers", {{{"input", input}, {"output", output}}}},
                                     {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}};
            change(b, b.json["animations"][0]);
        };
    };
    expectRefused("sampler 3 does not exist", spoil([](Builder&, Json& a) { a["channels"][0]["sampler"] = 3; }));
    expectRefused("node 7 does not exist", spoil([](Builder&, Json& a) { a["channels"][0]["target"]["node"] = 7; }));
    expectRefused("accessor 44 does not exist", spoil([](Builder&, Json& a) { a["samplers"][0]["input"] = 44; }));
    expectRefused("accessor 45 does not exist", spoil([](Builder&, Json& a) { a["samplers"][0]["output"] = 45; }));
    expectRefused("wrong type", spoil([](Builder&, Json& a) { a["samplers"][0]["input"] = a["samplers"][0]["output"]; }));
    expectRefused("are needed", spoil([](Builder&, Json& a) { a["samplers"][0]["interpolation"] = "CUBICSPLINE"; }));
    expectRefused("unknown interpolation", spoil([](Builder&, Json& a) { a["samplers"][0]["interpolation"] = "MAGIC"; }));
    expectRefused("do not rise", spoil([](Builder& b, Json& a) { a["samplers"][0]["input"] = b.floats({1, 0}, "SCALAR", 1); }));
    expectRefused("not finite", spoil([](Builder& b, Json& a) { a["samplers"][0]["input"] = b.floats({0, INFINITY}, "SCALAR", 1); }));
    expectRefused("not finite", spoil([](Builder& b, Json& a) { a["samplers"][0]["output"] = b.positions({0, 0, 0, NAN, 0, 0}); }));
}

TEST(BadAnimation, PositionsBeyondAllMeasureAreToldWhenTheyAppear) {
    Builder b;
    b.meshNode({0, 0, 0, 1e11f, 0, 0, 0, 1e11f, 0});
    const int input = b.floats({0, 1}, "SCALAR", 1), output = b.positions({1, 1, 1, 1e20f, 1e20f, 1e20f});
    b.json["animations"] = {
        {{"samplers", {{{"input", input}, {"output", output}}}}, {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "scale"}}}}}}}};
    const SceneFile scene = loadBytes(b.glb());
    EXPECT_EQ(scene.evaluate(0, 0).triangles.size(), 1u);
    expectError(inputError([&] { (void)scene.evaluate(30, 0); }), "scene.glb", "exceeds 1e30");
}

TEST(BadLightOrCamera, Values) {
    const auto light = [](const Json& entry) { return [entry](Builder& b) { b.json["extensions"]["KHR_lights_punctual"]["lights"] = {entry}; }; };
    expectRefused("unknown type", light({{"type", "area"}}));
    expectRefused("not valid glTF", light({{"type", "spot"}}));
    expectRefused("cone angles", light({{"type", "spot"}, {"spot", {{"innerConeAngle", 0.5}, {"outerConeAngle", 0.4}}}}));
    expectRefused("cone angles", light({{"type", "spot"}, {"spot", {{"innerConeAngle", 0}, {"outerConeAngle", 0}}}}));
    expectRefused("intensity", light({{"type", "point"}, {"intensity", -1}}));
    expectRefused("3 numbers", light({{"type", "point"}, {"color", {1, 1}}}));
    const auto camera = [](const Json& entry) { return [entry](Builder& b) { b.json["cameras"] = {entry}; }; };
    expectRefused("yfov", camera({{"type", "perspective"}, {"perspective", {{"yfov", 0}, {"znear", 1}}}}));
    expectRefused("znear", camera({{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0}}}}));
    expectRefused("zfar", camera({{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}, {"zfar", 0.5}}}}));
    expectRefused("xmag or ymag", camera({{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 0}, {"znear", 0}, {"zfar", 1}}}}));
    expectRefused("znear and zfar", camera({{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 1}, {"zfar", 1}}}}));
    expectRefused("not valid glTF", camera({{"type", "fisheye"}}));
}

TEST(Extensions, ThoseThatChangeGeometryAreRefusedByName) {
    for (const std::string name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression", "VENDOR_unheard_of"}) {
        expectRefused(name, [&](Builder& b) { b.json["extensionsRequired"] = {name}; });
        Builder onlyUsed;
        onlyUsed.meshNode(kTriangle);
        onlyUsed.json["extensionsUsed"] = {name};
        EXPECT_EQ(frameOf(onlyUsed).triangles.size(), 1u) << name;
    }
    // Told before anything else is missed.
    expectBytesRefused(glbOf(R"({"asset":{"version":"2.0"},"extensionsRequired":["KHR_draco_mesh_compression"]})", ""),
                       "KHR_draco_mesh_compression");
}

TEST(Empty, NoTriangles) {
    expectBytesRefused(glbOf(R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[]}]})", ""), "no triangles");
    expectRefused("no triangles", [](Builder& b) { b.json["meshes"][0]["primitives"][0]["mode"] = 1; });
    expectRefused("no triangles", [](Builder& b) { b.json["scenes"][0]["nodes"] = Json::array(); });
    expectRefused("no triangle has an area", [](Builder& b) { b.json["nodes"][0]["scale"] = {1, 0, 1}; });
}

TEST(TooMuch, ManyNodesOfOneMesh) {
    Builder builder;
    const std::vector<uint16_t> indices(300000, 0);
    builder.meshNode(kTriangle, indices);
    for (int i = 0; i < 700; ++i) builder.node({{"mesh", 0}});
    expectBytesRefused(builder.glb(), "more than 67108864 triangles");
}

TEST(TooMuch, InstancesOfInstances) {
    Builder builder;
    builder.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    builder.meshNode(kCube, kCubeIndices);
    const int many = builder.positions(std::vector<float>(300000, 0.f));
    builder.json["nodes"] = Json::array();
    builder.json["scenes"][0]["nodes"] = Json::array();
    for (int i = 0; i < 60; ++i)
        builder.node({{"mesh", 0}, {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", many}}}}}}}});
    expectBytesRefused(builder.glb(), "more than 1048576 mesh instances");
}

}  // namespace
}  // namespace gno::host::test
