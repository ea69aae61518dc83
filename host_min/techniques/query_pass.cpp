// SPDX-License-Identifier: MIT
#include "host_min/techniques/query_pass.hpp"

#include <algorithm>
#include <stdexcept>

#include "host_min/techniques/measure.hpp"

namespace gno::host {
namespace {

constexpr uint32_t kPoison = 0xDEADBEEFu;  // a shader that writes nothing must not look right

/// The same pass as compute: counts are stored to an image there.
Pass inCompute(Pass pass, const FrameInputs& inputs, std::string& name) {
    if (pass.kind == PassKind::compute) return pass;
    name = std::string(pass.shader.substr(0, pass.shader.rfind('.'))) + ".comp";
    pass.shader = name;
    pass.kind = PassKind::compute;
    pass.groups = {groupsFor(inputs.width(), 8), groupsFor(inputs.height(), 8), 1};
    return pass;
}

void count(const FrameInputs& inputs, const Query& query, std::vector<Binding> resources, TechniqueResult& result) {
    Image counts(inputs.device(), inputs.width(), inputs.height(), vk::Format::eR32G32B32A32Uint);
    counts.clear(vk::ClearColorValue(kPoison, kPoison, kPoison, kPoison));
    resources.push_back({"gnoCounts", &counts});
    PassList passes = query.passes;
    std::vector<std::string> names(passes.size());
    for (size_t i = 0; i < passes.size(); ++i) passes[i] = inCompute(passes[i], inputs, names[i]);
    const PassRunner runner(inputs.passes(), passes, resources, {.counters = true});
    Recording recording(inputs.device());
    runner.record(recording, inputs.push());
    recording.submit();
    RecordCounters& totals = result.counters;
    for (const glm::uvec4& pixel : counts.downloadAs<glm::uvec4>()) {
        result.visitedNodes.push_back(pixel.x);
        result.deepestStack.push_back(pixel.y);
        totals.visitedNodes += pixel.x;
        totals.maxStack = std::max<uint64_t>(totals.maxStack, pixel.y);
        totals.stackOverflows += pixel.z;
        totals.exactCalls += pixel.w;
    }
}

}  // namespace

void ask(const FrameInputs& inputs, const Query& query, const RunOptions& options, TechniqueResult& result) {
    Image visibility(inputs.device(), inputs.width(), inputs.height(), vk::Format::eR32Uint);
    visibility.clear(vk::ClearColorValue(kPoison, kPoison, kPoison, kPoison));
    std::vector<Binding> resources = inputs.withCasters(query.resources);
    resources.push_back({"gnoVisibility", &visibility});
    if (options.counters && query.countsPixels) count(inputs, query, resources, result);
    const PassRunner runner(inputs.passes(), query.passes, resources);
    const auto times =
        measure(inputs.device(), options.repeat, options.warmUp, [&](Recording& recording) { runner.record(recording, inputs.push()); });
    for (const PassTime& time : times) result.passes.push_back({time.name, time.ms});
    result.visibility = visibility.downloadAs<uint32_t>();
}

}  // namespace gno::host
