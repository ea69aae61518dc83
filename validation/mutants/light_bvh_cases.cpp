// SPDX-License-Identifier: MIT
#include "validation/mutants/light_bvh_cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "host_min/techniques/cell_assignment.hpp"
#include "validation/hard_cases/scene_maker.hpp"
#include "validation/support/light_bvh_walk.hpp"

namespace gno::mutants {
namespace {

using hard::Random;
using host::Triangle;

const vec4 kPoint(0.125f, 0.25f, -0.25f, 1), kDirection(0.375f, 1, 0.25f, 0);

GnoForestGrid gridOf(const test::Scene& scene) {
    vec3 low(1), high(-1);
    for (const Triangle& t : scene.triangles) {
        low = glm::min(low, glm::min(t.a, glm::min(t.b, t.c)));
        high = glm::max(high, glm::max(t.a, glm::max(t.b, t.c)));
    }
    return host::forestGrid(scene.light, glm::min(low, high), glm::max(low, high), 32768);  // GNO_LIGHT_BVH_RESOLUTION
}

/// Casters around the light as well as far from it; every sixteenth is large.
std::vector<Triangle> soup(size_t count, double size) {
    Random random(1966);
    std::vector<Triangle> triangles;
    while (triangles.size() < count) {
        const double half = triangles.size() % 16 == 5 ? 0.5 : size;
        const glm::dvec3 at = random.inCube(1 - half);
        const auto corner = [&] { return hard::snapped(at + random.inCube(half)); };
        const vec3 a = corner(), b = corner(), c = corner();
        triangles.push_back({a, b, c});
    }
    return triangles;
}

LightBvhCase caseOf(std::string name, std::vector<Triangle> triangles, vec4 light, size_t samples, uint references = ~0u) {
    LightBvhCase c{std::move(name), {}};
    c.references = references;
    c.scene.light = light;
    c.scene.triangles = std::move(triangles);
    Random random(7);
    for (size_t i = 0; c.scene.triangles.empty() && i < samples; ++i) c.scene.samples.push_back({hard::snapped(random.inCube()), GNO_NO_CASTER});
    if (!c.scene.triangles.empty()) hard::addHardSamples(c.scene, random, samples);
    c.grid = gridOf(c.scene);
    for (const Triangle& t : c.scene.triangles) c.casters.push_back({t.a, t.b, t.c});
    for (const host::OracleSample& s : c.scene.samples) {
        const exact::Vec p = exact::fixed(s.position);
        uint8_t dark = 0;
        for (uint i = 0; i < c.casters.size() && dark == 0; ++i)
            dark =
                i != s.own && exact::inShadowOf(light, exact::fixed(c.casters[i].a), exact::fixed(c.casters[i].b), exact::fixed(c.casters[i].c), p);
        c.want.push_back(dark);
    }
    return c;
}

}  // namespace

std::vector<LightBvhCase> makeLightBvhCases() {
    std::vector<LightBvhCase> cases;
    for (const vec4 light : {kPoint, kDirection}) {
        const std::string of = light.w != 0 ? ", point light" : ", directional light";
        for (const uint count : {300u, 65u, 64u, 9u, 5u, 3u, 2u, 1u})
            cases.push_back(caseOf(fmt::format("{} casters", count) + of, soup(count, 0.1), light, count > 100 ? 400 : 60));
        cases.push_back(caseOf("one caster many times" + of, std::vector<Triangle>(90, soup(1, 0.05).front()), light, 60));
        const vec3 up(light), on = light.w == 0 ? vec3(0) : up;
        cases.push_back(caseOf("all are edge-on" + of, std::vector<Triangle>(70, Triangle{on, on + 0.5f * up, on - 0.25f * up}), light, 20));
        cases.back().references = 0;
        cases.push_back(caseOf("nobody" + of, {}, light, 20, 0));
    }
    cases.push_back(caseOf("one reference a caster", soup(200, 0.02), kDirection, 100, 200));
    std::vector<Triangle> box;
    host::cases::addBox(box, {-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f});
    for (const vec4 light : {vec4(0, 0, 0, 1), vec4(0.5f, 0, 0, 1), vec4(0.5f, 0.5f, 0.5f, 1), vec4(0, 0, 0.5f - 0x1p-30f, 1)})
        cases.push_back(caseOf("a box around the light", box, light, 100));
    return cases;
}

std::string wrongTree(cpu::LightBvh& tree, const LightBvhCase& c) {
    for (const bool backwards : {false, true}) {
        tree.build(c.casters, c.scene.light, c.grid, 0, backwards);
        test::LightBvhWalk walk{.triangles = c.scene.triangles, .light = c.scene.light};
        for (const cpu::LightBvhNode& node : tree.nodes()) walk.nodes.push_back({node.low, node.high, node.least, node.link});
        walk.parents = tree.parents();
        const uint64_t nodes = walk.all(tree.roots());
        if (!walk.error.empty()) return fmt::format("{}: {}", c.name, walk.error);
        if (walk.leaves.size() != tree.references())
            return fmt::format("{}: {} leaves, {} references", c.name, walk.leaves.size(), tree.references());
        if (c.references != ~0u && tree.references() != c.references) return fmt::format("{}: {} references", c.name, tree.references());
        if (nodes > gnoLightBvhNodes(tree.references())) return fmt::format("{}: {} nodes", c.name, nodes);
        uint overflows = 0;
        for (const cpu::LightBvhQuery query : cpu::kLightBvhQueries)
            for (size_t i = 0; i < c.want.size(); ++i) {
                const cpu::LightBvhAnswer got = tree.ask(query, {c.scene.samples[i].position, c.scene.samples[i].own});
                overflows += got.stackOverflows;
                if (got.visibility != (c.want[i] ? GNO_VISIBILITY_SHADOW : GNO_VISIBILITY_LIT))
                    return fmt::format("{}: query {}, sample {} is {}", c.name, int(query), i, got.visibility);
                if (query == cpu::LightBvhQuery::stack && got.stackOverflows > 0) return fmt::format("{}: 32 entries overflow", c.name);
            }
        if (c.casters.size() == 300 && overflows == 0) return fmt::format("{}: one entry never overflows", c.name);
    }
    return {};
}

std::string wrongPool(cpu::LightBvh& tree, const LightBvhCase& c) {
    tree.build(c.casters, c.scene.light, c.grid, 0, false);
    const uint references = tree.references();
    for (const uint capacity : {references - 1, references / 2, 1u}) {
        tree.build(c.casters, c.scene.light, c.grid, capacity, false);
        if (tree.references() != references) return fmt::format("{}: a pool of {} has another number of references", c.name, capacity);
        for (const cpu::LightBvhQuery query : cpu::kLightBvhQueries)
            if (tree.ask(query, {c.scene.samples[0].position, c.scene.samples[0].own}).visibility != GNO_VISIBILITY_UNKNOWN)
                return fmt::format("{}: a pool of {} is asked all the same", c.name, capacity);
    }
    return {};
}

LightBvhCost costOf(cpu::LightBvh& tree, const LightBvhCase& c) {
    tree.build(c.casters, c.scene.light, c.grid, 0, false);
    LightBvhCost cost;
    for (const host::OracleSample& s : c.scene.samples) {
        cost.stack += tree.ask(cpu::LightBvhQuery::stack, {s.position, s.own}).visitedNodes;
        cost.stackless += tree.ask(cpu::LightBvhQuery::stackless, {s.position, s.own}).visitedNodes;
    }
    return {cost.stack / double(c.want.size()), cost.stackless / double(c.want.size())};
}

namespace {

/// A few casters of any size near the light, with one as a rule reaching over several faces of its cube, and samples on and beside the borders of
/// their volumes.
test::Scene nearTheLight(uint32_t seed) {
    Random random(seed);
    test::Scene scene;
    scene.light = seed % 3 != 0 ? hard::pointLight(random.inCube(0.5)) : hard::directionalLight(random.inCube());
    const glm::dvec3 middle = scene.light.w != 0 ? glm::dvec3(scene.light) : glm::dvec3(0);
    while (scene.triangles.size() < 6) {
        const double size = std::ldexp(0.45, -int(random.below(8)));
        const glm::dvec3 at = middle + random.inCube(std::min(0.45, 3 * size));
        const auto corner = [&] { return hard::snapped(at + random.inCube(size)); };
        const vec3 a = corner(), b = corner(), c = corner();
        scene.triangles.push_back({a, b, c});
    }
    hard::addHardSamples(scene, random, 300);
    return scene;
}

}  // namespace

std::string wrongBounds(const cpu::LightBvh& tree, uint64_t& shadows) {
    for (uint32_t seed = 1; seed <= 8000; ++seed) {
        const test::Scene scene = nearTheLight(seed);
        const GnoForestGrid grid = gridOf(scene);
        for (size_t caster = 0; caster < scene.triangles.size(); ++caster) {
            const Triangle& t = scene.triangles[caster];
            const auto a = exact::fixed(t.a), b = exact::fixed(t.b), c = exact::fixed(t.c);
            const int facing = exact::orient3dLight(scene.light, a, b, c);
            for (size_t i = 0; i < scene.samples.size(); ++i) {
                const vec3 p = scene.samples[i].position;
                if (!exact::inShadowOf(scene.light, a, b, c, exact::fixed(p))) continue;
                ++shadows;
                const std::string why = tree.lost(scene.light, grid, {t.a, t.b, t.c}, facing, p);
                if (!why.empty()) return fmt::format("scene {}, caster {}, sample {}: {}", seed, caster, i, why);
            }
        }
    }
    return {};
}

}  // namespace gno::mutants
