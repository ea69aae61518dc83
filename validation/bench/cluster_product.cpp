// SPDX-License-Identifier: MIT
// Every combination of light, bounds, split and planes against the oracle, in one process, so that a pipeline is compiled once.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>
#include <filesystem>

#include "host_min/error.hpp"
#include "host_min/oracle.hpp"
#include "validation/bench/cluster_tables.hpp"

namespace gno::bench {
namespace {

struct Sum {
    uint64_t runs = 0, checked = 0, wrong = 0;
};

/// Casters are taken for opaque here: the mask is what is compared.
void check(const host::FrameInputs& inputs, const host::OracleAnswer& answer, const std::string& what, const std::string& technique,
           std::vector<std::string> settings, host::Precision precision, Sum& sum) {
    host::Technique& which = host::techniqueByName(technique);
    host::StructureCache structures;
    if (technique.starts_with("ptsv")) settings.emplace_back("materials=off");
    const host::TechniqueResult result =
        which.run(inputs, structures, host::Settings(which.info().settings, settings), {precision, 1, false, false, false});
    uint64_t wrong = 0;
    size_t sample = 0;
    for (size_t i = 0; i < inputs.pixels().size(); ++i) {
        if (inputs.pixels()[i].own > GNO_NO_CASTER) continue;
        wrong += result.visibility[i] != (answer.inShadow[sample++] ? GNO_VISIBILITY_SHADOW : GNO_VISIBILITY_LIT);
    }
    ++sum.runs;
    sum.checked += sample;
    sum.wrong += wrong;
    if (wrong > 0) fmt::print("{}, {} {}: {} wrong of {}\n", what, technique, fmt::join(settings, " "), wrong, sample);
    std::fflush(stdout);
}

}  // namespace

uint64_t printProduct(host::PassCache& passes, const ClusterJob& job) {
    Sum all;
    for (const std::string& scene : job.scenes) {
        const host::Frame frame = host::SceneFile::load(scene).evaluate(0, 0);
        host::FrameInputs inputs(passes, frame, job.width, job.height);
        Sum sum;
        for (size_t light = 0; light < frame.lights.size(); ++light) {
            inputs.setLight(frame.lights[light].homogeneous, job.cull);
            std::vector<host::OracleSample> samples;
            for (const host::OracleSample& pixel : inputs.pixels())
                if (pixel.own <= GNO_NO_CASTER) samples.push_back(pixel);
            const std::vector<uint8_t> casters = inputs.definitionCasters();
            const host::OracleAnswer answer = host::makeOracle()->ask({frame.triangles, casters, inputs.light(), samples}, [](double) {});
            const std::string what = fmt::format("{} light {}", std::filesystem::path(scene).stem().string(), light);
            check(inputs, answer, what, "d-hybrid", {}, job.precision, sum);
            for (const char* split : {"off", "1", "2", "3"}) {
                const std::string splitSetting = std::string("split=") + split;
                for (const char* planes : {"own", "extra"})
                    check(inputs, answer, what, "ptsv-2011", {splitSetting, std::string("planes=") + planes}, job.precision, sum);
                for (const char* bounds : {"implicit", "explicit", "compact"})
                    check(inputs, answer, what, "ptsv", {splitSetting, std::string("bounds=") + bounds}, job.precision, sum);
            }
            check(inputs, answer, what, "ptsv", {"planes=own", "split=off"}, job.precision, sum);
            check(inputs, answer, what, "ptsv", {"jobs=1", "split=2"}, job.precision, sum);
            check(inputs, answer, what, "ptsv", {"boxes=16"}, job.precision, sum);
        }
        fmt::print("{}: {} casters, {} lights, {} runs, {} samples checked, {} wrong\n", std::filesystem::path(scene).stem().string(),
                   inputs.casterCount(), frame.lights.size(), sum.runs, sum.checked, sum.wrong);
        std::fflush(stdout);
        all.runs += sum.runs;
        all.checked += sum.checked;
        all.wrong += sum.wrong;
    }
    fmt::print("all: {} runs, {} samples checked, {} wrong\n", all.runs, all.checked, all.wrong);
    return all.wrong;
}

}  // namespace gno::bench
