// SPDX-License-Identifier: MIT
#include "validation/hard_cases/runner.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "host_min/error.hpp"
#include "validation/hard_cases/scene_maker.hpp"
#include "validation/support/exact_reference.hpp"

namespace gno::hard {
namespace {

constexpr uint64_t kBruteForceLimit = 400'000;  // sample-caster pairs of one scene

std::string hex(glm::vec3 v) { return fmt::format("({:a}, {:a}, {:a})", v.x, v.y, v.z); }

std::string describe(const test::Scene& scene, size_t sample, const host::OracleAnswer& answer) {
    const host::OracleSample& s = scene.samples[sample];
    std::string text = fmt::format("light {} w {}, sample {} at {} own {}, in shadow by the definition: {}", hex(scene.light), scene.light.w, sample,
                                   hex(s.position), s.own, answer.inShadow[sample] != 0);
    if (answer.caster[sample] != host::kNoCaster) {
        const Triangle& t = scene.triangles[answer.caster[sample]];
        text += fmt::format(", by caster {} {} {} {}", answer.caster[sample], hex(t.a), hex(t.b), hex(t.c));
    }
    return text;
}

/// The oracle against the definition over 128-bit integers, every sample against every caster.
std::string bruteForce(const test::Scene& scene, const std::vector<uint8_t>& isCaster, const host::OracleAnswer& answer) {
    std::vector<std::array<exact::Vec, 3>> casters;
    for (const Triangle& t : scene.triangles) casters.push_back({exact::fixed(t.a), exact::fixed(t.b), exact::fixed(t.c)});
    for (size_t i = 0; i < scene.samples.size(); ++i) {
        const exact::Vec p = exact::fixed(scene.samples[i].position);
        bool dark = false;
        for (size_t k = 0; k < casters.size() && !dark; ++k) {
            if (k == scene.samples[i].own || (!isCaster.empty() && !isCaster[k])) continue;
            dark = exact::inShadowOf(scene.light, casters[k][0], casters[k][1], casters[k][2], p);
        }
        if (dark != (answer.inShadow[i] != 0)) return describe(scene, i, answer);
    }
    return {};
}

/// Insertion seeds of one scene: every second one puts the case's chosen triangle first.
std::vector<uint32_t> insertionSeeds(const HardCase& hardCase, const test::Scene& scene, uint32_t count) {
    std::vector<uint32_t> seeds;
    uint32_t from = 1;
    for (uint32_t i = 0; i < count; ++i) {
        const bool chosen = hardCase.first != kAnyFirst && i % 2 == 0;
        seeds.push_back(chosen ? seedThatInsertsFirst(hardCase.first, uint32_t(scene.triangles.size()), from) : from);
        from = seeds.back() + 1;
    }
    return seeds;
}

bool has(const host::TechniqueInfo& info, const std::string& key) {
    return std::any_of(info.settings.begin(), info.settings.end(), [&](const host::SettingInfo& setting) { return setting.key == key; });
}

/// Settings of the runs at insertion seed number `at`: all choices at the first, one of them at each later one.
std::vector<std::vector<std::string>> settingsAt(const HardCase& hardCase, size_t at, uint32_t seed) {
    std::vector<std::string> settings(hardCase.settings);
    settings.push_back(fmt::format("seed={}", seed));
    std::vector<std::vector<std::string>> all(hardCase.choices.empty() || at > 0 ? 1 : hardCase.choices.size(), settings);
    for (size_t i = 0; i < all.size() && !hardCase.choices.empty(); ++i) all[i].push_back(hardCase.choices[(at + i) % hardCase.choices.size()]);
    return all;
}

void add(Tally& tally, const test::Scene& scene, const host::TechniqueResult& result, const host::OracleAnswer& answer, const std::string& how) {
    ++tally.runs;
    tally.answers += scene.samples.size();
    const test::Wrong wrong = test::compare(result, answer, scene.samples);
    tally.wrong += wrong.wrong;
    tally.leaks += wrong.leaks;
    tally.falseDark += wrong.falseDark;
    for (size_t i = 0; i < std::min(scene.samples.size(), result.visitedNodes.size()); ++i) tally.visitedNodes += result.visitedNodes[i];
    if (wrong.wrong > 0 && tally.firstWrong.empty()) tally.firstWrong = how + ": " + describe(scene, wrong.first, answer);
}

}  // namespace

CaseResult runCase(const HardCase& hardCase, const RunnerOptions& options, const std::function<void()>& step) {
    CaseResult result;
    result.hardCase = &hardCase;
    for (const auto& technique : host::techniques()) {
        const auto& rungs = technique->info().precisions;
        const bool claims =
            std::find(rungs.begin(), rungs.end(), host::Precision::certified) != rungs.end();  // a shadow map does not claim the definition
        if (!claims && !options.uncertified) continue;
        for (const host::Precision precision : rungs)
            if (!options.certifiedOnly || precision == host::Precision::certified)
                result.tallies.push_back({.technique = technique->info().name, .precision = precision});
    }

    for (uint32_t sceneSeed = 1; sceneSeed <= hardCase.scenes; ++sceneSeed) {
        const test::Scene scene = hardCase.make(sceneSeed);
        const host::Frame frame = test::frameOf(scene);
        host::FrameInputs inputs(test::passes(), frame, scene.samples, scene.width);
        inputs.setLight(scene.light, scene.cull);
        std::vector<host::OracleSample> asked(scene.samples);
        for (host::OracleSample& sample : asked)
            if (sample.own > host::kNoCaster) sample.own = host::kNoCaster;  // background, or facing away: nobody reads that answer
        const std::vector<uint8_t> casters = test::castersOf(scene);
        const host::OracleAnswer answer = host::makeOracle()->ask({scene.triangles, casters, scene.light, asked}, [](double) {});
        result.triangles += scene.triangles.size();
        result.samples += scene.samples.size();
        result.inShadow += uint64_t(std::count(answer.inShadow.begin(), answer.inShadow.end(), uint8_t(1)));
        if (scene.triangles.size() * scene.samples.size() <= kBruteForceLimit) {
            result.bruteForced += scene.samples.size();
            if (result.oracleWrong.empty()) result.oracleWrong = bruteForce(scene, casters, answer);
        }

        const std::vector<uint32_t> seeds = insertionSeeds(hardCase, scene, std::max(1u, options.insertionSeeds / hardCase.scenes));
        for (size_t at = 0; at < seeds.size(); ++at) {
            host::StructureCache structures;
            const auto settings = settingsAt(hardCase, at, seeds[at]);
            for (Tally& tally : result.tallies) {
                host::Technique& technique = host::techniqueByName(tally.technique);
                if (at > 0 && !has(technique.info(), "seed")) continue;
                for (size_t i = 0; i < settings.size(); ++i) {
                    if (i > 0 && !has(technique.info(), settings[i].back().substr(0, settings[i].back().find('=')))) continue;
                    if (step) step();
                    const std::string how = fmt::format("{}, {}, scene seed {}, {}, {} triangles", tally.technique, host::name(tally.precision),
                                                        sceneSeed, fmt::join(settings[i], " "), scene.triangles.size());
                    try {
                        host::TechniqueResult run = technique.run(inputs, structures, host::Settings(technique.info().settings, settings[i]),
                                                                  {tally.precision, 1, options.counters, false});
                        run.visibility.resize(scene.samples.size());
                        add(tally, scene, run, answer, how);
                    } catch (const host::InputError& error) {
                        tally.refused = error.what();
                    }
                }
            }
        }
    }
    return result;
}

}  // namespace gno::hard
