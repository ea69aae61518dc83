// SPDX-License-Identifier: MIT
#include "host_min/techniques/top_trace.hpp"

#include <fmt/format.h>

#include <array>

#include "host_min/error.hpp"

namespace gno::host {

std::vector<DumpedBuffer> traceTopQuery(const FrameInputs& inputs, const TopTree& tree, const std::string& shader, const Pass& asked,
                                        const TracedPixel& traced) {
    constexpr size_t kHeader = 4;  // words: pixel x, y, nodes logged, room for them
    Buffer visits(inputs.device(), std::max<uint64_t>(1, 4 * uint64_t(inputs.triangleCount())) * 4);
    visits.fill(0);
    std::vector<uint32_t> words(kHeader + 2 * size_t(traced.nodes));
    words[0] = traced.pixel.x;
    words[1] = traced.pixel.y;
    words[3] = traced.nodes;
    Buffer trace(inputs.device(), 4 * words.size());
    trace.upload(std::as_bytes(std::span(words)));
    Image visibility(inputs.device(), inputs.width(), inputs.height(), vk::Format::eR32Uint);
    visibility.clear(vk::ClearColorValue(0u, 0u, 0u, 0u));

    std::vector<Binding> resources = inputs.withCasters(tree.bindings());
    resources.insert(resources.end(), {{"gnoVisibility", &visibility}, {"gnoTopVisits", &visits}, {"gnoTopTrace", &trace}});
    const std::string path = fmt::format("top/examples/{}.comp", shader);
    Pass pass = asked;
    pass.shader = path;
    pass.kind = PassKind::compute;
    const PassRunner runner(inputs.passes(), {pass}, resources);  // its descriptor sets outlive the submission
    Recording recording(inputs.device());
    runner.record(recording, inputs.push());
    recording.submit();

    words = trace.downloadAs<uint32_t>();
    if (words[2] != traced.nodes) throw WorkError(fmt::format("the traced query visits {} nodes, the counted one {}", words[2], traced.nodes));
    std::vector<DumpedBuffer> result{{"visits", "uint[4 * casters]: how often the queries of the frame load the node", visits.download()}};
    if (traced.nodes > 0) {
        const auto bytes = std::as_bytes(std::span(words).subspan(kHeader, 2 * size_t(traced.nodes)));
        result.push_back(
            {"trace", "uvec2: node, GNO_TOP_TRACE_* (glsl/top/examples/trace.glsl), in the order of the visits", {bytes.begin(), bytes.end()}, 2});
    }
    return result;
}

}  // namespace gno::host
