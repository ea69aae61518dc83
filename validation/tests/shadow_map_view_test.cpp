// SPDX-License-Identifier: MIT
// glsl/shadow_map/view.h, project.glsl and fit.glsl, compiled as C++, against long double: projections, depths, bias, bounds; and the host's choice
// of views.
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <set>

#include "host_min/techniques/shadow_views.hpp"
#include "validation/support/glsl_as_cpp.hpp"

namespace gno {
#include "glsl/core/orient3d.glsl"
}  // namespace gno
#define GNO_LOAD_CULL_PLANE(index_) vec4(float(index_))
#include "glsl/shadow_map/project.glsl"
namespace gno {
namespace {

vec4 gLight;
std::vector<GnoShadowMapView> gViews;
std::vector<uint> gBounds;

}  // namespace
#define GNO_LIGHT gLight
#define GNO_SHADOW_MAP_VIEW_COUNT uint(gViews.size())
#define GNO_SHADOW_MAP_LOAD_VIEW(index_) gViews[index_]
#define GNO_SHADOW_MAP_BOUNDS gBounds
#include "glsl/shadow_map/fit.glsl"
namespace {

using Real = long double;
constexpr uint32_t kSeed = 1978;

class Random {
public:
    double real(double low = -1, double high = 1) { return low + (high - low) * double(engine_()) / double(engine_.max()); }
    vec3 inCube(double half = 1) {
        const double x = real(-half, half), y = real(-half, half), z = real(-half, half);
        return vec3(float(x), float(y), float(z));
    }

private:
    std::mt19937 engine_{kSeed};
};

Real dotOf(vec3 a, vec3 b) { return Real(a.x) * b.x + Real(a.y) * b.y + Real(a.z) * b.z; }

host::Frame frameWith(std::vector<host::Light> lights) {
    host::Frame frame;
    frame.lights = std::move(lights);
    return frame;
}

host::Light spot(vec3 axis, float cone) {
    host::Light light;
    light.kind = host::Light::Kind::spot;
    light.homogeneous = vec4(0.25f, 0.5f, -0.125f, 1);
    light.axis = axis;
    light.outerCone = cone;
    return light;
}

/// Where q lies in a frustum, by the definition of `rect`: 0 .. 1 inside, to the right and downwards.
std::array<Real, 2> place(const host::ShadowFrustum& f, vec3 q) {
    const Real w = f.perspective ? dotOf(f.forward, q) : 1;
    return {(dotOf(f.right, q) / w - f.rect.x) / (f.rect.y - f.rect.x), (dotOf(f.down, q) / w - f.rect.z) / (f.rect.w - f.rect.z)};
}

std::vector<host::ShadowFrustum> kinds() {
    host::ShadowFrustum prism = host::shadowFrusta({}, vec4(-0.375f, 1, 0.5f, 0)).at(0);
    prism.rect = vec4(-0.75f, 0.5f, -1, 0.25f);
    prism.near = -1.25f;
    prism.far = 0.75f;
    host::ShadowFrustum cut = host::shadowFrusta({}, vec4(0, 0, 0, 1)).at(3);
    cut.rect = vec4(-0.125f, 0.75f, 0.25f, 0.5f);
    return {host::shadowFrusta({}, vec4(0, 0, 0, 1)).at(0), cut,
            host::shadowFrusta(frameWith({spot(vec3(0.6f, -0.8f, 0), 0.5f)}), spot({}, 0).homogeneous).at(0), prism};
}

TEST(ShadowMapView, TexelsAndDepthsAreTheDefinitions) {
    Random random;
    constexpr uint kSize = 1000;
    for (const host::ShadowFrustum& f : kinds()) {
        const GnoShadowMapView view = f.view();
        int inside = 0;
        for (int i = 0; i < 20000; ++i) {
            const vec3 q = random.inCube();
            const vec4 clip = gnoShadowMapClip(view, q);
            const auto at = place(f, q);
            const Real w = f.perspective ? dotOf(f.forward, q) : 1;
            const Real off = 1e-5L;  // of fp32
            if (w < 1e-3L) continue;
            const bool holds = at[0] >= 0 && at[0] <= 1 && at[1] >= 0 && at[1] <= 1;
            const bool edge = std::min(std::min(std::abs(at[0]), std::abs(at[0] - 1)), std::min(std::abs(at[1]), std::abs(at[1] - 1))) < off;
            if (edge) continue;
            ASSERT_EQ(gnoShadowMapHolds(clip), holds) << double(at[0]) << " " << double(at[1]);
            if (!holds) continue;
            ++inside;
            const uvec2 texel = gnoShadowMapTexel(clip, kSize);
            ASSERT_NEAR(double(at[0] * kSize), texel.x + 0.5, 0.5 + double(off * kSize));
            ASSERT_NEAR(double(at[1] * kSize), texel.y + 0.5, 0.5 + double(off * kSize));
            const Real depth =
                f.perspective ? Real(GNO_SHADOW_MAP_NEAR) / w : std::max(Real(0), (f.far - dotOf(f.forward, q)) / (Real(f.far) - f.near));
            ASSERT_NEAR(double(gnoShadowMapDepth(view, clip)), double(depth), double(depth) * 1e-6 + (f.perspective ? 0 : 1e-6));
        }
        EXPECT_GT(inside, 100);
    }
}

TEST(ShadowMapView, EdgesBelongToIt) {
    EXPECT_TRUE(gnoShadowMapHolds(vec4(2, -2, 0, 2)));
    EXPECT_FALSE(gnoShadowMapHolds(vec4(std::nextafter(2.0f, 3.0f), 0, 0, 2)));
    EXPECT_FALSE(gnoShadowMapHolds(vec4(0, 0, 0, 0))) << "the light itself";
    EXPECT_FALSE(gnoShadowMapHolds(vec4(0, 0, 0, -1)));
    EXPECT_EQ(gnoShadowMapTexel(vec4(1, -1, 0, 1), 512), uvec2(511, 0));
    EXPECT_EQ(gnoShadowMapTexel(vec4(-1, 1, 0, 1), 512), uvec2(0, 511));
}

TEST(ShadowMapView, DepthFallsWithDistanceAndIsNeverBelowZero) {
    for (const host::ShadowFrustum& f : kinds()) {
        float last = 2;
        for (float t = f.perspective ? 0.01f : -1.25f; t < 3; t += 0.01f) {
            const float depth = gnoShadowMapDepth(f.view(), gnoShadowMapClip(f.view(), f.forward * t));
            EXPECT_TRUE(depth < last || (depth == 0 && !f.perspective && t > f.far)) << t;
            EXPECT_GE(depth, 0);
            last = depth;
        }
    }
}

/// A sample counts as the point that lies nearer to the light by so many widths of a texel there.
TEST(ShadowMapView, ConstantBiasIsInTexels) {
    Random random;
    for (const host::ShadowFrustum& f : kinds())
        for (const float texels : {0.0f, 0.05f, 1.0f, 17.5f}) {
            constexpr uint kSize = 512;
            const GnoShadowMapView plain = f.view(), moved = gnoShadowMapConstantBias(f.view(), texels, float(kSize));
            for (int i = 0; i < 500; ++i) {
                const vec3 q = random.inCube(0.7);
                const Real along = dotOf(f.forward, q);
                if (f.perspective ? along < 0.01L : along > f.far) continue;
                const Real width = std::max(f.rect.y - f.rect.x, f.rect.w - f.rect.z) / Real(kSize) * (f.perspective ? along : 1);
                const vec3 nearer = q - f.forward * float(texels * width);
                const float want = gnoShadowMapDepth(plain, gnoShadowMapClip(plain, nearer));
                ASSERT_NEAR(gnoShadowMapDepth(moved, gnoShadowMapClip(moved, q)), want, 4e-6 * (f.perspective ? want : 1)) << texels;
            }
        }
    const GnoShadowMapView all = gnoShadowMapConstantBias(kinds().at(0).view(), 64, 16);
    EXPECT_TRUE(std::isfinite(all.bias.x) && all.bias.x > 1) << "more than the whole distance: in front of everything";
}

TEST(ShadowMapFit, HoldsEverySampleAndLittleMore) {
    Random random;
    for (const host::ShadowFrustum& f : kinds()) {
        for (const double half : {0.3, 0.01, 0.0}) {
            gLight = vec4(0, 0, 0, f.perspective ? 1.0f : 0.0f);
            gViews = {f.view()};
            gBounds.assign(4, 0);
            const vec2 middle((f.rect.x + f.rect.y) / 2, (f.rect.z + f.rect.w) / 2);
            const vec3 at = f.forward * 0.5f + (f.right * middle.x + f.down * middle.y) * (f.perspective ? 0.5f : 1.0f);
            std::vector<vec3> samples;
            for (int i = 0; i < 100; ++i)
                samples.push_back(at + (f.right * float(random.real(-half, half)) + f.down * float(random.real(-half, half))) * 0.2f);
            std::array<Real, 4> need{2, -1, 2, -1};
            for (const vec3& p : samples) {
                gnoShadowMapMeasure(GnoViewSample{p, GNO_NO_CASTER});
                const auto where = place(f, p);
                need = {std::min(need[0], where[0]), std::max(need[1], where[0]), std::min(need[2], where[1]), std::max(need[3], where[1])};
            }
            const auto fitted = host::fitShadowFrusta(std::span(&f, 1), gBounds, {}, true);
            ASSERT_EQ(fitted.size(), 1u);
            for (const vec3& p : samples) EXPECT_TRUE(gnoShadowMapHolds(gnoShadowMapClip(fitted[0].view(), p)));
            EXPECT_LT((fitted[0].rect.y - fitted[0].rect.x) / (f.rect.y - f.rect.x), (need[1] - need[0]) * 1.01L + 1e-5L);
            EXPECT_LT((fitted[0].rect.w - fitted[0].rect.z) / (f.rect.w - f.rect.z), (need[3] - need[2]) * 1.01L + 1e-5L);
            EXPECT_GT(fitted[0].rect.y, fitted[0].rect.x);
            EXPECT_GT(fitted[0].rect.w, fitted[0].rect.z);
        }
    }
}

TEST(ShadowMapFit, EveryPositionHasAView) {
    Random random;
    const host::Light cone = spot(vec3(0, -1, 0), 0.4f);
    const std::vector<std::pair<host::Frame, vec4>> lights{
        {{}, vec4(0.25f, -0.5f, 0.125f, 1)}, {frameWith({cone}), cone.homogeneous}, {{}, vec4(0.5f, 1, -0.25f, 0)}};
    for (const auto& [frame, light] : lights) {
        const auto frusta = host::shadowFrusta(frame, light);
        gLight = light;
        gViews.clear();
        for (const auto& f : frusta) gViews.push_back(f.view());
        std::set<size_t> used;
        for (int i = 0; i < 20000; ++i) {
            vec3 p = random.inCube();
            if (i % 4 == 0 && light.w != 0) p = vec3(light) + glm::round(random.inCube() * 2.0f) * 0.0625f;  // along edges and corners of the cube
            gBounds.assign(4 * gViews.size(), 0);
            gnoShadowMapMeasure(GnoViewSample{p, GNO_NO_CASTER});
            const auto hit = std::find_if(gBounds.begin(), gBounds.end(), [](uint b) { return b != 0; });
            if (p == vec3(light) && light.w != 0) continue;
            ASSERT_NE(hit, gBounds.end()) << p.x << " " << p.y << " " << p.z;
            used.insert(size_t(hit - gBounds.begin()) / 4);
        }
        EXPECT_EQ(used.size(), frusta.size());
    }
}

TEST(ShadowMapFit, ViewsWithoutSamplesAreNotDrawn) {
    const auto frusta = host::shadowFrusta({}, vec4(0, 0, 0, 1));
    ASSERT_EQ(frusta.size(), 6u);
    std::vector<uint32_t> measured(24, 0);
    EXPECT_TRUE(host::fitShadowFrusta(frusta, measured, {}, true).empty());
    for (int i = 0; i < 4; ++i) measured[8 + i] = 1u << 23;
    const auto one = host::fitShadowFrusta(frusta, measured, {}, false);
    ASSERT_EQ(one.size(), 1u);
    EXPECT_EQ(one[0].forward, frusta[2].forward);
    EXPECT_EQ(one[0].rect, vec4(-1, 1, -1, 1)) << "uniform: the whole face";
}

TEST(ShadowMapFit, APrismReachesFromTheFirstCasterToTheLast) {
    const auto frusta = host::shadowFrusta({}, vec4(0, 1, 0, 0));
    ASSERT_EQ(frusta.size(), 1u);
    const std::vector<host::Triangle> casters{{{-0.5f, 0.75f, 0}, {-0.25f, 0.75f, 0}, {-0.5f, 0.75f, 0.25f}},
                                              {{0, -0.5f, 0}, {0.5f, -0.5f, 0}, {0, -0.5f, -0.125f}}};
    const std::vector<uint32_t> measured{1u << 23, 1u << 23, 1u << 23, 1u << 23};
    for (const bool focused : {false, true}) {
        const auto fitted = host::fitShadowFrusta(frusta, measured, casters, focused);
        ASSERT_EQ(fitted.size(), 1u);
        EXPECT_NEAR(fitted[0].near, -0.75f, 0.01f);
        EXPECT_NEAR(fitted[0].far, 0.5f, 0.01f);
        for (const auto& t : casters)
            for (const vec3& p : {t.a, t.b, t.c}) {
                const vec4 clip = gnoShadowMapClip(fitted[0].view(), p);
                EXPECT_TRUE(clip.z > 0 && clip.z < 1) << clip.z;
                EXPECT_TRUE(focused || gnoShadowMapHolds(clip));
            }
    }
}

TEST(ShadowMapViews, ASpotsConeComesFirst) {
    for (const vec3 axis : {vec3(0, -1, 0), vec3(1, 0, 0), vec3(0.48f, -0.6f, 0.64f)}) {
        const host::Light light = spot(axis, 0.5f);
        const auto frusta = host::shadowFrusta(frameWith({light}), light.homogeneous);
        ASSERT_EQ(frusta.size(), 7u);
        EXPECT_NEAR(glm::distance(frusta[0].forward, axis), 0, 1e-6);
        EXPECT_NEAR(glm::dot(frusta[0].right, axis), 0, 1e-6);
        EXPECT_NEAR(glm::dot(frusta[0].right, frusta[0].down), 0, 1e-6);
        EXPECT_NEAR(glm::length(frusta[0].down), 1, 1e-6);
        EXPECT_FLOAT_EQ(frusta[0].rect.y, std::tan(0.5f));
    }
    const host::Light wide = spot(vec3(0, -1, 0), 1.5f);
    EXPECT_EQ(host::shadowFrusta(frameWith({wide}), wide.homogeneous).size(), 6u);
    EXPECT_EQ(host::shadowFrusta(frameWith({spot(vec3(0, -1, 0), 0.5f)}), vec4(0, 0, 0, 1)).size(), 6u) << "another light";
}

TEST(ShadowMapDraws, FacesAsTheLightSeesThem) {
    const uint front = 0u, edge = 1u, back = 2u, kept = GNO_CASTER_KEPT;
    for (const uint faces : {GNO_SHADOW_MAP_BOTH, GNO_SHADOW_MAP_BACK, GNO_SHADOW_MAP_FRONT}) {
        EXPECT_EQ(gnoShadowMapDraws(front | kept, faces), faces != GNO_SHADOW_MAP_BACK);
        EXPECT_EQ(gnoShadowMapDraws(back | kept, faces), faces != GNO_SHADOW_MAP_FRONT);
        for (const uint state : {edge, front, back, edge | kept}) EXPECT_FALSE(gnoShadowMapDraws(state, faces)) << state;
    }
}

}  // namespace
}  // namespace gno
