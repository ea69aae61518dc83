// SPDX-License-Identifier: MIT
// gnomon-shadow-map-mutants [NAME...]: the shadow map's text on the CPU: projections, bias and bounds against double; the query, over maps drawn in
// double, against the definition away from silhouettes. What is printed: run.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "validation/mutants/run.hpp"
#include "validation/mutants/shadow_map_scenes.hpp"

namespace gno::mutants {
namespace {

using cpu::ShadowMap;
using glm::uvec2;

class Random {
public:
    double real(double half = 1) { return half * (2 * double(engine_()) / double(engine_.max()) - 1); }
    vec3 inCube(double half = 1) {
        const double x = real(half), y = real(half), z = real(half);
        return vec3(dvec3(x, y, z));
    }

private:
    std::mt19937 engine_{1978};
};

/// A face, a part of one, a spot that looks aslant, a prism; the last three lie aside of their middle.
std::vector<ShadowFrustum> kinds() {
    std::vector<ShadowFrustum> all{cubeFaces()[0], cubeFaces()[3], viewAlong({0.6, -0.8, 0.1}, {-0.5f, 0.75f, -0.25f, 0.5f}),
                                   viewAlong({0.375, -1, -0.5}, {-0.75f, 0.5f, -1, 0.25f})};
    all[1].rect = {-0.125f, 0.75f, 0.25f, 0.5f};
    all[3].perspective = false;
    all[3].near = -1.25f;
    all[3].far = 0.75f;
    return all;
}

vec4 lightOf(const ShadowFrustum& f) { return {0, 0, 0, f.perspective ? 1.0f : 0.0f}; }

std::string wrongProjection(ShadowMap& map) {
    Random random;
    constexpr uint kSize = 1000;
    constexpr double kOff = 1e-5;  // of fp32
    for (const ShadowFrustum& f : kinds()) {
        map.setViews(lightOf(f), {f}, kSize, 0);
        for (int i = 0; i < 5000; ++i) {
            const vec3 q = random.inCube();
            const vec4 clip = map.clip(0, q);
            const Place at = placeOf(f, q);
            const bool front = !f.perspective || at.along > 0;
            const double out = std::max(std::abs(at.x - 0.5), std::abs(at.y - 0.5)) - 0.5;
            if (std::abs(out) < kOff || (f.perspective && std::abs(at.along) < 1e-3)) continue;
            if (map.holds(clip) != (front && out < 0)) return fmt::format("point {} is held, or is not", i);
            if (!map.holds(clip)) continue;
            const uvec2 texel = map.texel(clip, kSize);
            if (std::abs(at.x * kSize - texel.x - 0.5) > 0.5 + kOff * kSize || std::abs(at.y * kSize - texel.y - 0.5) > 0.5 + kOff * kSize)
                return fmt::format("point {} is in another texel", i);
            if (std::abs(map.depth(0, clip) - at.depth) > (f.perspective ? at.depth * 1e-6 : 1e-6)) return fmt::format("depth of point {}", i);
        }
    }
    const float more = std::nextafter(2.0f, 3.0f);
    if (!map.holds({2, -2, 0, 2}) || !map.holds({-2, 2, 0, 2})) return "edges are not held";
    if (map.holds({more, 0, 0, 2}) || map.holds({0, -more, 0, 2}) || map.holds({0, 0, 0, 0}) || map.holds({0, 0, 0, -1}))
        return "held beyond an edge";
    if (map.texel({1, -1, 0, 1}, 512) != uvec2(511, 0) || map.texel({-1, 1, 0, 1}, 512) != uvec2(0, 511)) return "texels at the edges";
    return {};
}

/// A sample counts as the point that lies nearer to the light by so many widths of a texel there, of the wider side.
std::string wrongBias(ShadowMap& map) {
    Random random;
    constexpr uint kSize = 512;
    for (const ShadowFrustum& f : kinds())
        for (const float texels : {0.05f, 1.0f, 17.5f}) {
            map.setViews(lightOf(f), {f}, kSize, texels);
            for (int i = 0; i < 300; ++i) {
                const vec3 q = random.inCube(0.7);
                const Place at = placeOf(f, q);
                if (f.perspective ? at.along < 0.01 : at.along > f.far) continue;
                const double width = std::max(f.rect.y - f.rect.x, f.rect.w - f.rect.z) / double(kSize) * (f.perspective ? at.along : 1);
                const double want = placeOf(f, vec3(dvec3(q) - dvec3(f.forward) * (double(texels) * width))).depth;
                if (std::abs(map.depth(0, map.clip(0, q)) - want) > 4e-6 * (f.perspective ? want : 1))
                    return fmt::format("constant bias of {} texels, point {}", texels, i);
            }
        }
    map.setViews({0, 0, 0, 1}, {kinds()[0]}, 16, 64);
    const float all = map.depth(0, map.clip(0, {0.5f, 0, 0}));
    return all > 0 && all < 1e9f && all >= 1 ? "" : "a bias of more than the whole distance is not in front of everything";
}

std::string wrongFit(ShadowMap& map) {
    Random random;
    for (const ShadowFrustum& f : kinds())
        for (const double half : {0.06, 0.002, 0.0}) {
            map.setViews(lightOf(f), {f}, 1, 0);
            const glm::dvec2 middle((f.rect.x + f.rect.y) / 2.0, (f.rect.z + f.rect.w) / 2.0);
            const dvec3 at = dvec3(f.forward) * 0.5 + (dvec3(f.right) * middle.x + dvec3(f.down) * middle.y) * (f.perspective ? 0.5 : 1.0);
            std::vector<vec3> samples;
            double left = 2, right = -1, top = 2, bottom = -1;
            for (int i = 0; i < 60; ++i) {
                samples.emplace_back(at + dvec3(f.right) * random.real(half) + dvec3(f.down) * random.real(half / 2));
                const Place where = placeOf(f, samples.back());
                left = std::min(left, where.x), right = std::max(right, where.x), top = std::min(top, where.y), bottom = std::max(bottom, where.y);
            }
            const std::vector<uint> got = map.measure(samples);
            ShadowFrustum fitted = f;
            fitted.rect = map.fit({got[0], got[1], got[2], got[3]}, f.rect);
            map.setViews(lightOf(f), {fitted}, 1, 0);
            for (const vec3& p : samples)
                if (!map.holds(map.clip(0, p))) return fmt::format("the fitted view lacks a sample, all within {}", half);
            const double wide = double(f.rect.y) - f.rect.x, high = double(f.rect.w) - f.rect.z;
            if ((fitted.rect.y - fitted.rect.x) / wide > (right - left) * 1.01 + 1e-5 ||
                (fitted.rect.w - fitted.rect.z) / high > (bottom - top) * 1.01 + 1e-5)
                return fmt::format("the fitted view is too large, all samples within {}", half);
        }
    return {};
}

/// A spot's cone before the cube around it: every position has a view, and counts for the first that holds it.
std::string wrongMeasure(ShadowMap& map) {
    Random random;
    std::vector<ShadowFrustum> views = cubeFaces();
    views.insert(views.begin(), viewAlong({0, -1, 0.25}, {-0.4f, 0.4f, -0.4f, 0.4f}));
    const vec4 light(0.25f, -0.5f, 0.125f, 1);
    map.setViews(light, views, 1, 0);
    for (int i = 0; i < 4000; ++i) {
        vec3 p = random.inCube();
        if (i % 4 == 0) p = vec3(light) + glm::round(random.inCube() * 2.0f) * 0.0625f;  // along edges and corners of the cube
        if (p == vec3(light)) continue;
        const std::vector<uint> bounds = map.measure({p});
        size_t first = 0;
        while (first < views.size() && !map.holds(map.clip(uint(first), p - vec3(light)))) ++first;
        if (first == views.size()) return fmt::format("position {} has no view", i);
        for (size_t word = 0; word < bounds.size(); ++word)
            if ((bounds[word] != 0) != (word / 4 == first)) return fmt::format("position {} counts for view {}, not {}", i, word / 4, first);
    }
    return {};
}

/// State: core/caster_state.glsl; 0 front, 1 edge-on, 2 back, and 4 for a kept caster. Faces: both, back, front.
std::string wrongDraws(ShadowMap& map) {
    for (const uint state : {0u, 1u, 2u, 4u, 5u, 6u})
        for (uint faces = 0; faces < 3; ++faces) {
            const bool want = state == 4 ? faces != 1 : state == 6 ? faces != 2 : false;
            if (map.draws(state, faces) != want) return fmt::format("a caster of state {} is drawn, or is not, with faces {}", state, faces);
        }
    return {};
}

std::string wrongQuery(ShadowMap& map, const std::vector<ShadowScene>& scenes) {
    for (const ShadowScene& scene : scenes) {
        map.setViews(scene.light, scene.frusta, kMapSize, 1);
        for (size_t i = 0; i < scene.samples.size(); ++i)
            if (map.answer(scene.maps, scene.samples[i]) != (scene.want[i] != 0 ? GNO_VISIBILITY_SHADOW : GNO_VISIBILITY_LIT))
                return fmt::format("{}, light w {}: sample {} is {}", scene.name, scene.light.w, i, scene.want[i] != 0 ? "lit" : "dark");
    }
    return {};
}

}  // namespace
}  // namespace gno::mutants

int main(int argc, char** argv) {
    using namespace gno;
    const std::vector<mutants::ShadowScene> scenes = mutants::makeShadowScenes();
    return mutants::run({argv + 1, argv + argc}, cpu::shadowMapVariants(), [&](const cpu::ShadowMapVariant& variant, bool) -> mutants::Verdict {
        const auto map = variant.make();
        for (const auto check : {mutants::wrongDraws, mutants::wrongProjection, mutants::wrongBias, mutants::wrongFit, mutants::wrongMeasure}) {
            const std::string wrong = check(*map);
            if (!wrong.empty()) return {wrong};
        }
        return {mutants::wrongQuery(*map, scenes)};
    });
}
