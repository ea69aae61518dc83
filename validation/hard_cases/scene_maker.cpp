// SPDX-License-Identifier: MIT
#include "validation/hard_cases/scene_maker.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "host_min/scene/grid.hpp"
#include "validation/support/glsl_as_cpp.hpp"

namespace gno {  // core/orient3d.glsl opens no namespace, what includes it opens its own: gno::gno
#include "glsl/core/permutation.glsl"
#include "glsl/core/sample.glsl"
using namespace gno;
}  // namespace gno

namespace gno::hard {

glm::vec3 snapped(glm::dvec3 v) { return {host::snapCoordinate(v.x), host::snapCoordinate(v.y), host::snapCoordinate(v.z)}; }

glm::vec4 pointLight(glm::dvec3 p) { return {snapped(p), 1.0f}; }
glm::vec4 directionalLight(glm::dvec3 towardsLight) { return {host::snapDirection(towardsLight), 0.0f}; }

std::optional<host::OracleSample> sampleOn(const test::Scene& scene, uint32_t own, glm::dvec3 p) {
    const Triangle& t = scene.triangles.at(own);
    const GnoCaster caster{t.a, t.b, t.c};
    const glm::vec3 n = gnoExactNormal(caster);
    for (const float side : {1.0f, -1.0f}) {  // a viewer at infinity on either side: the light's side is the one that is not GNO_FACING_AWAY
        const GnoViewSample s = gnoMakeViewSample(glm::vec3(p), own, caster, glm::vec4(n * side, 0), scene.light);
        if (s.own == own && host::cases::inCube(s.position)) return host::OracleSample{s.position, own};
    }
    return {};
}

uint32_t permute(uint32_t index, uint32_t count, uint32_t seed) { return gnoPermute(index, count, seed); }

uint32_t seedThatInsertsFirst(uint32_t triangle, uint32_t count, uint32_t from) {
    for (uint32_t seed = from; seed < from + 1000 * (count + 1); ++seed)
        if (permute(0, count, seed) == triangle) return seed;
    throw std::logic_error("no seed inserts this triangle first");
}

void addFree(test::Scene& scene, glm::dvec3 p) {
    if (host::cases::inCube(glm::vec3(p))) scene.samples.push_back({snapped(p), host::kNoCaster});
}

void addOn(test::Scene& scene, uint32_t own, glm::dvec3 p) {
    if (const auto sample = sampleOn(scene, own, p)) scene.samples.push_back(*sample);
}

glm::dvec3 pointOf(const Triangle& t, Random& random) {
    const glm::dvec3 v[3] = {t.a, t.b, t.c};
    const uint32_t i = random.below(3), kind = random.below(4);
    if (kind == 0) return v[i];
    if (kind == 1) return (v[i] + v[(i + 1) % 3]) / 2.0;
    const double s = random.real(0, 1);
    if (kind == 2) return v[i] + s * (v[(i + 1) % 3] - v[i]);
    return v[i] + s * ((v[(i + 1) % 3] - v[i]) + random.real(0, 1) * (v[(i + 2) % 3] - v[(i + 1) % 3]));
}

glm::dvec3 behind(glm::vec4 light, glm::dvec3 p, double step) {
    const glm::dvec3 l(light);
    return p + step * (light.w != 0 ? p - l : -l);
}

void addHardSamples(test::Scene& scene, Random& random, size_t count) {
    const double steps[] = {0, 0.25, 0.5, 1, 2, 1e-6, -1e-6, -0.5};
    while (scene.samples.size() < count) {
        const uint32_t kind = random.below(10);
        glm::dvec3 p = random.inCube();
        if (kind == 0) p = random.lattice(8);
        if (kind == 1 && scene.light.w != 0) p = glm::dvec3(scene.light);
        if (kind >= 2 && !scene.triangles.empty()) {
            const uint32_t i = random.below(uint32_t(scene.triangles.size()));
            const glm::dvec3 q = pointOf(scene.triangles[i], random);
            if (kind < 5) {
                addOn(scene, i, q);
                if (random.below(4) != 0) continue;
                p = q;  // the same point as a free one: exactly on the plane, or beside it by rounding
            } else {
                p = behind(scene.light, q, random.below(2) ? steps[random.below(8)] : random.real(0, 1));
            }
        }
        glm::vec3 s = snapped(glm::clamp(p, -2.0, 2.0));
        if (random.below(3) == 0) s = host::cases::neighbour(s, random);
        addFree(scene, s);
    }
}

void addSurfaceSamples(test::Scene& scene, Random& random, size_t count) {
    for (size_t tries = 0; scene.samples.size() < count && tries < 100 * count; ++tries) {
        const uint32_t i = random.below(uint32_t(scene.triangles.size()));
        addOn(scene, i, pointOf(scene.triangles[i], random));
    }
}

void addBall(std::vector<Triangle>& out, glm::dvec3 centre, double radius, int slices, int stacks) {
    const auto at = [&](int slice, int stack) {
        const double polar = std::numbers::pi * stack / stacks, around = 2 * std::numbers::pi * (slice % slices) / slices;
        if (stack == 0 || stack == stacks) return snapped(centre + glm::dvec3(0, stack == 0 ? radius : -radius, 0));
        return snapped(centre + radius * glm::dvec3(std::sin(polar) * std::cos(around), std::cos(polar), std::sin(polar) * std::sin(around)));
    };
    for (int stack = 0; stack < stacks; ++stack) {
        for (int slice = 0; slice < slices; ++slice) {
            if (stack > 0) out.push_back({at(slice, stack), at(slice + 1, stack), at(slice + 1, stack + 1)});
            if (stack + 1 < stacks) out.push_back({at(slice, stack), at(slice + 1, stack + 1), at(slice, stack + 1)});
        }
    }
}

void addBlade(std::vector<Triangle>& out, Random& random, glm::dvec3 foot, double depth, double height, double width) {
    const double angle = random.real(0, std::numbers::pi);
    const glm::dvec3 side = width * glm::dvec3(std::cos(angle), 0, std::sin(angle)),
                     tip(random.real(-0.3, 0.3) * height, height, random.real(-0.3, 0.3) * height);
    const glm::dvec3 root = foot - glm::dvec3(0, depth, 0);
    addQuad(out, snapped(root - side), snapped(root + side), snapped(foot + tip + 0.25 * side), snapped(foot + tip - 0.25 * side));
}

}  // namespace gno::hard
