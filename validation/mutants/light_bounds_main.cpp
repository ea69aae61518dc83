// SPDX-License-Identifier: MIT
// gnomon-light-bounds-mutants [NAME...]: bounds of casters in a light's cells, on the CPU. As the text stands no caster may be lost for a sample
// that it shadows, by the definition in integers; every mutant that this program is linked with (or those named) has to lose one. Prints a table:
// mutant, killed by. Exit code 0: all as it should be; 1: not; then it says which.
#include <fmt/format.h>

#include <algorithm>

#include "glsl/rivals/light_bvh.h"
#include "host_min/techniques/cell_assignment.hpp"
#include "validation/hard_cases/scene_maker.hpp"
#include "validation/support/exact_reference.hpp"
#include "validation/support/light_bounds_on_cpu.hpp"

namespace gno::mutants {
namespace {

using host::cases::Random;

constexpr uint32_t kScenes = 8000;

/// A few casters of any size near the light, with one as a rule reaching over several faces of its cube, and samples on and beside the borders of
/// their volumes.
test::Scene sceneOf(uint32_t seed) {
    Random random(seed);
    test::Scene scene;
    scene.light = seed % 3 != 0 ? hard::pointLight(random.inCube(0.5)) : hard::directionalLight(random.inCube());
    const glm::dvec3 middle = scene.light.w != 0 ? glm::dvec3(scene.light) : glm::dvec3(0);
    while (scene.triangles.size() < 6) {
        const double size = std::ldexp(0.45, -int(random.below(8)));
        const glm::dvec3 at = middle + random.inCube(std::min(0.45, 3 * size));
        const auto corner = [&] { return hard::snapped(at + random.inCube(size)); };
        const glm::vec3 a = corner(), b = corner(), c = corner();
        scene.triangles.push_back({a, b, c});
    }
    hard::addHardSamples(scene, random, 300);
    return scene;
}

/// Empty: none is lost. `shadows` counts the pairs of caster and shadowed sample.
std::string firstLoss(const cpu::LightBoundsVariant& variant, uint64_t& shadows) {
    for (uint32_t seed = 1; seed <= kScenes; ++seed) {
        const test::Scene scene = sceneOf(seed);
        glm::vec3 low(1), high(-1);
        for (const host::Triangle& t : scene.triangles) {
            low = glm::min(low, glm::min(t.a, glm::min(t.b, t.c)));
            high = glm::max(high, glm::max(t.a, glm::max(t.b, t.c)));
        }
        const GnoForestGrid grid = host::forestGrid(scene.light, low, high, GNO_LIGHT_BVH_RESOLUTION);
        for (size_t caster = 0; caster < scene.triangles.size(); ++caster) {
            const host::Triangle& t = scene.triangles[caster];
            const auto a = exact::fixed(t.a), b = exact::fixed(t.b), c = exact::fixed(t.c);
            const int facing = exact::orient3dLight(scene.light, a, b, c);
            for (size_t i = 0; i < scene.samples.size(); ++i) {
                const glm::vec3 p = scene.samples[i].position;
                if (!exact::inShadowOf(scene.light, a, b, c, exact::fixed(p))) continue;
                ++shadows;
                const std::string why = variant.lost(scene.light, grid, {t.a, t.b, t.c}, facing, p);
                if (!why.empty()) return fmt::format("scene {}, caster {}, sample {}: {}", seed, caster, i, why);
            }
        }
    }
    return "";
}

}  // namespace
}  // namespace gno::mutants

int main(int argc, char** argv) {
    const std::vector<std::string> wanted(argv + 1, argv + argc);
    auto variants = gno::cpu::lightBoundsVariants();
    std::sort(variants.begin(), variants.end(), [](const auto& x, const auto& y) { return x.name < y.name; });
    int mutants = 0, faults = 0;
    for (const auto& variant : variants) {
        if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), variant.name) == wanted.end()) continue;
        const bool mutant = variant.name.find('.') != std::string::npos;
        uint64_t shadows = 0;
        const std::string loss = gno::mutants::firstLoss(variant, shadows);
        mutants += mutant;
        if (mutant) {
            faults += loss.empty();
            fmt::print("{:<50} {}\n", variant.name, loss.empty() ? "SURVIVES" : "killed by: " + loss);
        } else {
            faults += !loss.empty() || shadows < 10000;
            fmt::print("{:<50} {}\n", variant.name,
                       loss.empty() ? fmt::format("the text as it stands, {} shadows, none lost", shadows) : "FAILS: " + loss);
        }
    }
    fmt::print("{} mutants, {} faults\n", mutants, faults);
    return faults == 0 && (mutants > 0 || !wanted.empty()) ? 0 : 1;
}
