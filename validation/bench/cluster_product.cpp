// SPDX-License-Identifier: MIT
// Every combination of light, bounds, split and planes against the oracle, in one process, so that a pipeline is compiled once.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>

#include "host_min/error.hpp"
#include "host_min/oracle.hpp"
#include "host_min/output/atomic_file.hpp"
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

/// View samples of a picture, one record of 16 bytes per pixel: position, own.
void writeSamples(const std::filesystem::path& path, const std::vector<host::OracleSample>& samples) {
    host::AtomicFile out(path);
    out.stream().write(reinterpret_cast<const char*>(samples.data()), std::streamsize(samples.size() * sizeof(host::OracleSample)));
    out.commit();
}

std::vector<host::OracleSample> readSamples(const std::filesystem::path& path) {
    static_assert(sizeof(host::OracleSample) == 16);
    std::ifstream in(path, std::ios::binary | std::ios::ate);
    if (!in) throw host::InputError(fmt::format("cannot read {}: write it with --keep", path.string()));
    std::vector<host::OracleSample> samples(size_t(in.tellg()) / sizeof(host::OracleSample));
    in.seekg(0);
    in.read(reinterpret_cast<char*>(samples.data()), std::streamsize(samples.size() * sizeof(host::OracleSample)));
    return samples;
}

}  // namespace

uint64_t printProduct(host::PassCache& passes, const ClusterJob& job) {
    Sum all;
    for (const std::string& scene : job.scenes) {
        const host::Frame frame = host::SceneFile::load(scene).evaluate(0, 0);
        const std::string stem = std::filesystem::path(scene).stem().string();
        std::optional<host::FrameInputs> rasterised;
        if (job.given.empty()) rasterised.emplace(passes, frame, job.width, job.height);
        Sum sum;
        uint64_t casterCount = 0;
        for (size_t light = 0; light < frame.lights.size(); ++light) {
            const std::string file = fmt::format("{}-l{}-{}x{}.samples", stem, light, job.width, job.height);
            std::optional<host::FrameInputs> given;
            std::vector<host::OracleSample> kept;
            if (!job.given.empty()) {
                kept = readSamples(std::filesystem::path(job.given) / file);
                given.emplace(passes, frame, kept, job.width);
            }
            host::FrameInputs& inputs = given ? *given : *rasterised;
            inputs.setLight(frame.lights[light].homogeneous, job.cull);
            if (!job.keep.empty()) writeSamples(std::filesystem::path(job.keep) / file, inputs.pixels());
            casterCount = inputs.casterCount();
            std::vector<host::OracleSample> samples;
            for (const host::OracleSample& pixel : inputs.pixels())
                if (pixel.own <= GNO_NO_CASTER) samples.push_back(pixel);
            const host::OracleAnswer answer = host::makeOracle()->ask({frame.triangles, {}, inputs.light(), samples}, [](double) {});
            const std::string what = fmt::format("{} light {}", stem, light);
            for (const char* technique : {"d-hybrid", "forest", "light-bvh", "light-grid"})
                check(inputs, answer, what, technique, {}, job.precision, sum);
            if (job.defaults) {
                check(inputs, answer, what, "ptsv-2011", {}, job.precision, sum);
                check(inputs, answer, what, "ptsv", {}, job.precision, sum);
                continue;
            }
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
        fmt::print("{}: {} casters, {} lights, {} runs, {} samples checked, {} wrong\n", stem, casterCount, frame.lights.size(), sum.runs,
                   sum.checked, sum.wrong);
        std::fflush(stdout);
        all.runs += sum.runs;
        all.checked += sum.checked;
        all.wrong += sum.wrong;
    }
    fmt::print("all: {} runs, {} samples checked, {} wrong\n", all.runs, all.checked, all.wrong);
    return all.wrong;
}

}  // namespace gno::bench
