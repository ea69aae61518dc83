// SPDX-License-Identifier: MIT
// Materials of casters that are not opaque: what is read, where texel coordinates end up, and every bad file as one line.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "scene_builder.hpp"
#include "tiny_png.hpp"

namespace gno::host::test {
namespace {

using glm::ivec2;
using Corners = std::array<ivec2, 3>;

const std::vector<float> kUv{0, 0, 1, 0, 0, 1};

/// One triangle of a masked material with an image of 4 x 2 texels in the file, texture coordinates kUv.
struct Leaf : Builder {
    explicit Leaf(const std::vector<float>& uv = kUv, const std::string& png = tinyPng(4, 2, std::string(32, '\x7F'))) {
        json["materials"] = {{{"alphaMode", "MASK"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
        json["textures"] = {{{"source", 0}, {"sampler", 0}}};
        json["samplers"] = {Json::object()};
        json["images"] = {{{"bufferView", view(png)}, {"mimeType", "image/png"}}};
        meshNode(kTriangle, {0, 1, 2});
        primitive()["material"] = 0;
        const int coordinates = floats(uv, "VEC2", 2);
        primitive()["attributes"]["TEXCOORD_0"] = coordinates;
    }
    Json& primitive() { return json["meshes"][0]["primitives"][0]; }
    Json& texture() { return json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]; }
    Json& sampler() { return json["samplers"][0]; }
};

Corners cornersOf(const Builder& builder) {
    const Frame frame = frameOf(builder);
    return frame.surfaces.at(0).corners;
}

TEST(Materials, AreReadWithTextureAndSampler) {
    Leaf leaf(kUv, tinyPng(2, 1, "\x01\x02\x03\x04\xFD\xFE\xFF\x80"));
    leaf.json["materials"][0].update({{"alphaCutoff", 0.25}, {"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", 0.75}}}}}});
    leaf.sampler() = {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}};
    const SceneFile file = loadBytes(leaf.glb());
    const Frame frame = file.evaluate(0, 0);
    ASSERT_EQ(frame.surfaceOf, std::vector<uint32_t>{0});
    ASSERT_TRUE(frame.look);
    const Material& material = frame.look->materials.at(frame.surfaces.at(0).material);
    EXPECT_EQ(&material, file.materials().data());
    EXPECT_EQ(material.alpha, Material::Alpha::mask);
    EXPECT_EQ(material.alphaCutoff, 0.25f);
    EXPECT_EQ(material.transmission, 0.75f);
    EXPECT_EQ(material.wrapU, Wrap::clamp);
    EXPECT_EQ(material.wrapV, Wrap::mirrored);
    EXPECT_FALSE(material.linearFilter);
    const TextureImage& image = frame.look->images.at(static_cast<size_t>(material.image));
    EXPECT_EQ(image.width, 2u);
    EXPECT_EQ(image.height, 1u);
    EXPECT_EQ(image.rgba, (std::vector<uint8_t>{1, 2, 3, 4, 0xFD, 0xFE, 0xFF, 0x80}));
    EXPECT_EQ(frame.surfaces[0].corners, (Corners{ivec2(0, 0), ivec2(512, 0), ivec2(0, 256)}));
}

TEST(Materials, HaveTheDefaultsOfGltf) {
    const Leaf leaf;
    const SceneFile file = loadBytes(leaf.glb());
    const Material& material = file.materials()[0];
    EXPECT_EQ(material.alphaCutoff, 0.5f);
    EXPECT_EQ(material.transmission, 0);
    EXPECT_EQ(material.wrapU, Wrap::repeat);
    EXPECT_EQ(material.wrapV, Wrap::repeat);
    EXPECT_TRUE(material.linearFilter);
}

/// Opaque ones are left alone: their image may be missing, and the frame carries nothing of materials.
TEST(Materials, OpaqueOnesOpenNoImage) {
    Leaf leaf;
    leaf.json["materials"][0].erase("alphaMode");
    leaf.json["images"] = {{{"uri", "is not there.png"}}};
    const SceneFile file = loadBytes(leaf.glb());
    const Frame frame = file.evaluate(0, 0);
    EXPECT_TRUE(file.materials()[0].isOpaque());
    EXPECT_TRUE(file.materials()[0].textured);
    EXPECT_TRUE(frame.surfaceOf.empty() && frame.surfaces.empty());
    EXPECT_FALSE(frame.look);
    leaf.json["materials"][0]["extensions"] = {{"KHR_materials_transmission", {{"transmissionFactor", 0.0}}}};
    EXPECT_TRUE(frameOf(leaf).surfaces.empty()) << "a transmission of 0 is none";
    leaf.json["materials"].push_back({{"alphaMode", "BLEND"}});
    EXPECT_TRUE(frameOf(leaf).surfaces.empty()) << "a material that no primitive has";
}

/// KHR_materials_pbrSpecularGlossiness goes before what the base specification has: factor, texture, its transform and set.
TEST(Materials, OfSpecularAndGlossiness) {
    Leaf leaf;
    Json& material = leaf.json["materials"][0];
    material["pbrMetallicRoughness"] = {{"baseColorFactor", {1, 1, 1, 1}}, {"baseColorTexture", {{"index", 9}, {"texCoord", 9}}}};
    Json& other = material["extensions"]["KHR_materials_pbrSpecularGlossiness"];
    other = {{"diffuseFactor", {0.25, 0.5, 0.75, 0.125}}, {"diffuseTexture", {{"index", 0}}}, {"specularGlossinessTexture", {{"index", 7}}}};
    const SceneFile file = loadBytes(leaf.glb());
    EXPECT_EQ(file.materials()[0].baseColor, glm::vec4(0.25f, 0.5f, 0.75f, 0.125f));
    EXPECT_EQ(file.materials()[0].image, 0);
    EXPECT_EQ(file.evaluate(0, 0).surfaces.at(0).corners, (Corners{ivec2(0, 0), ivec2(1024, 0), ivec2(0, 512)}));
    other["diffuseTexture"]["extensions"]["KHR_texture_transform"] = {{"offset", {0.5, 0}}};
    EXPECT_EQ(cornersOf(leaf)[0], ivec2(512, 0));
    other = Json::object();
    const SceneFile plain = loadBytes(leaf.glb());
    EXPECT_EQ(plain.materials()[0].baseColor, glm::vec4(1)) << "its defaults";
    EXPECT_EQ(plain.materials()[0].image, -1);
}

/// A leaf of glass: what passes is colour times transmission, so its texture goes into the image.
struct Pane : Leaf {
    explicit Pane(const std::string& share = "\x80zzz\xFFzzz") : Leaf(kUv, tinyPng(2, 1, std::string("\xFF\x80\x00\x40\xBC\xFF\xFF\xC0", 8))) {
        json["materials"][0].erase("alphaMode");
        json["materials"][0]["extensions"]["KHR_materials_transmission"] = {{"transmissionFactor", 0.5}, {"transmissionTexture", {{"index", 1}}}};
        json["textures"].push_back({{"source", 1}, {"sampler", 0}});
        json["images"].push_back({{"bufferView", view(tinyPng(2, 1, share))}});
    }
    Json& transmission() { return json["materials"][0]["extensions"]["KHR_materials_transmission"]["transmissionTexture"]; }
};

TEST(Transmission, TextureTimesBaseColour) {
    const Pane pane;
    const Frame frame = frameOf(pane);
    const Material& material = frame.look->materials.at(frame.surfaces.at(0).material);
    EXPECT_EQ(material.transmission, 0.5f) << "the factor stays";
    const TextureImage& image = frame.look->images.at(static_cast<size_t>(material.image));
    EXPECT_TRUE(image.isLinear);
    // linear: 255, 55, 0 and 128, 255, 255 (of 0xBC); times 128/255 and 1
    EXPECT_EQ(image.rgba, (std::vector<uint8_t>{128, 28, 0, 0x40, 128, 255, 255, 0xC0}));
    EXPECT_EQ(noticeOf(frame, "transmission texture of material 0"), "");
}

TEST(Transmission, TextureAlone) {
    Pane pane;
    pane.json["materials"][0].erase("pbrMetallicRoughness");
    pane.json["samplers"].push_back({{"wrapS", 33071}, {"magFilter", 9728}});
    pane.json["textures"][1]["sampler"] = 1;
    pane.transmission()["extensions"]["KHR_texture_transform"] = {{"offset", {0.5, 0}}};
    const Frame frame = frameOf(pane);
    const Material& material = frame.look->materials.at(frame.surfaces.at(0).material);
    EXPECT_EQ(frame.look->images.at(static_cast<size_t>(material.image)).rgba, (std::vector<uint8_t>{128, 128, 128, 255, 255, 255, 255, 255}));
    EXPECT_EQ(material.wrapU, Wrap::clamp);
    EXPECT_FALSE(material.linearFilter);
    EXPECT_EQ(frame.surfaces[0].corners[0], ivec2(256, 0)) << "half of 2 texels";
}

TEST(Transmission, TextureThatLiesOtherwiseIsTold) {
    const auto toldOf = [](const std::function<void(Pane&)>& spoil) {
        Pane pane;
        spoil(pane);
        const Frame frame = frameOf(pane);
        EXPECT_FALSE(frame.look->images.at(static_cast<size_t>(frame.look->materials[0].image)).isLinear);
        return noticeOf(frame, "transmission texture of material 0");
    };
    const std::string want = "not used, it lies otherwise than the base colour texture; transmissionFactor alone counts";
    EXPECT_EQ(toldOf([](Pane& p) { p.transmission()["extensions"]["KHR_texture_transform"] = {{"scale", {2, 1}}}; }), want);
    EXPECT_EQ(toldOf([](Pane& p) { p.transmission()["texCoord"] = 1; }), want);
    EXPECT_EQ(toldOf([](Pane& p) { p.json["textures"][1].erase("sampler"), p.sampler()["wrapS"] = 33071; }), want);
    EXPECT_EQ(toldOf([](Pane& p) { p.json["images"][1]["bufferView"] = p.view(tinyPng(1, 1, "abcd")); }), want);
}

TEST(Transmission, TextureIsOpenedWhereItCounts) {
    Pane pane;
    pane.json["images"][1] = {{"uri", "absent.png"}};
    EXPECT_NE(inputError([&] { (void)frameOf(pane); }).find("image 1 (absent.png)"), std::string::npos);
    pane.json["materials"][0]["extensions"]["KHR_materials_transmission"]["transmissionFactor"] = 0;
    EXPECT_EQ(inputError([&] { (void)frameOf(pane); }), "");
}

/// A veil of two triangles, without an image, with these vertex colours.
Frame veil(const std::vector<float>& colours, const char* type, Json material = {{"alphaMode", "BLEND"}}) {
    Builder builder;
    material["pbrMetallicRoughness"]["baseColorFactor"] = {0.5, 0.5, 0.5, 0.5};
    builder.json["materials"] = {material};
    builder.meshNode({0, 0, 0, 1, 0, 0, 0, 1, 0, 2, 0, 0, 3, 0, 0, 2, 1, 0}, {0, 1, 2, 3, 4, 5});
    const int colour = builder.floats(colours, type, colours.size() / 6);
    auto& primitive = builder.json["meshes"][0]["primitives"][0];
    primitive["material"] = 0;
    primitive["attributes"]["COLOR_0"] = colour;
    return frameOf(builder);
}
std::vector<float> six(std::vector<float> first, const std::vector<float>& second) {  // three vertices each
    std::vector<float> all;
    for (int i = 0; i < 6; ++i) all.insert(all.end(), i < 3 ? first.begin() : second.begin(), i < 3 ? first.end() : second.end());
    return all;
}
glm::vec4 factorOf(const Frame& frame, size_t surface) { return frame.look->materials.at(frame.surfaces.at(surface).material).baseColor; }

TEST(VertexColours, MultiplyWhatPasses) {
    const Frame frame = veil(six({0.1f, 0.2f, 0.3f, 1}, {1, 1, 1, 0.75f}), "VEC4");
    EXPECT_EQ(frame.surfaces.at(0).material, 0u) << "alpha 1; without a transmission the colour decides nothing";
    EXPECT_EQ(factorOf(frame, 1), glm::vec4(0.5f, 0.5f, 0.5f, 0.375f));
    EXPECT_EQ(frame.material, (std::vector<uint32_t>{0, 0})) << "pictures know the file's materials only";
    EXPECT_EQ(noticeOf(frame, "COLOR_0 of material 0"), "");
    const Json glass = {{"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", 1}}}}}};
    const Frame tinted = veil(six({0.5f, 1, 0, 0.25f}, {1, 1, 1, 0}), "VEC4", glass);
    EXPECT_EQ(factorOf(tinted, 0), glm::vec4(0.25f, 0.5f, 0, 0.5f)) << "glass has no alpha";
    EXPECT_EQ(tinted.surfaces.at(1).material, 0u);
    EXPECT_EQ(factorOf(veil(six({0.5f, 1, 0}, {2, -1, 1}), "VEC3", glass), 1), glm::vec4(0.5f, 0, 0.5f, 0.5f)) << "clamped";
    EXPECT_EQ(veil(six({0, 0, 0}, {0, 0, 0}), "VEC3").surfaces.at(0).material, 0u) << "three numbers: alpha is 1";
    EXPECT_TRUE(veil(std::vector<float>(6, NAN), "SCALAR", Json::object()).surfaces.empty()) << "nobody reads those of an opaque one";
}

TEST(VertexColours, ThatDifferCountWithTheirMean) {
    std::vector<float> colours = six({1, 1, 1, 0.8f}, {1, 1, 1, 0.8f});
    colours[3] = 0.2f;
    const Frame frame = veil(colours, "VEC4");
    EXPECT_NEAR(factorOf(frame, 0).w, 0.5 * 0.6, 1e-6);
    EXPECT_EQ(factorOf(frame, 1).w, 0.5f * 0.8f);
    EXPECT_EQ(noticeOf(frame, "COLOR_0 of material 0"), "differs within triangles; each is taken with the mean of its vertices");
}

TEST(VertexColours, ThatAreNone) {
    const auto refusal = [](const std::vector<float>& colours, const char* type) { return inputError([&] { (void)veil(colours, type); }); };
    EXPECT_NE(refusal(std::vector<float>(12, 0.5f), "VEC2").find("wrong type"), std::string::npos);
    EXPECT_NE(refusal(std::vector<float>(24, NAN), "VEC4").find("COLOR_0 is not finite"), std::string::npos);
    Builder builder;
    builder.json["materials"] = {{{"alphaMode", "BLEND"}}};
    builder.meshNode(kTriangle);
    const int two = builder.floats(std::vector<float>(8, 0.5f), "VEC4", 4);
    auto& primitive = builder.json["meshes"][0]["primitives"][0];
    primitive["material"] = 0;
    primitive["attributes"]["COLOR_0"] = two;
    EXPECT_NE(inputError([&] { (void)frameOf(builder); }).find("COLOR_0 has 2 entries for 3 vertices"), std::string::npos);
    primitive["attributes"]["COLOR_0"] = 77;
    EXPECT_NE(inputError([&] { (void)frameOf(builder); }).find("does not exist"), std::string::npos);
}

TEST(Materials, StandBesideOpaqueTriangles) {
    Leaf leaf;
    leaf.json["materials"].push_back({{"alphaMode", "BLEND"}});
    leaf.meshNode(kCube, kCubeIndices);
    leaf.meshNode(kTriangle, {0, 1, 2}, {{"translation", {0, 0, 3}}});
    leaf.json["meshes"][2]["primitives"][0]["material"] = 1;
    std::swap(leaf.json["nodes"][0]["mesh"], leaf.json["nodes"][1]["mesh"]);  // cube, leaf, veil, cube
    leaf.node({{"mesh", 1}, {"translation", {5, 0, 0}}});
    const Frame frame = frameOf(leaf);
    ASSERT_EQ(frame.triangles.size(), 26u);
    ASSERT_EQ(frame.surfaceOf.size(), 26u);
    for (size_t i = 0; i < 26; ++i) EXPECT_EQ(frame.surfaceOf[i], i == 12 ? 0u : i == 13 ? 1u : kOpaque) << i;
    EXPECT_EQ(frame.surfaces.at(0).material, 0u);
    EXPECT_EQ(frame.surfaces.at(1).material, 1u);
    EXPECT_EQ(frame.surfaces[1].corners, Corners{}) << "no image, no coordinates";
}

TEST(Materials, OneImageOfTwoMaterialsIsReadOnce) {
    Leaf leaf;
    leaf.json["materials"].push_back(leaf.json["materials"][0]);
    leaf.json["materials"][1]["alphaMode"] = "BLEND";
    leaf.json["meshes"][0]["primitives"].push_back(leaf.primitive());
    leaf.json["meshes"][0]["primitives"][1]["material"] = 1;
    const Frame frame = frameOf(leaf);
    EXPECT_EQ(frame.look->images.size(), 1u);
    EXPECT_EQ(frame.look->materials[0].image, 0);
    EXPECT_EQ(frame.look->materials[1].image, 0);
}

TEST(Images, OfOtherChannelsAndPlaces) {
    const auto imageOf = [](const std::string& png) { return frameOf(Leaf(kUv, png)).look->images.at(0).rgba; };
    EXPECT_EQ(imageOf(tinyPng(1, 1, "\x55", 1)), (std::vector<uint8_t>{0x55, 0x55, 0x55, 255}));
    EXPECT_EQ(imageOf(tinyPng(1, 1, "\x55\x11", 2)), (std::vector<uint8_t>{0x55, 0x55, 0x55, 0x11}));
    EXPECT_EQ(imageOf(tinyPng(1, 1, "\x01\x02\x03", 3)), (std::vector<uint8_t>{1, 2, 3, 255}));
    Leaf leaf;
    const TemporaryFolder folder;
    folder.write("a leaf.png", tinyPng(1, 1, "abcd"));
    leaf.json["images"] = {{{"uri", "a%20leaf.png"}}};
    EXPECT_EQ(SceneFile::load(folder.write("scene.glb", leaf.glb())).evaluate(0, 0).look->images.at(0).rgba,
              (std::vector<uint8_t>{'a', 'b', 'c', 'd'}));
    leaf.json["images"] = {
        {{"uri", "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg=="}}};
    EXPECT_EQ(frameOf(leaf).look->images.at(0).width, 1u);
}

TEST(Corners, AreRoundedToA256thOfATexel) {
    EXPECT_EQ(cornersOf(Leaf({0.1f, 0.2f, 0.30001f, 0.4f, 0.5f, 0.999f})), (Corners{ivec2(102, 102), ivec2(307, 205), ivec2(512, 511)}));
}

TEST(Corners, MoveByWholeRepeatsTowardsZero) {
    const std::vector<float> far{7.25f, -2.5f, 8.5f, -1.75f, 7.5f, -3.25f};  // least: 7.25, -3.25
    Leaf leaf(far);
    EXPECT_EQ(cornersOf(leaf), (Corners{ivec2(256, 768), ivec2(1536, 1152), ivec2(512, 384)})) << "by 7 and by -4";
    leaf.sampler() = {{"wrapS", 33648}, {"wrapT", 33648}};
    EXPECT_EQ(cornersOf(leaf), (Corners{ivec2(1280, 768), ivec2(2560, 1152), ivec2(1536, 384)})) << "by 6 and by -4: mirrored images come in pairs";
    leaf.sampler() = {{"wrapS", 33071}, {"wrapT", 33071}};
    EXPECT_EQ(cornersOf(leaf), (Corners{ivec2(7424, -1280), ivec2(8704, -896), ivec2(7680, -1664)})) << "not at all";
    const float million = 1 << 20;
    EXPECT_EQ(cornersOf(Leaf({million, -million, million + 1, -million, million, 1 - million})),
              (Corners{ivec2(0, 0), ivec2(1024, 0), ivec2(0, 512)}));
}

TEST(Corners, FollowTheWindingOfAMirroredNode) {
    Leaf leaf;
    leaf.json["nodes"][0]["scale"] = {-1, 1, 1};
    EXPECT_EQ(cornersOf(leaf), (Corners{ivec2(0, 0), ivec2(0, 512), ivec2(1024, 0)}));
}

TEST(Corners, OfNormalisedIntegersAndOtherSets) {
    Leaf leaf;
    const int shorts =
        leaf.accessor(leaf.view(bytesOf(std::vector<uint16_t>{0, 65535, 65535, 0, 13107, 0})), kU16, 3, "VEC2", {{"normalized", true}});
    leaf.primitive()["attributes"]["TEXCOORD_3"] = shorts;
    leaf.texture()["texCoord"] = 3;
    EXPECT_EQ(cornersOf(leaf), (Corners{ivec2(0, 512), ivec2(1024, 0), ivec2(205, 0)}));
    leaf.texture()["texCoord"] = 1;
    leaf.texture()["extensions"]["KHR_texture_transform"] = {{"texCoord", 3}};
    EXPECT_EQ(cornersOf(leaf), (Corners{ivec2(0, 512), ivec2(1024, 0), ivec2(205, 0)})) << "the extension's set goes before";
}

TEST(Corners, FollowATextureTransform) {
    Leaf leaf;
    leaf.sampler() = {{"wrapS", 33071}, {"wrapT", 33071}};
    leaf.texture()["extensions"]["KHR_texture_transform"] = {{"offset", {0.5, 0.25}}, {"scale", {2, 3}}};
    EXPECT_EQ(cornersOf(leaf), (Corners{ivec2(512, 128), ivec2(2560, 128), ivec2(512, 1664)}));
    leaf.texture()["extensions"]["KHR_texture_transform"] = {
        {"rotation", std::acos(-1.0) / 2}};  // counter-clockwise: u turns upwards, v to the right
    EXPECT_EQ(cornersOf(leaf), (Corners{ivec2(0, 0), ivec2(0, -512), ivec2(1024, 0)}));
}

void expectRefused(const std::string& words, const std::function<void(Leaf&)>& spoil) {
    Leaf leaf;
    spoil(leaf);
    SCOPED_TRACE(leaf.json.dump());
    const std::string text = inputError([&] { (void)loadBytes(leaf.glb(), "bad.glb").evaluate(0, 0); });
    EXPECT_NE(text.find(words), std::string::npos) << "wanted: " << words << "\ngot: " << text;
    EXPECT_NE(text.find("bad.glb"), std::string::npos) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
}

TEST(BadTexture, ImageThatCannotBeRead) {
    expectRefused("image 0 (absent.png): no such file", [](Leaf& l) { l.json["images"] = {{{"uri", "absent.png"}}}; });
    expectRefused("image 0 (absent%20leaf.png): no such file", [](Leaf& l) { l.json["images"] = {{{"uri", "absent%20leaf.png"}}}; });
    expectRefused("not a path beside the model", [](Leaf& l) { l.json["images"] = {{{"uri", "/dev/zero"}}}; });
    expectRefused("not a path beside the model", [](Leaf& l) { l.json["images"] = {{{"uri", ""}}}; });
    expectRefused("neither a buffer view nor a uri", [](Leaf& l) { l.json["images"] = {Json::object()}; });
    expectRefused("neither a buffer view nor a uri", [](Leaf& l) { l.json["images"] = {{{"uri", 7}}}; });
    expectRefused("image 0 is not a PNG or JPEG", [](Leaf& l) { l.json["images"] = {{{"uri", "data:image/png;base64,"}}}; });
    expectRefused("image 0: its base64 is truncated", [](Leaf& l) { l.json["images"] = {{{"uri", "data:image/png;base64,iVBORw0KGgoAA"}}}; });
    expectRefused("buffer view 99 does not exist", [](Leaf& l) { l.json["images"][0]["bufferView"] = 99; });
    expectRefused("not a whole number", [](Leaf& l) { l.json["images"][0]["bufferView"] = -1; });
    expectRefused("reaches past the end", [](Leaf& l) { l.json["bufferViews"][0]["byteLength"] = 100000; });
    expectRefused("not a PNG or JPEG", [](Leaf& l) { l.json["images"][0]["bufferView"] = l.view("RIFF    WEBPVP8 this is another kind of file"); });
    expectRefused("entry 0 of images does not exist", [](Leaf& l) { l.json.erase("images"); });
    expectRefused("entry 0 of images is no object", [](Leaf& l) { l.json["images"] = {7}; });
    expectRefused("entry 0 of images does not exist", [](Leaf& l) { l.json["images"] = "text"; });
}

TEST(BadTexture, TruncatedPngAtEveryLength) {
    const std::string png = tinyPng(4, 2, std::string(32, '\x7F'));
    for (size_t length = 1; length + 16 <= png.size();
         ++length) {  // behind the texels stand a checksum and an empty chunk, which decoders pass over
        const std::string text = inputError([&] { (void)frameOf(Leaf(kUv, png.substr(0, length))); });
        EXPECT_NE(text.find("image 0"), std::string::npos) << length;
        EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    }
    std::string large = png;
    for (const auto& [side, words] :
         {std::pair{12000u, "12000 x 12000 texels; all images together may have 134217728"}, {30000u, "not a PNG or JPEG that can be read"}}) {
        large.replace(16, 8, bigEndian(side) + bigEndian(side));
        const std::string text = inputError([&] { (void)frameOf(Leaf(kUv, large)); });
        EXPECT_NE(text.find(words), std::string::npos) << text;
    }
}

TEST(BadTexture, ReferencesThatLeadNowhere) {
    expectRefused("entry 5 of textures does not exist", [](Leaf& l) { l.texture()["index"] = 5; });
    expectRefused("entry 0 of textures does not exist", [](Leaf& l) { l.json["textures"] = Json::object(); });
    expectRefused("whole number", [](Leaf& l) { l.texture()["index"] = 0.5; });
    expectRefused("entry 3 of samplers does not exist", [](Leaf& l) { l.json["textures"][0]["sampler"] = 3; });
    expectRefused("source is not a whole number", [](Leaf& l) { l.json["textures"][0]["source"] = "leaf"; });
    expectRefused("texture 0 has no PNG or JPEG; material 0 lets light through", [](Leaf& l) {
        l.json["textures"][0] = {{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}};
    });
    expectRefused("wrap mode 7 is not glTF", [](Leaf& l) { l.sampler() = {{"wrapS", 7}}; });
    expectRefused("wrapT is not a whole number", [](Leaf& l) { l.sampler() = {{"wrapT", "repeat"}}; });
}

TEST(BadTexture, Coordinates) {
    expectRefused("lacks TEXCOORD_0", [](Leaf& l) { l.primitive()["attributes"].erase("TEXCOORD_0"); });
    expectRefused("lacks TEXCOORD_1", [](Leaf& l) { l.texture()["texCoord"] = 1; });
    expectRefused("TEXCOORD_0 has 4 entries for 3 vertices", [](Leaf& l) {
        const int four = l.floats({0, 0, 1, 0, 0, 1, 1, 1}, "VEC2", 2);
        l.primitive()["attributes"]["TEXCOORD_0"] = four;
    });
    expectRefused("TEXCOORD_0 has 2 entries for 3 vertices", [](Leaf& l) {
        const int two = l.floats({0, 0, 1, 0}, "VEC2", 2);
        l.primitive()["attributes"]["TEXCOORD_0"] = two;
    });
    expectRefused("wrong type", [](Leaf& l) { l.primitive()["attributes"]["TEXCOORD_0"] = 0; });
    expectRefused("does not exist", [](Leaf& l) { l.primitive()["attributes"]["TEXCOORD_0"] = 77; });
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 2e30f})
        expectRefused("TEXCOORD_0 is not finite", [&](Leaf& l) {
            const int uv = l.floats({0, 0, bad, 0, 0, 1}, "VEC2", 2);
            l.primitive()["attributes"]["TEXCOORD_0"] = uv;
        });
    const auto reach = [](float u) {
        return [u](Leaf& l) {
            const int uv = l.floats({0, 0, u, 0, 0, 1}, "VEC2", 2);
            l.primitive()["attributes"]["TEXCOORD_0"] = uv;
        };
    };
    expectRefused("more than 4194304 texels in one triangle", reach(1 << 20));  // times 4 texels
    Leaf most;
    reach((1 << 20) - 1)(most);
    EXPECT_EQ(cornersOf(most)[1], ivec2((1 << 30) - 1024, 0));
}

TEST(BadMaterial, Numbers) {
    expectRefused("alphaCutoff is less than 0", [](Leaf& l) { l.json["materials"][0]["alphaCutoff"] = -0.5; });
    const auto transform = [](const Json& value) { return [value](Leaf& l) { l.texture()["extensions"]["KHR_texture_transform"] = value; }; };
    expectRefused("offset is not an array of 2 numbers", transform({{"offset", {1, 2, 3}}}));
    expectRefused("scale is not a finite number", transform({{"scale", {1, "x"}}}));
    expectRefused("rotation is not a finite number", transform({{"rotation", "x"}}));
    const auto glossy = [](const Json& value) {
        return [value](Leaf& l) { l.json["materials"][0]["extensions"]["KHR_materials_pbrSpecularGlossiness"] = value; };
    };
    expectRefused("is not an object", glossy(7));
    expectRefused("does not have 4 numbers", glossy({{"diffuseFactor", {1, 1, 1}}}));
    expectRefused("diffuseFactor is not a finite number", glossy({{"diffuseFactor", {1, 1, 1, "x"}}}));
    expectRefused("diffuseFactor is not an array of numbers", glossy({{"diffuseFactor", 1}}));
    expectRefused("diffuseTexture is no object", glossy({{"diffuseTexture", 0}}));
    expectRefused("diffuseTexture has no index", glossy({{"diffuseTexture", Json::object()}}));
    expectRefused("entry 5 of textures does not exist", glossy({{"diffuseTexture", {{"index", 5}}}}));
    expectRefused("index is -1", glossy({{"diffuseTexture", {{"index", -1}}}}));
    expectRefused("lacks TEXCOORD_2", glossy({{"diffuseTexture", {{"index", 0}, {"texCoord", 2}}}}));
    expectRefused("offset is not an array of 2 numbers",
                  glossy({{"diffuseTexture", {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"offset", 1}}}}}}}}));
    const auto glass = [](const Json& value) {
        return [value](Leaf& l) {
            l.json["materials"][0]["extensions"]["KHR_materials_transmission"] = {{"transmissionFactor", 1}, {"transmissionTexture", value}};
        };
    };
    expectRefused("transmissionTexture is no object", glass("x"));
    expectRefused("transmissionTexture has no index", glass(Json::object()));
    expectRefused("entry 5 of textures does not exist", glass({{"index", 5}}));
    expectRefused("index is 0.5", glass({{"index", 0.5}}));
    expectRefused("transmissionFactor is not a finite number",
                  [](Leaf& l) { l.json["materials"][0]["extensions"]["KHR_materials_transmission"]["transmissionFactor"] = "x"; });
}

}  // namespace
}  // namespace gno::host::test
