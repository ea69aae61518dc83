// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "scene_builder.hpp"

namespace gno::host::test {
namespace {

constexpr double kNear = 1e-5;

void expectNear(glm::dvec3 got, glm::dvec3 want, double tolerance = kNear) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(got[axis], want[axis], tolerance) << "axis " << axis;
}

Json lightNode(int light, Json more = Json::object()) {
    more["extensions"] = {{"KHR_lights_punctual", {{"light", light}}}};
    return more;
}

TEST(Lights, KindsPositionsAndDirections) {
    Builder builder;
    builder.json["extensionsRequired"] = {"KHR_lights_punctual"};
    builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "directional"}, {"name", "sun"}, {"intensity", 3}},
        {{"type", "point"}, {"color", {1, 0.5, 0.25}}},
        {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.3}}}},
    };
    builder.meshNode(kTriangle);
    const double h = std::sqrt(0.5);
    builder.node(lightNode(0, {{"rotation", {-h, 0, 0, h}}, {"translation", {1e6, 0, 0}}}));  // -90 degrees about x: shines down, wherever it stands
    builder.node(lightNode(1, {{"translation", {3, 4, 5}}, {"name", "lamp"}}));
    builder.node(lightNode(2, {{"translation", {0, 2, 0}}, {"scale", {7, 7, 7}}}));
    const SceneFile scene = loadBytes(builder.glb());
    EXPECT_EQ(scene.lightCount(), 3u);
    const Frame frame = scene.evaluate(0, 0);
    ASSERT_EQ(frame.lights.size(), 3u);
    EXPECT_EQ(frame.facts.lightsInFile, 3u);
    EXPECT_LT(frame.grid.exponent, 5);  // a directional light's place does not matter

    EXPECT_EQ(frame.lights[0].kind, Light::Kind::directional);
    EXPECT_EQ(frame.lights[0].name, "sun");
    EXPECT_EQ(frame.lights[0].intensity, 3.0f);
    EXPECT_EQ(frame.lights[0].homogeneous.w, 0.0f);
    expectNear(glm::normalize(glm::dvec3(frame.lights[0].homogeneous)), {0, 1, 0});

    EXPECT_EQ(frame.lights[1].kind, Light::Kind::point);
    EXPECT_EQ(frame.lights[1].name, "lamp");
    EXPECT_EQ(frame.lights[1].color, glm::vec3(1, 0.5, 0.25));
    EXPECT_EQ(frame.lights[1].homogeneous.w, 1.0f);
    expectNear(frame.grid.world(glm::vec3(frame.lights[1].homogeneous)), {3, 4, 5});

    EXPECT_EQ(frame.lights[2].kind, Light::Kind::spot);
    expectNear(frame.grid.world(glm::vec3(frame.lights[2].homogeneous)), {0, 2, 0});
    expectNear(glm::dvec3(frame.lights[2].axis), {0, 0, -1});
    EXPECT_FLOAT_EQ(frame.lights[2].innerCone, 0.1f);
    EXPECT_FLOAT_EQ(frame.lights[2].outerCone, 0.3f);
    for (const Light& light : frame.lights) EXPECT_FALSE(light.isDefault);
}

TEST(Lights, InstancesComeInNodeOrderAndOnlyFromTheScene) {
    Builder builder;
    builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
    builder.node(lightNode(0, {{"name", "one"}}));
    builder.meshNode(kTriangle);
    builder.node(lightNode(0, {{"name", "not in the scene"}}), false);
    builder.node(lightNode(0, {{"name", "two"}, {"translation", {1, 1, 1}}}));
    const Frame frame = frameOf(builder);
    ASSERT_EQ(frame.lights.size(), 2u);
    EXPECT_EQ(frame.lights[0].name, "one");
    EXPECT_EQ(frame.lights[1].name, "two");
}

TEST(Lights, AFarLightFitsOnTheGridOrIsDirectional) {
    Builder builder;
    builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
    builder.meshNode(kTriangle);
    builder.node(lightNode(0, {{"translation", {1e4, 0, 0}}}));
    const Frame frame = frameOf(builder);
    EXPECT_LE(std::abs(frame.lights[0].homogeneous.x), 1.0f);
    expectNear(frame.grid.world(glm::vec3(frame.lights[0].homogeneous)), {1e4, 0, 0}, 1e-2);
    builder.json["nodes"][1]["translation"] = {1e6, 0, 0};
    EXPECT_TRUE(frameOf(builder).lights[0].isFar);
    EXPECT_EQ(frameOf(builder).lights[0].homogeneous.w, 0.0f);
}

TEST(Defaults, LightsFollowTheirFormulas) {
    Builder builder;
    builder.meshNode(kCube, kCubeIndices, {{"scale", {2, 2, 2}}});
    const SceneFile scene = loadBytes(builder.glb());
    EXPECT_EQ(scene.lightCount(), 2u);
    EXPECT_EQ(scene.cameraCount(), 1u);
    const Frame frame = scene.evaluate(0, 0);
    ASSERT_EQ(frame.lights.size(), 2u);
    const double d = std::sqrt(12.0);
    EXPECT_EQ(frame.lights[0].kind, Light::Kind::point);
    EXPECT_EQ(frame.lights[0].homogeneous.w, 1.0f);
    expectNear(frame.grid.world(glm::vec3(frame.lights[0].homogeneous)), glm::dvec3(1) + d * glm::dvec3(0.7, 0.8, 0.1));
    EXPECT_EQ(frame.lights[1].kind, Light::Kind::directional);
    EXPECT_EQ(frame.lights[1].homogeneous.w, 0.0f);
    expectNear(glm::normalize(glm::dvec3(frame.lights[1].homogeneous)), glm::normalize(glm::dvec3(-0.6, 0.8, 0.35)));
    EXPECT_TRUE(frame.lights[0].isDefault && frame.lights[1].isDefault && frame.camera.isDefault);
    EXPECT_EQ(frame.facts.lightsInFile, 0u);
}

TEST(Defaults, CameraSeesEverything) {
    for (const glm::dvec3 scale : {glm::dvec3(1, 1, 1), glm::dvec3(1000, 1, 1), glm::dvec3(1, 1000, 1), glm::dvec3(1e-4, 1e-4, 1e-2)}) {
        Builder builder;
        builder.meshNode(kCube, kCubeIndices, {{"scale", {scale.x, scale.y, scale.z}}});
        const Frame frame = frameOf(builder);
        for (const double aspect : {1.0, 1.777, 4.0}) {
            const glm::dmat4 clip = frame.camera.clipFromGrid(aspect);
            for (const Triangle& t : frame.triangles) {
                const glm::dvec4 p = clip * glm::dvec4(glm::dvec3(t.b), 1.0);
                EXPECT_GT(p.w, 0);
                EXPECT_LE(std::abs(p.x), p.w);
                EXPECT_LE(std::abs(p.y), p.w);
                EXPECT_GT(p.z, 0);
                EXPECT_LT(p.z, p.w);
            }
        }
    }
}

Builder withCamera(const Json& camera, Json node) {
    Builder builder;
    builder.meshNode(kTriangle);
    builder.json["cameras"] = {camera};
    node["camera"] = 0;
    builder.node(node);
    return builder;
}

glm::dvec3 ndc(const Frame& frame, glm::dvec3 worldPosition, double aspect) {
    const glm::dvec3 onGrid = (worldPosition - frame.grid.origin) * frame.grid.scale();
    const glm::dvec4 clip = frame.camera.clipFromGrid(aspect) * glm::dvec4(onGrid, 1.0);
    EXPECT_GT(clip.w, 0);
    return glm::dvec3(clip) / clip.w;
}

TEST(Cameras, PerspectiveFollowsVulkan) {
    const double yfov = 2 * std::atan(0.5);
    for (const bool isInfinite : {true, false}) {
        Json lens = {{"yfov", yfov}, {"znear", 2}};
        if (!isInfinite) lens["zfar"] = 50;
        const Frame frame = frameOf(
            withCamera({{"type", "perspective"}, {"perspective", lens}}, {{"translation", {0, 0, 10}}, {"scale", {3, 3, 3}}, {"name", "eye"}}));
        EXPECT_TRUE(frame.camera.perspective);
        EXPECT_EQ(frame.camera.name, "eye");
        EXPECT_FALSE(frame.camera.isDefault);
        EXPECT_EQ(frame.facts.camerasInFile, 1u);
        const double aspect = 2;
        expectNear(ndc(frame, {0, 0, 8}, aspect), {0, 0, 1});  // at znear
        EXPECT_NEAR(ndc(frame, {0, 0, -40 + 1e-9}, aspect).z, isInfinite ? 2.0 / 50 : 0.0, kNear);
        EXPECT_NEAR(ndc(frame, {0, 0, -1e7}, aspect).z, isInfinite ? 0.0 : -2.0 / 48, kNear);
        expectNear(ndc(frame, {10, 5, 0}, aspect), {1, -1, ndc(frame, {0, 0, 0}, aspect).z});  // upper right corner: y is down
        const glm::dvec4 viewer = frame.camera.viewer();
        EXPECT_EQ(viewer.w, 1.0);
        expectNear(frame.grid.world(glm::dvec3(viewer)), {0, 0, 10});
    }
}

TEST(Cameras, OrthographicFollowsVulkan) {
    const Frame frame = frameOf(withCamera({{"type", "orthographic"}, {"orthographic", {{"xmag", 9}, {"ymag", 2}, {"znear", 1}, {"zfar", 21}}}},
                                           {{"translation", {0, 0, 11}}}));
    EXPECT_FALSE(frame.camera.perspective);
    const double aspect = 1.5;  // replaces xmag
    expectNear(ndc(frame, {3, 2, 10}, aspect), {1, -1, 1});
    expectNear(ndc(frame, {-3, -2, -10}, aspect), {-1, 1, 0});
    EXPECT_EQ(frame.camera.viewer(), glm::dvec4(0, 0, 1, 0));
}

TEST(Cameras, ShearedMirroredAndFlatNodesStillGiveARotation) {
    for (const Json& matrix : {Json{-2, 0, 0, 0, 0.5, 3, 0, 0, 0.2, 0.1, 4, 0, 1, 2, 3, 1}, Json{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 2, 3, 1},
                               Json{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 1}, Json{1, 0, 0, 0, 0, 0, 5, 0, 0, 0, 1, 0, 1, 2, 3, 1}}) {
        const Frame frame = frameOf(withCamera({{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}}, {{"matrix", matrix}}));
        const glm::dmat3 turn(frame.camera.gridFromCamera);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) EXPECT_NEAR(glm::dot(turn[i], turn[j]), i == j ? 1 : 0, 1e-12);
        EXPECT_NEAR(glm::determinant(turn), 1, 1e-12);
        expectNear(frame.grid.world(glm::dvec3(frame.camera.gridFromCamera[3])), {1, 2, 3});
    }
}

TEST(Cameras, ThatTellNoPositionsApartAreRefused) {
    const auto refusal = [](double ymag) {
        return inputError([&] {
            (void)frameOf(withCamera({{"type", "orthographic"}, {"orthographic", {{"xmag", ymag}, {"ymag", ymag}, {"znear", 1}, {"zfar", 21}}}},
                                     {{"translation", {0, 0, 11}}}));
        });
    };
    EXPECT_EQ(refusal(1e-6), "");
    EXPECT_NE(refusal(3e-30).find("camera 0: its ymag is too small"), std::string::npos) << refusal(3e-30);
}

TEST(Lights, OfASharpConeAreAccepted) {
    Builder builder;
    builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "spot"}, {"spot", {{"innerConeAngle", 0.4}, {"outerConeAngle", 0.4}}}}};
    builder.meshNode(kTriangle);
    builder.node(lightNode(0));
    EXPECT_EQ(frameOf(builder).lights[0].innerCone, frameOf(builder).lights[0].outerCone);
}

TEST(Cameras, AreChosenInNodeOrder) {
    Builder builder = withCamera({{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}}, {{"name", "first"}});
    builder.node({{"camera", 0}, {"name", "second"}});
    const SceneFile scene = loadBytes(builder.glb());
    EXPECT_EQ(scene.cameraCount(), 2u);
    EXPECT_EQ(scene.evaluate(0, 0).camera.name, "first");
    EXPECT_EQ(scene.evaluate(0, 1).camera.name, "second");
    EXPECT_NE(inputError([&] { (void)scene.evaluate(0, 2); }).find("camera 2 does not exist"), std::string::npos);
}

}  // namespace
}  // namespace gno::host::test
