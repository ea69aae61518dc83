// SPDX-License-Identifier: MIT
// Hull culling's planes: nothing between the light and a point of the frustum is ever outside of one of them, and what clearly lies elsewhere is.
#include "host_min/frame/cull_hull.hpp"

#include <gtest/gtest.h>

#include "validation/tests/cull_hull_cases.hpp"

namespace gno {
namespace {

using test::LightPlace;

constexpr uint32_t kSeed = 2016;

/// As glsl/core/caster_state.glsl asks, in fp32.
bool culled(const std::vector<glm::vec4>& planes, glm::vec3 q) {
    return std::any_of(planes.begin(), planes.end(), [&](glm::vec4 plane) { return plane.x * q.x + plane.y * q.y + plane.z * q.z + plane.w < 0; });
}

struct Tally {
    uint64_t inside = 0, outside = 0, kept = 0;  ///< kept: of those outside
};

Tally tally(LightPlace place, bool finite, int configurations, int points) {
    test::Random random(kSeed + uint32_t(place));
    Tally result;
    for (int i = 0; i < configurations;) {
        const host::Camera camera = test::randomCamera(random);
        if ((camera.zfar > 0) != finite) continue;
        ++i;
        const double aspect = random.between(0.3, 3);
        const glm::vec4 light = test::randomLight(random, camera, aspect, place);
        const auto planes = host::cullHull(camera, aspect, light);
        EXPECT_LE(planes.size(), host::kMaxCullPlanes);
        for (int k = 0; k < points; ++k) {
            const glm::vec3 q(random.inBox(1));
            if (test::inHull(camera, aspect, light, q, 0)) {
                ++result.inside;
                EXPECT_FALSE(culled(planes, q)) << "configuration " << i << ", point " << q.x << ' ' << q.y << ' ' << q.z;
            } else if (!test::inHull(camera, aspect, light, q, 1e-2)) {
                ++result.outside;
                result.kept += !culled(planes, q);
            }
            if (testing::Test::HasFailure()) return result;
        }
    }
    return result;
}

class CullHull : public testing::TestWithParam<LightPlace> {};

TEST_P(CullHull, FiniteFarPlane) {
    const Tally t = tally(GetParam(), true, 400, 500);
    std::printf("seed %u: %llu points in the hull; of %llu elsewhere %llu are kept\n", kSeed, static_cast<unsigned long long>(t.inside),
                static_cast<unsigned long long>(t.outside), static_cast<unsigned long long>(t.kept));
    EXPECT_GT(t.inside, 10000u);
    EXPECT_GT(t.outside, 10000u);
    EXPECT_LT(double(t.kept), 0.01 * double(t.outside));
}

TEST_P(CullHull, InfiniteFarPlane) {
    const Tally t = tally(GetParam(), false, 400, 500);
    std::printf("seed %u: %llu points in the hull; of %llu elsewhere %llu are kept\n", kSeed, static_cast<unsigned long long>(t.inside),
                static_cast<unsigned long long>(t.outside), static_cast<unsigned long long>(t.kept));
    EXPECT_GT(t.inside, 10000u);
    EXPECT_GT(t.outside, 10000u);
    EXPECT_LT(double(t.kept), 0.01 * double(t.outside));
}

INSTANTIATE_TEST_SUITE_P(Light, CullHull,
                         testing::Values(LightPlace::inside, LightPlace::behind, LightPlace::anywhere, LightPlace::far, LightPlace::directional,
                                         LightPlace::alongTheView, LightPlace::alongAnAxis));

host::Camera straightCamera() {
    host::Camera camera;  // at (0, 0, 0.5), looks along -z, 90 degrees, 0.1 .. 1
    camera.gridFromCamera[3] = glm::dvec4(0, 0, 0.5, 1);
    camera.yfov = 1.5707963267948966;
    camera.znear = 0.1;
    camera.zfar = 1;
    return camera;
}

TEST(CullHullByHand, LightInsideTheFrustumLeavesItsSixFaces) {
    const auto planes = host::cullHull(straightCamera(), 1, {0, 0, 0, 1});
    EXPECT_EQ(planes.size(), 6u);
    EXPECT_TRUE(culled(planes, {0, 0, 0.45f}));   // before the near plane
    EXPECT_TRUE(culled(planes, {0, 0, -0.55f}));  // behind the far plane
    EXPECT_TRUE(culled(planes, {0.6f, 0, 0}));
    EXPECT_FALSE(culled(planes, {0.4f, -0.4f, 0}));
}

TEST(CullHullByHand, LightBehindTheCamera) {
    const auto planes = host::cullHull(straightCamera(), 1, {0, 0, 1, 1});
    EXPECT_FALSE(culled(planes, {0, 0, 0.45f}));  // between light and near plane
    EXPECT_FALSE(culled(planes, {0, 0, 0.9f}));
    EXPECT_TRUE(culled(planes, {0.5f, 0, 0.9f}));
    EXPECT_TRUE(culled(planes, {0, 0, -0.55f}));
}

TEST(CullHullByHand, DirectionalLightFromAbove) {
    const auto planes = host::cullHull(straightCamera(), 1, {0, 1, 0, 0});
    EXPECT_FALSE(culled(planes, {0, 0.99f, 0}));  // above the frustum
    EXPECT_TRUE(culled(planes, {0, -0.7f, 0}));   // below it
    EXPECT_TRUE(culled(planes, {0.7f, 0.9f, 0}));
}

}  // namespace
}  // namespace gno
