// SPDX-License-Identifier: MIT
#include "validation/bench/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "host_min/error.hpp"
#include "host_min/output/table.hpp"

namespace gno::bench {
namespace {

std::vector<uint8_t> oracleMask(const host::FrameInputs& inputs) {
    std::vector<host::OracleSample> samples;
    for (const host::OracleSample& pixel : inputs.pixels())
        if (pixel.own <= GNO_NO_CASTER) samples.push_back(pixel);
    return host::makeOracle()->ask({inputs.frame().triangles, {}, inputs.light(), samples}, [](double) {}).inShadow;
}

}  // namespace

std::string Statistic::text(int digits) const { return fmt::format("{:.{}f} ± {:.{}f}", mean, digits, deviation, digits); }

Statistic statistic(const std::vector<double>& values) {
    Statistic result;
    if (values.empty()) return result;
    for (const double v : values) result.mean += v / double(values.size());
    for (const double v : values) result.deviation += (v - result.mean) * (v - result.mean);
    result.deviation = values.size() > 1 ? std::sqrt(result.deviation / double(values.size() - 1)) : 0;
    return result;
}

Statistic ratio(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> values;
    for (size_t i = 0; i < a.size(); ++i) values.push_back(a[i] / b[i]);
    return statistic(values);
}

double medianRatio(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> values;
    for (size_t i = 0; i < a.size(); ++i) values.push_back(a[i] / b[i]);
    std::sort(values.begin(), values.end());
    return (values.at((values.size() - 1) / 2) + values.at(values.size() / 2)) / 2;
}

std::string stem(const std::string& scene) { return std::filesystem::path(scene).stem().string(); }

Subject::Subject(host::PassCache& passes, const Job& job, bool check)
    : frame_(host::SceneFile::load(job.scene).evaluate(job.frame, 0)), inputs_(passes, frame_, job.width, job.height) {
    if (job.light >= frame_.lights.size())
        throw host::InputError(fmt::format("--light {}: {} has {} lights", job.light, job.scene, frame_.lights.size()));
    inputs_.setLight(frame_.lights[job.light].homogeneous, job.cull);
    if (check) truth_ = oracleMask(inputs_);
}

uint64_t Subject::wrong(const std::vector<uint32_t>& visibility) const {
    uint64_t wrong = 0;
    size_t sample = 0;
    for (size_t i = 0; i < visibility.size(); ++i)
        if (inputs_.pixels()[i].own <= GNO_NO_CASTER) wrong += (visibility[i] == GNO_VISIBILITY_SHADOW) != (truth_[sample++] != 0);
    return wrong;
}

std::map<host::Precision, Results> run(host::PassCache& passes, const Job& job) {
    host::Progress progress;
    progress.show(job.scene);
    const Subject subject(passes, job, job.check);
    const host::FrameInputs& inputs = subject.inputs();
    const double samples = double(std::max<uint64_t>(inputs.sampleCount(), 1));
    struct Lists {
        std::vector<double> nodes, build, query, exact, wrong, overflows, stack, steps;
    };
    std::map<host::Precision, std::map<std::string, Lists>> lists;
    std::map<host::Precision, Results> results;
    const auto measure = [&](host::Precision precision, uint32_t seed, bool first) {  // first: the seed's first repeat, with counters
        host::StructureCache structures;
        for (const std::string& name : job.techniques) {
            progress.show(fmt::format("{} {} {}", job.scene, name, host::name(precision)), double(seed - 1) / job.seeds);
            host::Technique& technique = host::techniqueByName(name);
            std::vector<std::string> given;
            for (const std::string& setting : job.settings)
                for (const host::SettingInfo& info : technique.info().settings)
                    if (setting.starts_with(info.key + "=")) given.push_back(setting);
            given.push_back(fmt::format("seed={}", seed));
            const host::Settings settings(technique.info().settings, given);
            const host::TechniqueResult out = technique.run(inputs, structures, settings, {precision, 1, first, false, first && seed == 1});
            Lists& list = lists[precision][name];
            double build = 0, query = 0;
            for (const host::RecordPass& pass : out.passes) (host::isBuildPass(pass.name) ? build : query) += pass.ms;
            list.build.push_back(build);
            list.query.push_back(query);
            if (job.check) list.wrong.push_back(double(subject.wrong(out.visibility)));
            results[precision][name].treeBytes = out.bytes.front().second;
            if (!first) continue;
            list.nodes.push_back(double(out.counters.visitedNodes) / samples);
            list.exact.push_back(double(out.counters.exactCalls) / samples);
            list.overflows.push_back(double(out.counters.stackOverflows));
            list.stack.push_back(double(out.counters.maxStack));
            for (const auto& [key, value] : out.counters.more)
                if (key == "build_steps") list.steps.push_back(double(value) / double(std::max<uint64_t>(inputs.casterCount(), 1)));
        }
    };
    for (uint32_t seed = 1; seed <= job.seeds; ++seed)
        for (uint32_t repeat = 0; repeat < job.repeats; ++repeat)
            for (const host::Precision precision : job.precisions) measure(precision, seed, repeat == 0);

    for (auto& [precision, byTechnique] : results) {
        for (auto& [name, result] : byTechnique) {
            const Lists& list = lists.at(precision).at(name);
            result.casters = inputs.casterCount();
            result.triangles = inputs.triangleCount();
            result.samples = inputs.sampleCount();
            result.nodes = statistic(list.nodes);
            result.buildMs = statistic(list.build);
            result.queryMs = statistic(list.query);
            result.exactCalls = statistic(list.exact);
            result.wrong = statistic(list.wrong);
            result.overflows = statistic(list.overflows);
            result.maxStack = statistic(list.stack);
            result.buildSteps = statistic(list.steps);
            result.nodesBySeed = list.nodes;
            result.queryMsByRun = list.query;
            result.buildMsByRun = list.build;
        }
    }
    progress.clear();
    return results;
}

}  // namespace gno::bench
