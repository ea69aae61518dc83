// SPDX-License-Identifier: MIT
#include "validation/mutants/forest_cases.hpp"

#include <algorithm>

#include "validation/mutants/cases.hpp"
#include "validation/mutants/light_face.hpp"

namespace gno::mutants {
namespace {

/// Casters one behind the other, the first of them over whole cells; samples before, between and behind them.
cpu::TinyScene layers(Random& r) {
    const Face f = anyFace(r, 4);
    cpu::TinyScene s;
    s.light = f.light;
    for (int i = 0; i < 6; ++i) {
        const double t = f.light.w == 0.0f ? 0.8 * r.real() : 0.1 + 0.4 * (r.real() + 1), size = 0.4 + 0.6 * (r.real() + 1),
                     tilt = 0.1 * r.real() * r.below(2);
        const GnoCaster c{snap(f.at(-size, -size, t)), snap(f.at(size, -size, t * (1 + tilt))), snap(f.at(0.1 * r.real(), size, t * (1 - tilt)))};
        if (inScene(c)) s.casters.push_back(c);
    }
    addEverywhere(r, s, 40);
    for (int i = 0; i < 20; ++i) addSample(s, snap(f.at(0.5 * r.real(), 0.5 * r.real(), f.light.w == 0.0f ? r.real() : (r.real() + 1) / 2)));
    return s;
}

/// Samples all at one distance from the light or a hair apart, casters that start there, too.
cpu::TinyScene sameDepth(Random& r) {
    const Face f = anyFace(r, 4);
    cpu::TinyScene s;
    s.light = f.light;
    const double far = 0.4 + 0.2 * r.real();
    const auto at = [&](double hair) {
        const double t = far * (1 + hair);
        if (f.light.w == 0.0f) return snap(f.at(0.5 * r.real(), 0.5 * r.real(), t));
        return snap(dvec3(vec3(f.light)) + glm::normalize(dvec3(r.real(), r.real(), r.real()) + 1e-9) * t);
    };
    for (int i = 0; i < 10; ++i) {
        const vec3 a = at(0);
        const auto beside = [&] { return snap(dvec3(a) + 0.2 * dvec3(r.real(), r.real(), r.real())); };
        const GnoCaster c{a, beside(), beside()};
        if (inScene(c)) s.casters.push_back(c);
        addSample(s, snap(behind(f.light, dvec3(a), 1 + std::ldexp(1.0, -18 - r.below(6)))));
        addSample(s, r.neighbour(a));
    }
    addEverywhere(r, s, 20);
    return s;
}

}  // namespace

std::vector<ForestCase> makeForestCases(size_t scenes) {
    std::vector<ForestCase> cases;
    const auto add = [&](const char* name, uint64_t seed, cpu::TinyScene (*make)(Random&)) {
        Random r(seed);
        ForestCase c{name, {}, {}};
        for (size_t i = 0; i < 2 * scenes; ++i) {
            c.scenes.push_back(make(r));
            c.expected.push_back(cpu::exactAnswers(c.scenes.back()));
        }
        cases.push_back(std::move(c));
    };
    add("casters over whole cells, one behind the other", 11, layers);
    add("casters that start where samples lie", 12, sameDepth);
    for (Case& c : makeCases()) {
        if (c.check != Check::tree) continue;
        c.scenes.resize(std::min(c.scenes.size(), scenes));
        c.expected.resize(c.scenes.size());
        cases.push_back({c.name, std::move(c.scenes), std::move(c.expected)});
    }
    return cases;
}

std::string failure(const ForestCase& c, cpu::Forest& forest, size_t scenes) {
    constexpr uint kSmall[] = {1, 4, 2, 16};
    for (size_t i = 0; i < std::min(c.scenes.size(), scenes); ++i) {
        const cpu::TinyScene& s = c.scenes[i];
        for (uint way = 0; way < 4; ++way) {
            const GnoForestGrid grid = host::forestGrid(s.light, vec3(-1), vec3(1), kSmall[(i + way) % 4]);
            const cpu::ForestChoice choice{.viewCull = way % 2 == 0, .cover = way < 2, .seed = uint(i)};
            const std::string wrong = cpu::wrongForest(forest, s, grid, c.expected[i], choice, uint(i + way) % cpu::kFloatModes);
            if (!wrong.empty()) return c.name + ", scene " + std::to_string(i) + ": " + wrong + "\n" + show(s);
        }
    }
    return {};
}

}  // namespace gno::mutants
