// SPDX-License-Identifier: MIT
// Runs a query of a TOP tree that logs what it loads: how often the whole frame visits each node, and one pixel's way through the tree.
#pragma once
#include <limits>
#include <string>
#include <vector>

#include "host_min/techniques/technique.hpp"
#include "host_min/techniques/top_tree.hpp"

namespace gno::host {

struct TracedPixel {
    glm::uvec2 pixel{std::numeric_limits<uint32_t>::max()};  ///< default: none
    uint32_t nodes = 0;                                      ///< that its query visits
};

/// `shader` of glsl/top/examples, without its ending; `asked` the pass of the query that it logs. Returns "visits" (uint per node), and, when a
/// pixel is traced, "trace" (uvec2 node, GNO_TOP_TRACE_* of glsl/top/examples/trace.glsl). Throws WorkError when the query visits another number of
/// nodes than the instrumented one did.
std::vector<DumpedBuffer> traceTopQuery(const FrameInputs& inputs, const TopTree& tree, const std::string& shader, const Pass& asked,
                                        const TracedPixel& traced);

}  // namespace gno::host
