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

TEST(Animation, LaterAnimationsWin) {
    Builder builder;
    const int node = builder.meshNode(kTriangle, {}, {{"matrix", {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 7, 8, 9, 1}}});
    animate(builder, node, "translation", "LINEAR", {0}, {1, 1, 1}, "VEC3", 3);
    animate(builder, node, "translation", "LINEAR", {0}, {5, 0, 0}, "VEC3", 3);
    const WorldTriangle t = world(frameOf(builder), 0);
    EXPECT_NEAR(t.a.x, 5, kNear);
    EXPECT_NEAR(t.a.y, 0, kNear);
    EXPECT_NEAR(t.b.x, 7, kNear);  // what the animation leaves alone, here the scale, stays as the node's matrix says
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
