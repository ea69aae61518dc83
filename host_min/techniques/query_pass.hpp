// SPDX-License-Identifier: MIT
// The pass that asks a structure for every view sample, behind core/examples/query_comp.glsl and query_frag.glsl, whatever the structure is.
#pragma once
#include <string>
#include <vector>

#include "host_min/techniques/technique.hpp"

namespace gno::host {

struct QueryPass {
    std::string shader;  ///< of the examples, without its ending: "top/examples/query_stack"
    Specialization constants;
    std::vector<Binding> resources;  ///< the structure's; the images of the frame are added
    std::string name;                ///< of the timed pass
    bool fragment = false;           ///< stage of the timed pass
};

/// Poisons and fills result.visibility, appends the timed pass, and with options.counters asks once more by the instrumented shader: per-pixel
/// counts and their totals (visited nodes, deepest stack, overflows, exact calls) go into `result`.
void ask(const FrameInputs& inputs, const QueryPass& query, const RunOptions& options, TechniqueResult& result);

}  // namespace gno::host
