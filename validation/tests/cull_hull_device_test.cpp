// SPDX-License-Identifier: MIT
// Hull culling on the device: whatever camera and light, it leaves every sample's answer as it is, and it drops exactly the casters that the planes
// exclude.
#include <gtest/gtest.h>

#include "host_min/frame/cull_hull.hpp"
#include "validation/support/device_test.hpp"
#include "validation/tests/cull_hull_cases.hpp"

namespace gno {
namespace {

constexpr uint32_t kSeed = 11;
constexpr uint32_t kWidth = 61, kHeight = 47;

host::Frame makeFrame(test::Random& random, uint32_t triangles) {
    host::Frame frame;
    const auto snap = [](glm::dvec3 p) { return glm::vec3(host::snapCoordinate(p.x), host::snapCoordinate(p.y), host::snapCoordinate(p.z)); };
    while (frame.triangles.size() < triangles) {
        const glm::dvec3 centre = random.inBox(0.9);
        frame.triangles.push_back({snap(centre + random.inBox(0.1)), snap(centre + random.inBox(0.1)), snap(centre + random.inBox(0.1))});
    }
    frame.material.assign(triangles, 0);
    frame.object.assign(triangles, 0);
    frame.closed.assign(triangles, 0);
    return frame;
}

std::vector<uint32_t> mask(host::FrameInputs& inputs, glm::vec4 light, host::Cull cull) {
    inputs.setLight(light, cull);
    host::StructureCache structures;
    host::Technique& technique = host::techniqueByName("d-stackless");
    return technique.run(inputs, structures, host::Settings(technique.info().settings, {}), {host::Precision::certified, 1, false, false})
        .visibility;
}

uint64_t keptByThePlanes(const host::Frame& frame, glm::vec4 light) {
    const auto planes = host::cullHull(frame.camera, double(kWidth) / kHeight, light);
    uint64_t kept = 0;
    for (const host::Triangle& t : frame.triangles)
        kept += std::none_of(planes.begin(), planes.end(), [&](glm::vec4 plane) {
            const auto outside = [&](glm::vec3 p) { return plane.x * p.x + plane.y * p.y + plane.z * p.z + plane.w < 0; };
            return outside(t.a) && outside(t.b) && outside(t.c);
        });
    return kept;
}

TEST(CullHullDevice, TheMaskStays) {
    std::printf("seed %u\n", kSeed);
    test::Random random(kSeed);
    uint64_t dropped = 0, shadowed = 0, lit = 0;
    for (uint32_t camera = 0; camera < 6; ++camera) {
        host::Frame frame = makeFrame(random, 1500);
        frame.camera = test::randomCamera(random);
        host::FrameInputs inputs(test::passes(), frame, kWidth, kHeight);
        for (const test::LightPlace place :
             {test::LightPlace::inside, test::LightPlace::behind, test::LightPlace::anywhere, test::LightPlace::directional}) {
            const glm::vec4 light = test::randomLight(random, frame.camera, double(kWidth) / kHeight, place);
            const std::vector<uint32_t> want = mask(inputs, light, host::Cull::none);
            const uint64_t all = inputs.casterCount();
            const std::vector<uint32_t> got = mask(inputs, light, host::Cull::hull);
            EXPECT_EQ(got, want) << "camera " << camera << ", light place " << int(place);
            EXPECT_EQ(inputs.casterCount(), keptByThePlanes(frame, light)) << "camera " << camera << ", light place " << int(place);
            dropped += all - inputs.casterCount();
            shadowed += uint64_t(std::count(want.begin(), want.end(), GNO_VISIBILITY_SHADOW));
            lit += uint64_t(std::count(want.begin(), want.end(), GNO_VISIBILITY_LIT));
        }
    }
    EXPECT_GT(dropped, 6u * 4u * 1500u / 10u);
    EXPECT_GT(shadowed, 1000u);
    EXPECT_GT(lit, 1000u);
}

// The comparison above can fail: without the casters that it keeps, the mask is another one.
TEST(CullHullDevice, CastersOutsideTheViewMatter) {
    host::Frame frame;
    frame.triangles = {{{-0.5f, -0.5f, -0.5f}, {0.5f, -0.5f, -0.5f}, {0, 0.5f, -0.5f}},  // seen
                       {{-0.5f, -0.5f, 0.75f}, {0.5f, -0.5f, 0.75f}, {0, 0.5f, 0.75f}},  // behind the camera, before the light
                       {{0.75f, 0.75f, 0.75f}, {1, 0.75f, 0.75f}, {1, 1, 0.75f}}};       // neither
    frame.material = frame.object = {0, 0, 0};
    frame.closed = {0, 0, 0};
    frame.camera.gridFromCamera[3] = glm::dvec4(0, 0, 0.25, 1);
    host::FrameInputs inputs(test::passes(), frame, kWidth, kHeight);
    const glm::vec4 light(0, 0, 1, 1);
    const std::vector<uint32_t> got = mask(inputs, light, host::Cull::hull);
    EXPECT_EQ(inputs.casterCount(), 2u);
    EXPECT_GT(std::count(got.begin(), got.end(), GNO_VISIBILITY_SHADOW), 0);
    EXPECT_EQ(got, mask(inputs, light, host::Cull::none));
    EXPECT_EQ(inputs.casterCount(), 3u);
}

}  // namespace
}  // namespace gno
