// SPDX-License-Identifier: MIT
// gnomon-transmittance-mutants [NAME...]: the text of what casters let through, on the CPU, against the oracle's own code (GMP, plain C++), function
// by function and as a whole. What is printed: run.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host_min/frame/materials.hpp"
#include "validation/mutants/run.hpp"
#include "validation/oracle/transmission.hpp"
#include "validation/support/exact_reference.hpp"
#include "validation/support/grid_questions.hpp"
#include "validation/support/transmittance_on_cpu.hpp"

namespace gno::mutants {
namespace {

using cpu::Transmittance;
using glm::ivec2;
using glm::uvec3;
using host::Material;
using host::TextureImage;
using host::Wrap;
using questions::Question;
using questions::Random;
using Three = std::array<int64_t, 3>;

Three wide(uvec3 v) { return {v.x, v.y, v.z}; }
bool inShadow(const Question& q) {
    return exact::inShadowOf(q.light, exact::fixed(q.t.a), exact::fixed(q.t.b), exact::fixed(q.t.c), exact::fixed(q.p));
}

/// Half of the points: behind the caster, or on the edge of its volume.
Question anyQuestion(Random& r, const questions::Family& family) {
    Question q = family.make(r);
    if (r.below(2) == 0) return q;
    const double s = 0.5 * r.real() + 0.5, t = (0.5 * r.real() + 0.5) * (1 - s) * (r.below(4) == 0 ? 0 : 1), k = 0.5 + r.real();
    const glm::dvec3 a(q.t.a), on = a + (glm::dvec3(q.t.b) - a) * s + (glm::dvec3(q.t.c) - a) * t, l(vec3(q.light));
    q.p = r.nudge(q.light.w != 0.0f ? on + (on - l) * k : on - l * k);
    return q;
}

std::string wrongWeights(Transmittance& module) {
    Random r(4);
    for (int i = 0; i < 1500; ++i)
        for (const questions::Family& family : questions::kFamilies) {
            const Question q = anyQuestion(r, family);
            if (wide(module.hitWeights(q.light, q.t, q.p)) != host::oracle::hitWeights({q.t.a, q.t.b, q.t.c}, q.light, q.p))
                return fmt::format("hit weights, {} {}\n{}", family.name, i, show(q));
        }
    return {};
}

std::string wrongMean(Transmittance& module) {
    std::mt19937_64 bits(6);
    for (int i = 0; i < 20000; ++i) {
        const auto random = [&](uint64_t most) { return uint(bits() >> (63 - bits() % most)); };
        const uvec3 w = min(uvec3(random(22), random(22), random(22)), uvec3((1u << 22) - 1)),
                    v(random(32), random(32), i % 3 == 0 ? 0xFFFFFFFFu : random(32));
        const int64_t sum = int64_t{w.x} + w.y + w.z;
        const exact::Int128 product = exact::Int128{w.x} * v.x + exact::Int128{w.y} * v.y + exact::Int128{w.z} * v.z;
        if (sum > 0 && module.weightedMean(w, v) != uint(product / sum)) return fmt::format("weighted mean {}", i);
        const int64_t reach = i % 3 == 0 ? (1u << 31) - 2 : 5000;
        const auto corner = [&] { return ivec2(int64_t(bits() % reach) - reach / 2, int64_t(bits() % reach) - reach / 2); };
        const GnoSurface s{corner(), corner(), corner(), 0, 0};
        if (sum == 0) continue;
        const ivec2 got = module.hitTexel(w, s);
        for (int k = 0; k < 2; ++k) {
            const int64_t exactly = int64_t{w.x} * s.a[k] + int64_t{w.y} * s.b[k] + int64_t{w.z} * s.c[k];
            if (got[k] * sum > exactly || (got[k] + int64_t{1}) * sum <= exactly) return fmt::format("hit texel {}: not the floor of the mean", i);
        }
    }
    return {};
}

TextureImage imageOf(uint32_t width, uint32_t height, Random& r) {
    TextureImage image{width, height, {}};
    for (uint32_t i = 0; i < 4 * width * height; ++i) image.rgba.push_back(uint8_t(r.below(3) == 0 ? 255 * r.below(2) : r.below(256)));
    return image;
}

/// Every wrap mode on both axes, both filters; coordinates around every border and far away. The image begins behind another one's last texel.
std::string wrongTexel(Transmittance& module) {
    Random r(7);
    for (const auto& [width, height] : {std::pair{1u, 1u}, {1u, 5u}, {2u, 3u}, {16u, 16u}, {33u, 7u}}) {
        const TextureImage image = imageOf(width, height, r);
        cpu::Look look;
        look.texels = host::packTexels(image);
        look.texels.insert(look.texels.begin(), 0xDEADBEEFu);
        module.install(look);
        for (int mode = 0; mode < 18; ++mode) {
            Material material;
            material.wrapU = Wrap(mode % 3);
            material.wrapV = Wrap(mode / 3 % 3);
            material.linearFilter = mode >= 9;
            const GnoMaterial packed = host::packMaterial(material, &image, 1);
            std::vector<ivec2> places;
            for (int k = -3; k <= 3; ++k)
                for (const int step : {-129, -128, -1, 0, 1, 127, 128}) places.emplace_back(k * 128 * int(width) + step, -k * 256 + step);
            for (const int far : {(1 << 30) - 1, -(1 << 30) + 1}) places.emplace_back(far, -far);
            for (int i = 0; i < 60; ++i) places.emplace_back(int(r.real() * 0x1p30), int(r.real() * 50000));
            for (const ivec2 at : places) {
                const uvec4 got = module.sampleTexture(packed, at);
                const auto want = host::oracle::sampled(material, image, at.x, at.y);
                for (int c = 0; c < 4; ++c)
                    if (got[c] != want[size_t(c)])
                        return fmt::format("image {} x {}, mode {}, at {} {}: channel {} is {}, not {}", width, height, mode, at.x, at.y, c, got[c],
                                           want[size_t(c)]);
            }
        }
    }
    return {};
}

std::string wrongPassing(Transmittance& module) {
    Random r(9);
    for (int i = 0; i < 150; ++i) {
        Material material;
        material.alpha = Material::Alpha(i % 3);
        const auto factor = [&] { return r.below(4) == 0 ? float(r.below(2)) : float(r.below(100001)) / 100000.0f; };
        material.alphaCutoff = r.below(2) == 0 ? float(r.below(256)) / 255.0f : factor();
        material.baseColor = {factor(), factor(), factor(), factor()};
        material.transmission = factor();
        for (int64_t alpha = 0; alpha < 256; ++alpha) {
            const std::array<int64_t, 4> texel{r.below(256), r.below(256), alpha, alpha};
            const uvec3 got = module.transmitted(host::packMaterial(material, nullptr, 0), uvec4(texel[0], texel[1], texel[2], texel[3]));
            if (wide(got) != host::oracle::passing(material, texel)) return fmt::format("what passes material {} at alpha {}", i, alpha);
        }
    }
    for (uint t = 0; t < 256; ++t)
        if (module.contribution(t) != host::oracle::contribution(t)) return fmt::format("contribution of {}", t);
    return {};
}

/// Whole casters, opaque ones among them, against the oracle; some share a surface with nobody, some a material with many.
std::string wrongCaster(Transmittance& module) {
    Random r(20141);
    auto set = std::make_shared<host::MaterialSet>();
    cpu::Look look;
    for (const auto& [width, height] : {std::pair{16u, 16u}, {5u, 3u}}) set->images.push_back(imageOf(width, height, r));
    std::vector<uint32_t> first;
    for (const TextureImage& image : set->images) {
        first.push_back(uint32_t(look.texels.size()));
        const auto packed = host::packTexels(image);
        look.texels.insert(look.texels.end(), packed.begin(), packed.end());
    }
    for (int i = 0; i < 18; ++i) {
        Material& m = set->materials.emplace_back();
        m.alpha = Material::Alpha(i % 3);
        m.image = i % 4 % 3 - 1;
        m.linearFilter = r.below(2) == 0;
        m.wrapU = Wrap(r.below(3));
        m.wrapV = Wrap(r.below(3));
        m.baseColor = {0.9f, 0.7f, 0.5f, m.alpha == Material::Alpha::blend ? 0.3f : 1.0f};
        m.transmission = m.alpha == Material::Alpha::opaque ? 1.0f : float(r.below(2)) * 0.6f;
        look.materials.push_back(
            host::packMaterial(m, m.image < 0 ? nullptr : &set->images[size_t(m.image)], m.image < 0 ? 0 : first[size_t(m.image)]));
    }
    std::vector<Question> asked;
    std::vector<host::Triangle> triangles;
    std::vector<host::Surface> surfaces;
    for (int i = 0; i < 12000; ++i) {
        const Question q = anyQuestion(r, questions::kFamilies[i % std::size(questions::kFamilies)]);
        if (!inShadow(q)) continue;
        asked.push_back(q);
        triangles.push_back({q.t.a, q.t.b, q.t.c});
        if (r.below(8) == 0) {
            look.materialOf.push_back(host::kOpaque);
            continue;
        }
        look.materialOf.push_back(uint32_t(surfaces.size()));
        host::Surface& surface = surfaces.emplace_back();
        surface.material = uint32_t(r.below(18));
        const double reach = r.below(4) == 0 ? 0x1p30 - 1 : 40000;
        for (ivec2& corner : surface.corners) corner = {int(r.real() * reach), int(r.real() * reach)};
        look.surfaces.push_back({surface.corners[0], surface.corners[1], surface.corners[2], surface.material, 0});
    }
    module.install(look);
    uint64_t partial = 0;
    for (uint32_t i = 0; i < asked.size(); ++i) {
        const Question& q = asked[i];
        const host::OracleQuestion question{triangles, {}, q.light, {}, look.materialOf, surfaces, set.get()};
        const uvec3 want = host::oracle::contributionOf(question, i, q.p);
        partial += want != uvec3(0) && want != uvec3(GNO_TRANSMITTANCE_OPAQUE);
        if (module.transmittance(i, q.t, q.light, q.p) != want) return fmt::format("transmittance of caster {}\n{}", i, show(q));
    }
    if (partial < 100) throw std::logic_error("hardly any caster lets a part of the light through");
    return {};
}

std::string wrongSum(Transmittance& module) {
    for (const uint one : {1u, 65536u, 523918u, GNO_TRANSMITTANCE_OPAQUE}) {  // 16 times 65536 is the stop itself
        module.resetSums(2);
        uint64_t want = 0;
        for (uint i = 0; i < 20000; ++i) {  // 523918 each: the sum would pass 2^32
            module.add(1, uvec3(one, 0, i == 7 ? 5u : 0u));
            want = std::min<uint64_t>(want + one, GNO_TRANSMITTANCE_OPAQUE);
            if (module.sum(1) != uvec3(uint(want), 0, i < 7 ? 0u : 5u)) return fmt::format("sum of {} times {}", i + 1, one);
        }
        if (module.isDark(1)) return "dark before all channels are";
        module.addOpaque(1);
        if (!module.isDark(1) || module.sum(1) != uvec3(GNO_TRANSMITTANCE_OPAQUE)) return "not dark behind an opaque caster";
        if (module.sum(0) != uvec3(0) || module.isDark(0)) return "the pixel beside it";
    }
    for (uint stopped = 0; stopped < 8; ++stopped) {
        module.resetSums(1);
        module.add(0, uvec3(stopped & 1u, (stopped >> 1) & 1u, stopped >> 2) * GNO_TRANSMITTANCE_OPAQUE);
        if (module.isDark(0) != (stopped == 7)) return fmt::format("dark with stops {}", stopped);
    }
    for (uint channel = 0; channel < 3; ++channel) {  // whoever sees the stop late adds on, past 2^32
        module.resetSums(1);
        for (uint i = 0; i < 20000; ++i) module.addLate(0, channel, 523918);
        for (uint c = 0; c < 3; ++c)
            if (module.sum(0)[int(c)] != (c == channel ? GNO_TRANSMITTANCE_OPAQUE : 0u)) return fmt::format("late additions to channel {}", channel);
    }
    return {};
}

}  // namespace
}  // namespace gno::mutants

int main(int argc, char** argv) {
    using namespace gno;
    return mutants::run(
        {argv + 1, argv + argc}, cpu::transmittanceVariants(), [](const cpu::TransmittanceVariant& variant, bool) -> mutants::Verdict {
            const auto module = variant.make();
            for (const auto check :
                 {mutants::wrongSum, mutants::wrongMean, mutants::wrongTexel, mutants::wrongPassing, mutants::wrongWeights, mutants::wrongCaster}) {
                const std::string wrong = check(*module);
                if (!wrong.empty()) return {wrong};
            }
            return {};
        });
}
