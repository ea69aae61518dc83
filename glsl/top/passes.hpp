// SPDX-License-Identifier: MIT
// gnomon top/passes.hpp : a TOP tree on the host's side: arrays, passes and barriers, defaults (glsl/MODULES.md tells the story). C++20, standard
// library only (node.h needs GLM in C++; this does not include it).
//
// Per light: one tree. Per frame: both build passes again when casters, their states or the light changed; nothing to reset.
#ifndef GNO_TOP_PASSES_HPP
#define GNO_TOP_PASSES_HPP
#include "../core/pass.hpp"

namespace gno {

struct TopOptions {
    std::uint32_t precision = 2;  ///< GNO_PRECISION_*; the same in build and query
    std::uint32_t seed = 1;       ///< of the random insertion order: GnoExamplePush::seed
    std::uint32_t groupSize = 64;
};

/// GNO_TOP_SET's arrays for `casters` casters.
inline ArrayList topArrays(std::uint64_t casters) {
    const std::uint64_t n = casters > 0 ? casters : 1;
    return {{"gnoTopPlanes", 1, 0, "vec4[4 casters]", 64 * n},
            {"gnoTopLinks", 1, 1, "GnoTopLink[4 casters]", 64 * n},
            {"gnoTopHeader", 1, 2, "GnoTopHeader", 16}};
}

/// The tree of all casters that are kept. You: casters and states (core/caster_state.glsl) visible before.
inline PassList topBuildPasses(std::uint32_t casters, const TopOptions& options) {
    const std::uint32_t groups = groupsFor(casters, options.groupSize);
    const Few<Constant, 8> constants{{"kPrecision", options.precision}, {"kGroupSize", options.groupSize}};
    return {{.shader = "top/examples/set_up.comp",
             .part = "top_setup",
             .before = kBeforeShaders,
             .groups = {groups, 1, 1},
             .constants = constants,
             .writes = {"gnoTopPlanes", "gnoTopLinks", "gnoTopHeader"}},
            {.shader = "top/examples/build.comp",
             .part = "top_build",
             .before = kBeforeShaders,
             .groups = {groups, 1, 1},
             .constants = constants,
             .writes = {"gnoTopLinks", "gnoTopHeader"}}};
}

enum class TopQuery : std::uint8_t { stack, stackless, hybrid };

struct TopQueryOptions {
    TopQuery query = TopQuery::hybrid;
    std::uint32_t precision = 2;
    std::uint32_t stack = 12;  ///< entries; of the published stack query 32; no meaning for stackless
    bool depthTest = true;     ///< D-PSV, D-Stackless, D-Hybrid; false: PSV
    bool fragment = false;
};

/// One answer per pixel of width x height view samples.
inline PassList topQueryPasses(std::uint32_t width, std::uint32_t height, const TopQueryOptions& options) {
    constexpr std::string_view shaders[3][2] = {{"top/examples/query_stack.comp", "top/examples/query_stack.frag"},
                                                {"top/examples/query_stackless.comp", "top/examples/query_stackless.frag"},
                                                {"top/examples/query_hybrid.comp", "top/examples/query_hybrid.frag"}};
    Pass pass{.shader = shaders[static_cast<int>(options.query)][options.fragment ? 1 : 0],
              .part = "top_query",
              .before = kBeforeShaders,
              .groups = {groupsFor(width, 8), groupsFor(height, 8), 1},
              .constants = {{"kPrecision", options.precision}, {"kDepthTest", options.depthTest ? 1u : 0u}},
              .writes = {"gnoVisibility"},
              .kind = options.fragment ? PassKind::fullscreen : PassKind::compute};
    if (options.query != TopQuery::stackless) pass.constants.push_back({"kStackSize", options.stack});
    return {pass};
}

}  // namespace gno
#endif
