// SPDX-License-Identifier: MIT
// gnomon-light-grid-mutants [NAME...]: the light grid's text on the CPU: the definition's answer for every sample of every scene. What is printed:
// run.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host_min/techniques/cell_assignment.hpp"
#include "validation/mutants/run.hpp"
#include "validation/support/exact_reference.hpp"
#include "validation/support/light_grid_on_cpu.hpp"
#include "validation/tests/oracle_cases.hpp"

namespace gno::mutants {
namespace {

struct Scene {
    std::string name;
    std::vector<GnoCaster> casters;
    vec4 light;
    GnoForestGrid grid;
    uint nest;
    std::vector<GnoViewSample> samples;
    std::vector<uint8_t> want;
};

bool inShadow(const std::vector<GnoCaster>& casters, vec4 light, const GnoViewSample& s) {
    const exact::Vec p = exact::fixed(s.position);
    for (uint i = 0; i < casters.size(); ++i)
        if (i != s.own && exact::inShadowOf(light, exact::fixed(casters[i].a), exact::fixed(casters[i].b), exact::fixed(casters[i].c), p))
            return true;
    return false;
}

/// A sample with an own caster lies strictly on the light's side of it: core/sample.glsl sees to that, and a covering caster relies on it.
bool keepsTheContract(const std::vector<GnoCaster>& casters, vec4 light, const GnoViewSample& s) {
    if (s.own == GNO_NO_CASTER) return true;
    const exact::Vec a = exact::fixed(casters[s.own].a), b = exact::fixed(casters[s.own].b), c = exact::fixed(casters[s.own].c),
                     l = exact::fixed(vec3(light));
    using exact::operator-;
    const int front = light.w != 0 ? exact::orient3d(a, b, c, l) : exact::sign(exact::det(b - a, c - a, l));
    return front != 0 && exact::orient3d(a, b, c, exact::fixed(s.position)) == front;
}

/// The hard cases of the oracle, with samples on, next to and far behind all that is hard, in three grids.
std::vector<Scene> makeScenes(uint32_t seed) {
    std::vector<Scene> scenes;
    for (const host::cases::HardCase& hard : host::cases::hardCases(seed, 160)) {
        if (!hard.isCaster.empty() || hard.triangles.empty()) continue;
        Scene scene{hard.name, {}, hard.light, {}, 0, {}, {}};
        vec3 low(1e9f), high(-1e9f);
        for (const host::Triangle& t : hard.triangles) {
            scene.casters.push_back({t.a, t.b, t.c});
            for (const vec3& v : {t.a, t.b, t.c}) low = glm::min(low, v), high = glm::max(high, v);
        }
        for (const host::OracleSample& s : hard.samples) {
            scene.samples.push_back({s.position, s.own});
            if (!keepsTheContract(scene.casters, scene.light, scene.samples.back())) scene.samples.back().own = GNO_NO_CASTER;
            scene.want.push_back(inShadow(scene.casters, scene.light, scene.samples.back()));
        }
        for (const auto& [resolution, nest] : {std::pair{1u, 0u}, {4u, 1u}, {16u, 1u}}) {
            scene.grid = host::forestGrid(hard.light, low, high, resolution);
            scene.nest = nest;
            scene.name = fmt::format("{}, {} cells, nest {}, seed {}", hard.name, resolution, nest, seed);
            scenes.push_back(scene);
        }
    }
    return scenes;
}

/// Empty: all as the definition says.
std::string failure(cpu::LightGrid& grid, const Scene& scene) {
    try {
        grid.build(scene.casters, scene.light, scene.grid, scene.samples, scene.nest);
        for (size_t i = 0; i < scene.samples.size(); ++i)
            for (const bool planes : {false, true})
                if (grid.ask(scene.samples[i], planes) != (scene.want[i] != 0))
                    return fmt::format("{}: sample {} is {}, {}", scene.name, i, scene.want[i] ? "lit" : "dark",
                                       planes ? "by planes" : "by vertices");
    } catch (const std::exception& error) {
        return scene.name + ": " + error.what();
    }
    return "";
}

}  // namespace
}  // namespace gno::mutants

int main(int argc, char** argv) {
    using namespace gno;
    std::vector<mutants::Scene> scenes;
    for (uint32_t seed = 1; seed <= 4; ++seed)
        for (mutants::Scene& scene : mutants::makeScenes(seed)) scenes.push_back(std::move(scene));
    size_t dark = 0, samples = 0;
    for (const mutants::Scene& scene : scenes) {
        samples += scene.want.size();
        dark += size_t(std::count(scene.want.begin(), scene.want.end(), 1));
    }
    return mutants::run({argv + 1, argv + argc}, cpu::lightGridVariants(),
                        [&](const cpu::LightGridVariant& variant, bool mutant) -> mutants::Verdict {
                            const auto grid = variant.make();
                            uint64_t nests = 0;
                            for (const mutants::Scene& scene : scenes) {
                                const std::string wrong = mutants::failure(*grid, scene);
                                nests += grid->header().nests;
                                if (!wrong.empty()) return {wrong};
                            }
                            if (!mutant && (nests == 0 || dark == 0 || dark == samples)) return {"no nested cell, or no shadow, or no light"};
                            return {"", fmt::format("{} scenes, {} of {} samples dark, {} nested cells", scenes.size(), dark, samples, nests)};
                        });
}
