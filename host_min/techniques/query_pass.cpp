// SPDX-License-Identifier: MIT
#include "host_min/techniques/query_pass.hpp"

#include <algorithm>
#include <array>

#include "host_min/techniques/measure.hpp"

namespace gno::host {
namespace {

constexpr uint32_t kPoison = 0xDEADBEEFu;  // a shader that writes nothing must not look right

void record(Recording& recording, const FrameInputs& inputs, const QueryPass& query, const Image& visibility, const Image* counts) {
    const ExamplePush push = inputs.push();
    const auto bytes = std::as_bytes(std::span(&push, 1));
    std::vector<Binding> resources = query.resources;
    resources.insert(resources.end(), {{"gnoCasters", &inputs.casters()},
                                       {"gnoSamples", &inputs.samples()},
                                       {"gnoVisibility", &visibility},
                                       {"gnoCounts", counts ? counts : &inputs.samples()}});
    if (query.fragment && !counts) {
        const std::array formats{visibility.format()};
        const RasterPass& pass = inputs.passes().raster("core/examples/fullscreen.vert", query.shader + ".frag", formats, false, query.constants);
        const std::array targets{RasterPass::Target{&visibility, vk::ClearColorValue(kPoison, kPoison, kPoison, kPoison)}};
        pass.draw(recording, targets, nullptr, resources, bytes, 3);
    } else {
        const ComputePass& pass = inputs.passes().compute(query.shader + (counts ? ".comp.counters" : ".comp"), query.constants);
        pass.dispatch(recording, resources, bytes, (inputs.width() + 7) / 8, (inputs.height() + 7) / 8);
    }
}

void count(const FrameInputs& inputs, const QueryPass& query, const Image& visibility, TechniqueResult& result) {
    Image counts(inputs.device(), inputs.width(), inputs.height(), vk::Format::eR32G32B32A32Uint);
    counts.clear(vk::ClearColorValue(kPoison, kPoison, kPoison, kPoison));
    Recording recording(inputs.device());
    record(recording, inputs, query, visibility, &counts);
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

void ask(const FrameInputs& inputs, const QueryPass& query, const RunOptions& options, TechniqueResult& result) {
    Image visibility(inputs.device(), inputs.width(), inputs.height(), vk::Format::eR32Uint);
    visibility.clear(vk::ClearColorValue(kPoison, kPoison, kPoison, kPoison));
    if (options.counters) count(inputs, query, visibility, result);
    const auto times = measure(inputs.device(), options.repeat, options.warmUp, [&](Recording& recording) {
        recording.beginPass(query.name);
        record(recording, inputs, query, visibility, nullptr);
        recording.endPass();
    });
    result.passes.push_back({times.front().name, times.front().ms});
    result.visibility = visibility.downloadAs<uint32_t>();
}

}  // namespace gno::host
