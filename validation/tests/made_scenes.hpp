// SPDX-License-Identifier: MIT
// Made-up scenes that several tests of techniques ask about, and what a scene owes the techniques.
#pragma once
#include "validation/support/device_test.hpp"
#include "validation/support/exact_reference.hpp"
#include "validation/tests/oracle_cases.hpp"

namespace gno::test {

inline glm::vec4 lightOf(bool directional) { return directional ? glm::vec4(0.375f, 1, 0.25f, 0) : glm::vec4(0.125f, 0.875f, -0.25f, 1); }

/// Casters of one size (half an edge of the cube that holds them) anywhere, samples anywhere and on no caster: no sign is near zero, so that fp32
/// decides like the definition.
inline Scene soup(uint32_t seed, bool directional, size_t casters, double size, size_t samples) {
    host::cases::Random random(seed);
    Scene scene;
    scene.light = lightOf(directional);
    while (scene.triangles.size() < casters) {
        const glm::dvec3 at = random.inCube(1 - size);
        const auto corner = [&] { return host::cases::snap(at + random.inCube(size)); };
        const glm::vec3 a = corner(), b = corner(), c = corner();
        scene.triangles.push_back({a, b, c});
    }
    while (scene.samples.size() < samples) scene.samples.push_back({host::cases::snap(random.inCube()), host::kNoCaster});
    return scene;
}

/// A sample with an own caster lies strictly on the light's side of its plane (core/sample.glsl sees to it); behind it, a copy of the own caster
/// would be another caster by the definition, and a tree need not hold both. Samples that break this lose their own caster.
inline void keepTheContract(Scene& scene) {
    for (host::OracleSample& sample : scene.samples) {
        if (sample.own == host::kNoCaster) continue;
        const host::Triangle& t = scene.triangles[sample.own];
        const auto a = exact::fixed(t.a), b = exact::fixed(t.b), c = exact::fixed(t.c), l = exact::fixed(glm::vec3(scene.light));
        using exact::operator-;
        const int front = scene.light.w != 0 ? exact::orient3d(a, b, c, l) : exact::sign(exact::det(b - a, c - a, l));
        if (front == 0 || exact::orient3d(a, b, c, exact::fixed(sample.position)) != front) sample.own = host::kNoCaster;
    }
}

}  // namespace gno::test
