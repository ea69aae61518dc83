// SPDX-License-Identifier: MIT
#include "validation/bench/run.hpp"

#include <fmt/format.h>

#include <cmath>

#include "host_min/output/table.hpp"

namespace gno::bench {
namespace {

std::vector<uint8_t> oracleMask(const host::FrameInputs& inputs) {
    std::vector<host::OracleSample> samples;
    for (const host::OracleSample& pixel : inputs.pixels())
        if (pixel.own <= GNO_NO_CASTER) samples.push_back(pixel);
    return host::makeOracle()->ask({inputs.frame().triangles, inputs.definitionCasters(), inputs.light(), samples}, [](double) {}).inShadow;
}

uint64_t countWrong(const host::FrameInputs& inputs, const std::vector<uint32_t>& visibility, const std::vector<uint8_t>& truth) {
    uint64_t wrong = 0;
    size_t sample = 0;
    for (size_t i = 0; i < visibility.size(); ++i)
        if (inputs.pixels()[i].own <= GNO_NO_CASTER) wrong += (visibility[i] == GNO_VISIBILITY_SHADOW) != (truth[sample++] != 0);
    return wrong;
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

std::map<std::string, Result> run(host::PassCache& passes, const Job& job) {
    host::Progress progress;
    progress.show(job.scene);
    const host::SceneFile file = host::SceneFile::load(job.scene);
    const host::Frame frame = file.evaluate(job.frame, 0);
    host::FrameInputs inputs(passes, frame, job.width, job.height);
    inputs.setLight(frame.lights.at(job.light).homogeneous, job.cull);
    const std::vector<uint8_t> truth = job.check ? oracleMask(inputs) : std::vector<uint8_t>();

    struct Lists {
        std::vector<double> nodes, build, query, exact, wrong, overflows, stack, steps;
    };
    std::map<std::string, Lists> lists;
    std::map<std::string, Result> results;
    for (uint32_t seed = 1; seed <= job.seeds; ++seed) {
        host::StructureCache structures;
        for (const std::string& name : job.techniques) {
            progress.show(fmt::format("{} {} {}", job.scene, name, host::name(job.precision)), double(seed - 1) / job.seeds);
            host::Technique& technique = host::techniqueByName(name);
            std::vector<std::string> given;
            for (const std::string& setting : job.settings)
                for (const host::SettingInfo& info : technique.info().settings)
                    if (setting.starts_with(info.key + "=")) given.push_back(setting);
            given.push_back(fmt::format("seed={}", seed));
            const host::Settings settings(technique.info().settings, given);
            const host::TechniqueResult out = technique.run(inputs, structures, settings, {job.precision, 1, true, false, seed == 1});
            Lists& list = lists[name];
            double build = 0, query = 0;
            for (const host::RecordPass& pass : out.passes) (host::isBuildPass(pass.name) ? build : query) += pass.ms;
            const double samples = double(std::max<uint64_t>(inputs.sampleCount(), 1));
            list.nodes.push_back(double(out.counters.visitedNodes) / samples);
            list.exact.push_back(double(out.counters.exactCalls) / samples);
            list.overflows.push_back(double(out.counters.stackOverflows));
            list.stack.push_back(double(out.counters.maxStack));
            list.build.push_back(build);
            list.query.push_back(query);
            for (const auto& [key, value] : out.counters.more)
                if (key == "build_steps") list.steps.push_back(double(value) / double(std::max<uint64_t>(inputs.casterCount(), 1)));
            if (job.check) list.wrong.push_back(double(countWrong(inputs, out.visibility, truth)));
            results[name].treeBytes = out.bytes.front().second;
        }
    }
    for (auto& [name, result] : results) {
        const Lists& list = lists[name];
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
        result.queryMsBySeed = list.query;
        result.buildMsBySeed = list.build;
    }
    progress.clear();
    return results;
}

}  // namespace gno::bench
