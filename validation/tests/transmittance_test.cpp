// SPDX-License-Identifier: MIT
// core/hit_weights.glsl, core/transmittance.glsl and core/transmittance_sum.glsl, compiled as C++, against the oracle's own code (GMP, plain C++).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "glsl/core/material.h"
#include "host_min/frame/materials.hpp"
#include "validation/oracle/transmission.hpp"
#include "validation/support/exact_reference.hpp"
#include "validation/support/glsl_as_cpp.hpp"
#include "validation/support/grid_questions.hpp"

namespace gno {
namespace {
std::vector<uint32_t> materialOf, texels, sums;
std::vector<GnoSurface> surfaces;
std::vector<GnoMaterial> materials;
}  // namespace
#define GNO_LOAD_MATERIAL_OF(caster_) materialOf.at(caster_)
#define GNO_LOAD_SURFACE(index_) surfaces.at(index_)
#define GNO_LOAD_MATERIAL(index_) materials.at(index_)
#define GNO_LOAD_TEXEL(index_) texels.at(index_)
#define GNO_TRANSMITTANCE_SUMS sums
#include "glsl/core/orient3d.glsl"
#include "glsl/core/transmittance.glsl"
#include "glsl/core/transmittance_sum.glsl"

namespace {

using host::Material;
using host::TextureImage;
using host::Wrap;
using questions::Question;
using questions::Random;
using Weights = std::array<int64_t, 3>;

Weights wide(uvec3 v) { return {v.x, v.y, v.z}; }
Weights reference(const Question& q) { return host::oracle::hitWeights({q.t.a, q.t.b, q.t.c}, q.light, q.p); }

class EveryFamily : public testing::TestWithParam<questions::Family> {};

TEST_P(EveryFamily, HasTheOraclesHitWeights) {
    Random r(4);
    uint64_t inShadow = 0, zeros = 0;
    constexpr int kCount = 90000;
    for (int i = 0; i < kCount; ++i) {
        Question q = GetParam().make(r);
        if (r.below(2) == 0) {  // half of the points: behind the caster, or on the edge of its volume
            const double s = 0.5 * r.real() + 0.5, t = (0.5 * r.real() + 0.5) * (1 - s) * (r.below(4) == 0 ? 0 : 1), k = 0.5 + r.real();
            const glm::dvec3 a(q.t.a), on = a + (glm::dvec3(q.t.b) - a) * s + (glm::dvec3(q.t.c) - a) * t, l(vec3(q.light));
            q.p = r.nudge(q.light.w != 0.0f ? on + (on - l) * k : on - l * k);
        }
        const uvec3 got = gnoHitWeights(q.light, q.t, q.p);
        ASSERT_EQ(wide(got), reference(q)) << questions::show(q);
        ASSERT_LT(std::max({got.x, got.y, got.z}), 1u << 22);
        if (!gnoInShadowOf(q.light, q.t, q.p)) continue;
        ++inShadow;
        zeros += got.x == 0 || got.y == 0 || got.z == 0;
        ASSERT_GT(got.x + got.y + got.z, 0u) << questions::show(q);
    }
    RecordProperty("in_shadow", std::to_string(inShadow));
    RecordProperty("on_an_edge", std::to_string(zeros));
    EXPECT_GT(inShadow, 0u);
}

INSTANTIATE_TEST_SUITE_P(HitWeights, EveryFamily, testing::ValuesIn(questions::kFamilies),
                         [](const auto& family) { return std::string(family.param.name); });

/// Seen along the segment from the light to p, the weighted vertices meet that segment: within the weights' own rounding.
TEST(HitWeights, NameThePointWhereTheLightCrosses) {
    Random r(5);
    int tried = 0;
    while (tried < 20000) {
        const Question q = questions::kFamilies[0].make(r);
        if (!gnoInShadowOf(q.light, q.t, q.p)) continue;
        ++tried;
        const glm::dvec3 w(gnoHitWeights(q.light, q.t, q.p)), a(q.t.a), b(q.t.b), c(q.t.c), p(q.p), l(vec3(q.light));
        const glm::dvec3 hit = (w.x * a + w.y * b + w.z * c) / (w.x + w.y + w.z), way = q.light.w != 0.0f ? l - p : l;
        EXPECT_LT(glm::length(glm::cross(hit - p, glm::normalize(way))), 1e-5) << questions::show(q);
        EXPECT_GT(glm::dot(hit - p, way), 0) << questions::show(q);
    }
}

TEST(HitWeights, SumOfTheLargestNumbersDoesNotOverflow) {
    // Corners of the cube of 1.5: determinants near 108 * 2^120.
    uint64_t large = 0;
    for (uint32_t bits = 0; bits < 1u << 15; ++bits) {
        const auto corner = [&](uint32_t i) {
            return vec3((bits >> (3 * i)) & 1 ? 1.5f : -1.5f, (bits >> (3 * i + 1)) & 1 ? 1.5f : -1.5f, (bits >> (3 * i + 2)) & 1 ? 1.5f : -1.5f);
        };
        const Question q{vec4(corner(0), 1), {corner(1), corner(2), corner(3)}, corner(4)};
        ASSERT_EQ(wide(gnoHitWeights(q.light, q.t, q.p)), reference(q));
        const exact::Vec p = exact::fixed(q.p), l = exact::fixed(vec3(q.light));
        using exact::operator-;
        const exact::Int128 d = exact::det(l - p, exact::fixed(q.t.b) - p, exact::fixed(q.t.c) - p);
        large += (d < 0 ? -d : d) >> 125 != 0;
    }
    EXPECT_GT(large, 100u);
}

TEST(WeightedMean, IsTheFloorOfTheQuotient) {
    std::mt19937_64 bits(6);
    std::printf("seed 6\n");
    for (int i = 0; i < 300000; ++i) {
        const auto random = [&](int most) { return uint(bits() >> (64 - 1 - bits() % static_cast<uint64_t>(most))); };
        const uvec3 w = min(uvec3(random(22), random(22), random(22)), uvec3((1u << 22) - 1)),
                    v(random(32), random(32), i % 3 == 0 ? 0xFFFFFFFFu : random(32));
        const uint64_t sum = uint64_t{w.x} + w.y + w.z;
        const exact::Int128 product = exact::Int128{w.x} * v.x + exact::Int128{w.y} * v.y + exact::Int128{w.z} * v.z;
        ASSERT_EQ(gnoWeightedMean(w, v), sum == 0 ? 0u : uint(product / static_cast<int64_t>(sum)));
    }
    EXPECT_EQ(gnoWeightedMean(uvec3((1u << 22) - 1), uvec3(0xFFFFFFFFu)), 0xFFFFFFFFu);
    EXPECT_EQ(gnoWeightedMean(uvec3(0), uvec3(7)), 0u);
}

TEST(HitTexel, IsTheFloorOfTheMeanOnBothSidesOfZero) {
    std::mt19937_64 bits(11);
    std::printf("seed 11\n");
    for (int i = 0; i < 100000; ++i) {
        const uint64_t reach = i % 3 == 0 ? (1u << 31) - 2 : 5000;
        const auto corner = [&] { return ivec2(int64_t(bits() % reach) - int64_t(reach / 2), int64_t(bits() % reach) - int64_t(reach / 2)); };
        const GnoSurface s{corner(), corner(), corner(), 0, 0};
        const uvec3 w(bits() % (1u << 22), bits() % (1u << 22), i % 5 == 0 ? 0 : bits() % (1u << 22));
        if (w.x + w.y + w.z == 0) continue;
        const ivec2 got = gnoHitTexel(w, s);
        for (int k = 0; k < 2; ++k) {
            const int64_t sum = int64_t{w.x} + w.y + w.z, product = int64_t{w.x} * s.a[k] + int64_t{w.y} * s.b[k] + int64_t{w.z} * s.c[k];
            ASSERT_LE(got[k] * sum, product);
            ASSERT_GT((got[k] + int64_t{1}) * sum, product);
        }
    }
}

TEST(Contribution, IsTheRoundedLogarithmOfAll256) {
    uint before = GNO_TRANSMITTANCE_OPAQUE;
    for (uint t = 0; t < 256; ++t) {
        EXPECT_EQ(gnoContribution(t), host::oracle::contribution(t)) << t;
        EXPECT_LE(gnoContribution(t), before);
        before = gnoContribution(t);
    }
    EXPECT_EQ(gnoContribution(255), 0u);
    EXPECT_EQ(gnoContribution(0), GNO_TRANSMITTANCE_OPAQUE);
    EXPECT_EQ(gnoContribution(1), 523918u);
    EXPECT_EQ(gnoContribution(51), 152170u) << "a fifth: log2(5) * 2^16 = 152169.96";
    EXPECT_EQ(host::kNoLight, GNO_TRANSMITTANCE_OPAQUE);
    EXPECT_EQ(host::kOpaque, GNO_OPAQUE_CASTER);
}

TextureImage imageOf(uint32_t width, uint32_t height, uint64_t seed) {
    std::mt19937_64 bits(seed);
    TextureImage image{width, height, std::vector<uint8_t>(size_t{4} * width * height)};
    for (uint8_t& channel : image.rgba) channel = static_cast<uint8_t>(bits() % 3 == 0 ? 255 * (bits() % 2) : bits() % 256);
    return image;
}

GnoMaterial install(const Material& material, const TextureImage& image) {
    texels = {0xDEADBEEFu};
    const std::vector<uint32_t> packed = host::packTexels(image);
    texels.insert(texels.end(), packed.begin(), packed.end());
    return host::packMaterial(material, &image, 1);
}

void expectSame(const Material& material, const TextureImage& image, int u, int v) {
    const uvec4 got = gnoSampleTexture(install(material, image), ivec2(u, v));
    const auto want = host::oracle::sampled(material, image, u, v);
    for (int i = 0; i < 4; ++i) ASSERT_EQ(got[i], want[static_cast<size_t>(i)]) << u << ' ' << v << " channel " << i;
}

/// All wrap modes on both axes, both filters, sizes from one texel on; coordinates around every border and far away.
TEST(Texels, AreTheOraclesInEveryWrapModeAndFilter) {
    const Wrap wraps[] = {Wrap::repeat, Wrap::mirrored, Wrap::clamp};
    std::mt19937_64 bits(7);
    for (const auto& [width, height] : {std::pair{1u, 1u}, {1u, 5u}, {2u, 3u}, {16u, 16u}, {33u, 7u}}) {
        const TextureImage image = imageOf(width, height, 8);
        for (const Wrap u : wraps)
            for (const Wrap v : wraps)
                for (const bool linear : {false, true}) {
                    Material material;
                    material.wrapU = u;
                    material.wrapV = v;
                    material.linearFilter = linear;
                    for (int k = -3; k <= 3; ++k)  // corners on texel borders, one step beside, and half way
                        for (const int step : {-129, -128, -1, 0, 1, 127, 128})
                            expectSame(material, image, k * 256 * static_cast<int>(width) / 2 + step, -k * 256 + step);
                    for (const int far : {(1 << 30) - 1, -(1 << 30) + 1}) expectSame(material, image, far, -far);
                    for (int i = 0; i < 200; ++i)
                        expectSame(material, image, static_cast<int>(bits() % (1u << 31)) - (1 << 30) + 1,
                                   static_cast<int>(bits() % 100000) - 50000);
                }
    }
}

TEST(Texels, OfHandMadeCases) {
    const TextureImage image{2, 1, {0, 255, 128, 0, 255, 0, 128, 255}};
    Material material;
    material.linearFilter = false;
    const auto alphaAt = [&](int u) { return gnoSampleTexture(install(material, image), ivec2(u, 0)).w; };
    EXPECT_EQ(alphaAt(0), 0u);
    EXPECT_EQ(alphaAt(255), 0u);
    EXPECT_EQ(alphaAt(256), 255u) << "a border belongs to the texel on its right";
    EXPECT_EQ(alphaAt(511), 255u);
    EXPECT_EQ(alphaAt(512), 0u) << "the next repeat";
    EXPECT_EQ(alphaAt(-1), 255u);
    material.wrapU = Wrap::mirrored;
    EXPECT_EQ(alphaAt(512), 255u);
    EXPECT_EQ(alphaAt(-1), 0u);
    EXPECT_EQ(alphaAt(1024), 0u);
    material.wrapU = Wrap::clamp;
    EXPECT_EQ(alphaAt(5120), 255u);
    EXPECT_EQ(alphaAt(-5120), 0u);
    material.linearFilter = true;
    EXPECT_EQ(alphaAt(128), 0u) << "the middle of a texel is that texel";
    EXPECT_EQ(alphaAt(384), 255u);
    EXPECT_EQ(alphaAt(256), 128u) << "127.5 goes up";
    const uvec4 one = gnoSampleTexture(install(material, image), ivec2(128, 0));
    EXPECT_EQ(one, uvec4(0, 255, 55, 0)) << "sRGB 128 is 55 of 255 in linear light";
    EXPECT_EQ(gnoSampleTexture(host::packMaterial(material, nullptr, 0), ivec2(3, 3)), uvec4(255));
}

uvec3 passed(const Material& material, uvec4 texel) { return gnoTransmitted(host::packMaterial(material, nullptr, 0), texel); }

TEST(Transmitted, IsTheOraclesForAllAlphasAndManyFactors) {
    std::mt19937_64 bits(9);
    for (int i = 0; i < 600; ++i) {
        Material material;
        material.alpha = static_cast<Material::Alpha>(i % 3);
        const auto factor = [&] { return bits() % 4 == 0 ? static_cast<float>(bits() % 2) : static_cast<float>(bits() % 100001) / 100000.0f; };
        material.alphaCutoff = bits() % 2 == 0 ? static_cast<float>(bits() % 256) / 255.0f : factor();
        material.baseColor = {factor(), factor(), factor(), factor()};
        material.transmission = factor();
        for (int64_t alpha = 0; alpha < 256; ++alpha) {
            const std::array<int64_t, 4> texel{static_cast<int64_t>(bits() % 256), static_cast<int64_t>(bits() % 256), alpha, alpha};
            const auto want = host::oracle::passing(material, texel);
            const uvec3 got = passed(material, uvec4(texel[0], texel[1], texel[2], texel[3]));
            ASSERT_EQ((Weights{got.x, got.y, got.z}), want) << "material " << i << " alpha " << alpha;
        }
    }
}

TEST(Transmitted, MaskCutsExactlyAtItsCutoff) {
    Material leaf;
    leaf.alpha = Material::Alpha::mask;
    leaf.baseColor = glm::vec4(1);
    for (uint k = 0; k < 256; ++k) {
        leaf.alphaCutoff = static_cast<float>(k) / 255.0f;
        EXPECT_EQ(passed(leaf, uvec4(255, 255, 255, k)), uvec3(0)) << "met exactly: opaque, " << k;
        const uint less = k == 0 ? 0 : k - 1;
        EXPECT_EQ(passed(leaf, uvec4(255, 255, 255, less)), uvec3(k == 0 ? 0 : 255)) << k;
    }
    leaf.alphaCutoff = 0.5f;
    EXPECT_EQ(passed(leaf, uvec4(127)), uvec3(255));
    EXPECT_EQ(passed(leaf, uvec4(128)), uvec3(0));
    leaf.alphaCutoff = 1.01f;
    EXPECT_EQ(passed(leaf, uvec4(255)), uvec3(255)) << "a cutoff above 1 is never met";
    leaf.alphaCutoff = 1e30f;
    EXPECT_EQ(passed(leaf, uvec4(255)), uvec3(255));
    leaf.alphaCutoff = 0;
    EXPECT_EQ(passed(leaf, uvec4(0)), uvec3(0)) << "a cutoff of 0 always is";
}

TEST(Transmitted, BlendAndGlass) {
    Material glass;
    glass.alpha = Material::Alpha::blend;
    glass.baseColor = {1, 0.5f, 0, 0.25f};
    EXPECT_EQ(passed(glass, uvec4(255)), uvec3(255 - 64)) << "blend alone is grey: 1 - alpha, alpha 0.25 is 64 of 255";
    EXPECT_EQ(passed(glass, uvec4(255, 255, 255, 0)), uvec3(255)) << "alpha 0: nothing is there";
    glass.baseColor.w = 1;
    EXPECT_EQ(passed(glass, uvec4(255)), uvec3(0)) << "alpha 1: opaque";
    glass.transmission = 1;
    EXPECT_EQ(passed(glass, uvec4(255)), uvec3(255, 128, 0));
    glass.alpha = Material::Alpha::opaque;
    EXPECT_EQ(passed(glass, uvec4(255, 255, 255, 0)), uvec3(255, 128, 0)) << "without an alpha mode, alpha means nothing";
    glass.transmission = 0;
    EXPECT_EQ(passed(glass, uvec4(255)), uvec3(0));
}

TEST(Sums, StopAndNeverWrap) {
    constexpr uint kLayers = 100000;                                          // 523918 each: the sum would pass 2^32 a dozen times
    for (const uint one : {1u, 65536u, 523918u, GNO_TRANSMITTANCE_OPAQUE}) {  // 16 times 65536 is the stop itself
        sums.assign(8, 0);
        uint64_t want = 0;
        for (uint i = 0; i < kLayers; ++i) {
            gnoAddTransmittance(1, uvec3(one, 0, i == 7 ? 5u : 0u));
            want = std::min<uint64_t>(want + one, GNO_TRANSMITTANCE_OPAQUE);
            ASSERT_EQ(gnoTransmittanceSum(1), uvec3(uint(want), 0, i < 7 ? 0u : 5u));
        }
        EXPECT_FALSE(gnoIsDark(1));
        gnoAddOpaque(1);
        EXPECT_TRUE(gnoIsDark(1));
        EXPECT_EQ(gnoTransmittanceSum(1), uvec3(GNO_TRANSMITTANCE_OPAQUE));
        EXPECT_EQ((std::vector<uint32_t>(sums.begin(), sums.begin() + 4)), std::vector<uint32_t>(4, 0)) << "the neighbour";
    }
}

TEST(Sums, AreDarkWhenAllThreeStop) {
    for (uint stopped = 0; stopped < 8; ++stopped) {
        sums.assign(4, 0);
        gnoAddTransmittance(0, uvec3(stopped & 1u, (stopped >> 1) & 1u, stopped >> 2) * GNO_TRANSMITTANCE_OPAQUE);
        EXPECT_EQ(gnoIsDark(0), stopped == 7) << stopped;
    }
}

/// The pixel's word is read before the addition: an addition that does not see yet that the sum stands at its stop may even wrap it.
TEST(Sums, AStopThatIsSeenLateIsAStop) {
    sums.assign(4, 0);
    gnoAddTransmittance(0, uvec3(523918));
    gnoAddTransmittance(0, uvec3(523918));
    gnoAddTransmittance(0, uvec3(5239));
    ASSERT_TRUE(gnoIsDark(0));
    for (uint i = 0; i < 20000; ++i) {
        const uint bit = gnoAddChannel_(0, 0, 523918);
        EXPECT_TRUE(bit == 0u || bit == 1u);
    }
    EXPECT_EQ(gnoTransmittanceSum(0), uvec3(GNO_TRANSMITTANCE_OPAQUE));
}

TEST(Sums, KnowNoOrder) {
    std::mt19937_64 bits(10);
    for (int round = 0; round < 200; ++round) {
        std::vector<uvec3> layers(40);
        for (uvec3& layer : layers)
            for (int i = 0; i < 3; ++i) layer[i] = gnoContribution(static_cast<uint>(bits() % 8 == 0 ? bits() % 256 : 200 + bits() % 56));
        uvec3 first(0);
        for (int order = 0; order < 5; ++order) {
            sums.assign(4, 0);
            for (const uvec3& layer : layers) gnoAddTransmittance(0, layer);
            if (order == 0) first = gnoTransmittanceSum(0);
            ASSERT_EQ(gnoTransmittanceSum(0), first);
            std::shuffle(layers.begin(), layers.end(), bits);
        }
    }
}

TEST(Transmittance, OfACaster) {
    const GnoCaster t{{-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0, 0.5f, 0}};
    const vec4 sun(0, 0, 1, 0);
    const vec3 below(0.0625f, -0.25f, -0.5f);
    Material leaf;
    leaf.alpha = Material::Alpha::mask;
    leaf.baseColor = glm::vec4(1);
    leaf.linearFilter = false;
    const TextureImage image{2, 1, {0, 0, 0, 0, 255, 255, 255, 255}};  // left half open
    materials = {install(leaf, image)};
    materialOf = {GNO_OPAQUE_CASTER, 0};
    surfaces = {{{0, 0}, {512, 0}, {256, 256}, 0, 0}};
    EXPECT_TRUE(gnoIsOpaqueCaster(0));
    EXPECT_FALSE(gnoIsOpaqueCaster(1));
    EXPECT_EQ(gnoTransmittance(0, t, sun, below), uvec3(GNO_TRANSMITTANCE_OPAQUE));
    EXPECT_EQ(gnoTransmittance(1, t, sun, below), uvec3(GNO_TRANSMITTANCE_OPAQUE)) << "the right half";
    EXPECT_EQ(gnoTransmittance(1, t, sun, vec3(-0.0625f, -0.25f, -0.5f)), uvec3(0)) << "the left half";
    EXPECT_EQ(gnoTransmittance(1, t, sun, vec3(0, -0.25f, -0.5f)), uvec3(GNO_TRANSMITTANCE_OPAQUE)) << "exactly on the border";
}

}  // namespace
}  // namespace gno
