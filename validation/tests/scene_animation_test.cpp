// SPDX-License-Identifier: MIT
// Animation, morph targets and skins.
#include <gtest/gtest.h>

#include <cmath>

#include "scene_builder.hpp"

namespace gno::host::test {
namespace {

// Adds an animation of one channel.
void animate(Builder& builder, int node, const std::string& path, const std::string& interpolation, const std::vector<float>& times,
             const std::vector<float>& values, const std::string& type, size_t width) {
    const int input = builder.floats(times, "SCALAR", 1), output = builder.floats(values, type, width);
    builder.add("animations", {{"samplers", {{{"input", input}, {"output", output}, {"interpolation", interpolation}}}},
                               {"channels", {{{"sampler", 0}, {"target", {{"node", node}, {"path", path}}}}}}});
}

glm::dvec3 firstVertex(const SceneFile& scene, uint32_t frame) { return world(scene.evaluate(frame, 0), 0).a; }

constexpr double kNear = 1e-5;

TEST(Animation, LinearTranslationIsClampedAtItsEnds) {
    Builder builder;
    const int node = builder.meshNode(kTriangle);
    animate(builder, node, "translation", "LINEAR", {1, 2}, {0, 0, 0, 30, 0, 0}, "VEC3", 3);
    const SceneFile scene = loadBytes(builder.glb());
    EXPECT_EQ(scene.lastKeyframe(), 2.0);
    EXPECT_NEAR(firstVertex(scene, 0).x, 0, kNear);
    EXPECT_NEAR(firstVertex(scene, 30).x, 0, kNear);
    EXPECT_NEAR(firstVertex(scene, 40).x, 10, kNear);
    EXPECT_NEAR(firstVertex(scene, 60).x, 30, kNear);
    EXPECT_NEAR(firstVertex(scene, 4000000000u).x, 30, kNear);
    EXPECT_EQ(scene.evaluate(0, 0).facts.animations, 1u);
}

TEST(Animation, StepHoldsAKey) {
    Builder builder;
    animate(builder, builder.meshNode(kTriangle), "translation", "STEP", {0, 1, 2}, {1, 0, 0, 2, 0, 0, 3, 0, 0}, "VEC3", 3);
    const SceneFile scene = loadBytes(builder.glb());
    for (const auto& [frame, x] : {std::pair{0u, 1.0}, {29u, 1.0}, {30u, 2.0}, {59u, 2.0}, {60u, 3.0}, {90u, 3.0}})
        EXPECT_NEAR(firstVertex(scene, frame).x, x, kNear);
}

TEST(Animation, CubicSplineFollowsHermite) {
    Builder builder;
    // in-tangent, value, out-tangent; two seconds apart
    animate(builder, builder.meshNode(kTriangle), "translation", "CUBICSPLINE", {0, 2}, {9, 9, 9, 1, 0, 0, 2, 0, 0, -1, 0, 0, 5, 0, 0, 9, 9, 9},
            "VEC3", 3);
    const SceneFile scene = loadBytes(builder.glb());
    EXPECT_NEAR(firstVertex(scene, 0).x, 1, kNear);
    EXPECT_NEAR(firstVertex(scene, 60).x, 5, kNear);
    const double t = 0.25, span = 2;
    const double want = (2 * t * t * t - 3 * t * t + 1) * 1 + span * (t * t * t - 2 * t * t + t) * 2 + (3 * t * t - 2 * t * t * t) * 5 +
                        span * (t * t * t - t * t) * -1;
    EXPECT_NEAR(firstVertex(scene, 15).x, want, kNear);
    EXPECT_NEAR(firstVertex(scene, 15).y, 0, kNear);
}

TEST(Animation, RotationTakesTheShortWayRound) {
    Builder builder;
    const int node = builder.meshNode({1, 0, 0, 2, 0, 0, 1, 1, 0});
    // 0 and 90 degrees about z, the second with its sign reversed: it is the same rotation
    animate(builder, node, "rotation", "LINEAR", {0, 1}, {0, 0, 0, 1, 0, 0, -std::sqrt(0.5f), -std::sqrt(0.5f)}, "VEC4", 4);
    const glm::dvec3 half = firstVertex(loadBytes(builder.glb()), 10);  // a third of the way: 30 degrees
    EXPECT_NEAR(half.x, std::cos(M_PI / 6), kNear);
    EXPECT_NEAR(half.y, std::sin(M_PI / 6), kNear);
}

TEST(Animation, NormalizedIntegerRotationAndScale) {
    Builder builder;
    const int node = builder.meshNode({1, 0, 0, 2, 0, 0, 1, 1, 0});
    const int input = builder.floats({0}, "SCALAR", 1);
    const int output = builder.accessor(builder.view(bytesOf(std::vector<int16_t>{0, 0, 32767, 0})), kI16, 1, "VEC4",
                                        {{"normalized", true}});  // 180 degrees about z
    const int scale = builder.positions({2, 3, 4});
    builder.add("animations", {{"samplers", {{{"input", input}, {"output", output}}, {{"input", input}, {"output", scale}}}},
                               {"channels",
                                {{{"sampler", 0}, {"target", {{"node", node}, {"path", "rotation"}}}},
                                 {{"sampler", 1}, {"target", {{"node", node}, {"path", "scale"}}}}}}});
    const WorldTriangle t = world(frameOf(builder), 0);
    EXPECT_NEAR(t.a.x, -2, kNear);
    EXPECT_NEAR(t.c.y, -3, kNear);
}

TEST(Animation, OfAllTheLaterWins) {
    Builder builder;
    const int node = builder.meshNode(kTriangle, {}, {{"matrix", {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 7, 8, 9, 1}}});
    animate(builder, node, "translation", "LINEAR", {0}, {1, 1, 1}, "VEC3", 3);
    animate(builder, node, "translation", "LINEAR", {0}, {5, 0, 0}, "VEC3", 3);
    const WorldTriangle t = world(loadBytes(builder.glb(), "scene.glb", "all").evaluate(0, 0), 0);
    EXPECT_NEAR(t.a.x, 5, kNear);
    EXPECT_NEAR(t.a.y, 0, kNear);
    EXPECT_NEAR(t.b.x, 7, kNear);  // what the animation leaves alone, here the scale, stays as the node's matrix says
}

// Clips of different lengths that move one node to x = 1, 2 and 3; the last has no name.
Builder threeClips() {
    Builder builder;
    const int node = builder.meshNode(kTriangle);
    for (float x = 1; x <= 3; ++x) animate(builder, node, "translation", "LINEAR", {0, x}, {x, 0, 0, x, 0, 0}, "VEC3", 3);
    builder.json["animations"][0]["name"] = "Idle";
    builder.json["animations"][1]["name"] = "Walk";
    return builder;
}

TEST(Clips, TheFirstIsTakenUnlessAnotherIsNamed) {
    const std::string bytes = threeClips().glb();
    const auto x = [&](const std::string& word) { return std::lround(firstVertex(loadBytes(bytes, "scene.glb", word), 30).x); };
    EXPECT_EQ(x(""), 1);
    EXPECT_EQ(x("0"), 1);
    EXPECT_EQ(x("Idle"), 1);
    EXPECT_EQ(x("1"), 2);
    EXPECT_EQ(x("Walk"), 2);
    EXPECT_EQ(x("2"), 3);
    EXPECT_EQ(x("all"), 3) << "the later one wins";
    const SceneFile first = loadBytes(bytes), all = loadBytes(bytes, "scene.glb", "all");
    EXPECT_EQ(first.clip(), 0u);
    EXPECT_EQ(first.lastKeyframe(), 1);
    EXPECT_EQ(all.clip(), std::nullopt);
    EXPECT_EQ(all.lastKeyframe(), 3);
    ASSERT_EQ(first.clips().size(), 3u);
    EXPECT_EQ(first.clips()[1].name, "Walk");
    EXPECT_EQ(first.clips()[1].lastKeyframe, 2);
    EXPECT_EQ(noticeOf(first, "animation"), "number 0 (Idle) of 3 is taken; --animation N|NAME|all takes another, gnomon effects lists them");
    EXPECT_EQ(noticeOf(all, "animation"), "");
}

TEST(Clips, OfOtherNamesAreRefused) {
    Builder builder = threeClips();
    const auto refusal = [&](const std::string& word) { return inputError([&] { (void)loadBytes(builder.glb(), "scene.glb", word); }); };
    EXPECT_EQ(refusal("1"), "");
    for (const char* word : {"3", "-1", "1.0", "walk", "All", " 1"})
        EXPECT_NE(refusal(word).find("there is none; the file has 0 (Idle), 1 (Walk), 2"), std::string::npos) << refusal(word);
    builder.json["animations"][2]["name"] = "7";
    EXPECT_EQ(refusal("7"), "") << "a name, where no number is as large";
    builder.json["animations"][2]["name"] = "Walk";
    EXPECT_NE(refusal("Walk").find("2 animations are called so"), std::string::npos) << refusal("Walk");
    builder.json.erase("animations");
    EXPECT_NE(refusal("0").find("--animation 0: the file has no animations"), std::string::npos) << refusal("0");
    EXPECT_EQ(loadBytes(builder.glb()).clip(), std::nullopt);
}

// As animate(), by a pointer.
void animateByPointer(Builder& builder, const std::string& pointer, const std::string& interpolation, const std::vector<float>& values,
                      const std::string& type, size_t width) {
    animate(builder, 0, "pointer", interpolation, {0, 1}, values, type, width);
    builder.json["animations"].back()["channels"][0]["target"] = {{"path", "pointer"},
                                                                  {"extensions", {{"KHR_animation_pointer", {{"pointer", pointer}}}}}};
}

TEST(Pointers, AtNodesAreObeyed) {
    Builder builder;
    const int node = builder.meshNode(kTriangle);
    builder.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", builder.positions({0, 0, 1, 0, 0, 0, 0, 0, 0})}}};
    builder.json["extensionsRequired"] = {"KHR_animation_pointer"};
    const std::string at = "/nodes/" + std::to_string(node) + "/";
    animateByPointer(builder, at + "translation", "LINEAR", {0, 0, 0, 8, 0, 0}, "VEC3", 3);
    animateByPointer(builder, at + "scale", "LINEAR", {1, 1, 1, 3, 3, 3}, "VEC3", 3);
    animateByPointer(builder, at + "rotation", "STEP", {0, 0, 1, 0, 0, 0, 0, 1}, "VEC4", 4);
    animateByPointer(builder, at + "weights", "LINEAR", {0, 2}, "SCALAR", 1);
    const WorldTriangle t = world(loadBytes(builder.glb(), "scene.glb", "all").evaluate(15, 0), 0);
    EXPECT_NEAR(t.a.x, 4, kNear);
    EXPECT_NEAR(t.a.z, 2, kNear) << "a weight of 1, scaled by 2";
    EXPECT_NEAR(t.b.x, 2, kNear) << "half a turn about z";
}

TEST(Pointers, AtOtherThingsAreTold) {
    for (const char* pointer : {"/materials/0/pbrMetallicRoughness/baseColorFactor", "/nodes/0/weights/0", "/nodes/0/extras/x", "/nodes/0",
                                "/nodes/x/scale", "/nodes/-1/scale", "nodes/0/scale", "", "/nodes/0/extensions/KHR_node_visibility"}) {
        Builder builder;
        builder.meshNode(kTriangle);
        animateByPointer(builder, pointer, "LINEAR", {0, 0, 0, 8, 0, 0}, "VEC3", 3);
        const SceneFile scene = loadBytes(builder.glb());
        EXPECT_EQ(noticeOf(scene, std::string("animation of ") + pointer), "not applied") << pointer;
        EXPECT_NEAR(firstVertex(scene, 15).x, 0, kNear);
    }
    Builder builder;
    animate(builder, builder.meshNode(kTriangle), "shear", "LINEAR", {0, 1}, {0, 0, 0, 8, 0, 0}, "VEC3", 3);
    EXPECT_EQ(noticeOf(loadBytes(builder.glb()), "animation of shear"), "not applied");
    builder.json["animations"][0]["channels"][0]["target"] = {{"path", "scale"}};
    EXPECT_EQ(noticeOf(loadBytes(builder.glb()), "animation of scale of no node"), "not applied");
}

TEST(Pointers, ThatAreNoneAreRefused) {
    Builder builder;
    builder.meshNode(kTriangle);
    animateByPointer(builder, "/nodes/0/translation", "LINEAR", {0, 0, 0, 8, 0, 0}, "VEC3", 3);
    const auto refusal = [&](const Json& target) {
        builder.json["animations"][0]["channels"][0]["target"] = target;
        return inputError([&] { (void)loadBytes(builder.glb()); });
    };
    const auto pointing = [](const Json& pointer) {
        return Json{{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", pointer}}}}}};
    };
    const auto expect = [&](const Json& target, const char* words) { EXPECT_NE(refusal(target).find(words), std::string::npos) << refusal(target); };
    expect(pointing("/nodes/1/translation"), "node 1 does not exist, there are 1");
    expect(pointing("/nodes/18446744073709551615/translation"), "does not exist");
    expect(pointing(7), "has no pointer");
    expect({{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", Json::object()}}}}, "has no pointer");
    expect({{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", 7}}}}, "is not an object");
    expect({{"path", 7}}, "has no path");
    expect(7, "has no target");
    expect(pointing("/nodes/0/rotation"), "wrong type");
}

// A cube, hidden or not, above a node with a triangle.
struct TwoLayers : Builder {
    TwoLayers() {
        meshNode(kTriangle);
        node({{"mesh", mesh({{"attributes", {{"POSITION", 0}}}})}, {"translation", {9, 0, 0}}}, false);
        node({{"children", {1}}});
    }
    void setVisible(int index, const Json& visible) { json["nodes"][index]["extensions"]["KHR_node_visibility"] = {{"visible", visible}}; }
};

TEST(Visibility, HidesANodeAndAllBelowIt) {
    TwoLayers layers;
    EXPECT_EQ(frameOf(layers).triangles.size(), 2u);
    layers.setVisible(2, true);
    EXPECT_EQ(frameOf(layers).triangles.size(), 2u);
    layers.setVisible(2, false);
    layers.setVisible(1, true);
    const Frame frame = frameOf(layers);
    ASSERT_EQ(frame.triangles.size(), 1u) << "a visible node below a hidden one is hidden";
    EXPECT_LT(world(frame, 0).b.x, 2);
    EXPECT_LT(frame.grid.exponent, 3) << "what is hidden takes no room on the grid";
    EXPECT_EQ(frame.facts.objects, 1u);
    layers.json["nodes"][2]["extensions"]["KHR_node_visibility"] = Json::object();
    EXPECT_EQ(frameOf(layers).triangles.size(), 2u) << "visible is the default";
    layers.setVisible(0, false);
    layers.setVisible(1, false);
    EXPECT_NE(inputError([&] { (void)frameOf(layers); }).find("all meshes of the scene are hidden"), std::string::npos);
    for (const Json& wrong : {Json(1), Json("false"), Json()}) {
        layers.setVisible(0, wrong);
        EXPECT_NE(inputError([&] { (void)frameOf(layers); }).find("neither true nor false"), std::string::npos);
    }
}

TEST(Visibility, OfLightsButNotOfCameras) {
    TwoLayers layers;
    layers.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
    layers.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
    layers.json["nodes"][1].update({{"camera", 0}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    EXPECT_FALSE(frameOf(layers).lights[0].isDefault);
    layers.setVisible(2, false);
    const Frame frame = frameOf(layers);
    EXPECT_TRUE(frame.lights[0].isDefault);
    EXPECT_FALSE(frame.camera.isDefault) << "a camera sees from wherever it stands";
}

TEST(Visibility, IsAnimatedByPointer) {
    TwoLayers layers;
    layers.setVisible(0, false);
    const std::string at = "/nodes/0/extensions/KHR_node_visibility/visible";
    const int input = layers.floats({0, 1, 2}, "SCALAR", 1), output = layers.accessor(layers.view(std::string("\0\1\0", 3)), kU8, 3, "SCALAR");
    layers.json["animations"] = {
        {{"samplers", {{{"input", input}, {"output", output}, {"interpolation", "STEP"}}}},
         {"channels", {{{"sampler", 0}, {"target", {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", at}}}}}}}}}}}};
    const SceneFile scene = loadBytes(layers.glb());
    const auto count = [&](uint32_t frame) { return scene.evaluate(frame, 0).triangles.size(); };
    EXPECT_EQ(count(0), 1u);
    EXPECT_EQ(count(29), 1u);
    EXPECT_EQ(count(30), 2u);
    EXPECT_EQ(count(60), 1u);
    layers.setVisible(2, false);
    const SceneFile alone = loadBytes(layers.glb());
    EXPECT_EQ(alone.evaluate(30, 0).triangles.size(), 1u);
    EXPECT_NE(inputError([&] { (void)alone.evaluate(0, 0); }).find("all meshes are hidden in this frame"), std::string::npos);
    layers.json["animations"][0]["samplers"][0].erase("interpolation");
    EXPECT_NE(inputError([&] { (void)loadBytes(layers.glb()); }).find("has to be STEP"), std::string::npos);
}

TEST(Animation, ParentsMoveObjectsLightsAndCameras) {
    Builder builder;
    builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
    builder.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
    builder.meshNode(kTriangle);
    builder.node({{"camera", 0}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}}, false);
    builder.json["scenes"][0]["nodes"] = {2};
    animate(builder, builder.node({{"children", {0, 1}}}, false), "translation", "LINEAR", {0, 1}, {0, 0, 0, 0, 4, 0}, "VEC3", 3);
    const Frame frame = frameOf(builder, 15);
    EXPECT_NEAR(world(frame, 0).a.y, 2, kNear);
    EXPECT_NEAR(frame.grid.world(glm::vec3(frame.lights[0].homogeneous)).y, 2, kNear);
    EXPECT_NEAR(frame.grid.world(glm::dvec3(frame.camera.gridFromCamera[3])).y, 2, kNear);
}

TEST(Morph, WeightsOfMeshNodeAndAnimation) {
    Builder builder;
    const int node = builder.meshNode(kTriangle);
    builder.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", builder.positions({1, 0, 0, 0, 0, 0, 0, 0, 0})}},
                                                             {{"POSITION", builder.positions({0, 0, 2, 0, 0, 0, 0, 0, 0})}}};
    EXPECT_NEAR(world(frameOf(builder), 0).a.z, 0, kNear);
    builder.json["meshes"][0]["weights"] = {0.25, 0.5};
    EXPECT_NEAR(world(frameOf(builder), 0).a.x, 0.25, kNear);
    EXPECT_NEAR(world(frameOf(builder), 0).a.z, 1, kNear);
    builder.json["nodes"][0]["weights"] = {0, 1};
    EXPECT_NEAR(world(frameOf(builder), 0).a.x, 0, kNear);
    EXPECT_NEAR(world(frameOf(builder), 0).a.z, 2, kNear);
    animate(builder, node, "weights", "LINEAR", {0, 1}, {0, 0, 0, 3}, "SCALAR", 1);
    EXPECT_NEAR(world(frameOf(builder, 15), 0).a.z, 3, kNear);
    EXPECT_EQ(frameOf(builder).facts.morphTargets, 2u);
}

// Two joints at x = 0 and x = 10; the second bends by 90 degrees about z. One vertex on each, one half on both.
Builder skinned(int jointType, int weightType) {
    Builder builder;
    const int node = builder.meshNode({0, 0, 0, 12, 0, 0, 10, 0, 2});
    auto& attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
    const std::vector<int> joints{0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0};
    attributes["JOINTS_0"] = builder.accessor(builder.view(jointType == kU8 ? bytesOf(std::vector<uint8_t>(joints.begin(), joints.end()))
                                                                            : bytesOf(std::vector<uint16_t>(joints.begin(), joints.end()))),
                                              jointType, 3, "VEC4");
    std::string weights;
    if (weightType == kF32) weights = bytesOf(std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 0.5, 0.5, 0, 0});
    if (weightType == kU8) weights = bytesOf(std::vector<uint8_t>{255, 0, 0, 0, 255, 0, 0, 0, 100, 100, 0, 0});
    if (weightType == kU16) weights = bytesOf(std::vector<uint16_t>{65535, 0, 0, 0, 65535, 0, 0, 0, 30000, 30000, 0, 0});
    attributes["WEIGHTS_0"] = builder.accessor(builder.view(weights), weightType, 3, "VEC4", {{"normalized", weightType != kF32}});
    const int base = builder.node({{"children", {2}}});
    const int tip = builder.node({{"translation", {10, 0, 0}}, {"rotation", {0, 0, std::sqrt(0.5), std::sqrt(0.5)}}}, false);
    const int inverse =
        builder.floats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -10, 0, 0, 1}, "MAT4", 16);
    builder.add("skins", {{"joints", {base, tip}}, {"inverseBindMatrices", inverse}});
    builder.json["nodes"][node]["skin"] = 0;
    builder.json["nodes"][node]["translation"] = {100, 100, 100};  // a skin replaces its node's transformation
    return builder;
}

TEST(Skin, BlendsJointMatrices) {
    for (const int jointType : {kU8, kU16}) {
        for (const int weightType : {kF32, kU8, kU16}) {
            const WorldTriangle t = world(frameOf(skinned(jointType, weightType)), 0);
            EXPECT_NEAR(glm::length(t.a - glm::dvec3(0, 0, 0)), 0, kNear);
            EXPECT_NEAR(glm::length(t.b - glm::dvec3(10, 2, 0)), 0, kNear);
            EXPECT_NEAR(glm::length(t.c - glm::dvec3(10, 0, 2)), 0, kNear);
        }
    }
}

TEST(Skin, MovesWithItsJoints) {
    Builder builder = skinned(kU8, kF32);
    animate(builder, 2, "rotation", "LINEAR", {0, 1}, {0, 0, 0, 1, 0, 0, 1, 0}, "VEC4", 4);
    const WorldTriangle t = world(frameOf(builder, 30), 0);  // the tip turned by 180 degrees
    EXPECT_NEAR(glm::length(t.b - glm::dvec3(8, 0, 0)), 0, kNear);
    EXPECT_EQ(frameOf(builder).facts.skins, 1u);
}

TEST(Skin, WithoutInverseBindMatrices) {
    Builder builder = skinned(kU8, kF32);
    builder.json["skins"][0].erase("inverseBindMatrices");
    EXPECT_NEAR(glm::length(world(frameOf(builder), 0).b - glm::dvec3(10, 12, 0)), 0, kNear);
}

}  // namespace
}  // namespace gno::host::test
