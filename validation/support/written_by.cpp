// SPDX-License-Identifier: MIT
#include <map>
#include <stdexcept>

#include "glsl/clusters/passes.hpp"
#include "glsl/core/passes.hpp"
#include "validation/support/module_lists.hpp"
#include "validation/support/shader_rights.hpp"

namespace gno::test {
namespace {

using Names = std::set<std::string>;

/// What all passes of all lists write, by shader. An attachment is no storage, and needs no right.
std::map<std::string, Names, std::less<>> writtenInLists() {
    std::map<std::string, Names, std::less<>> written;
    const auto add = [&](const PassList& list) {
        for (const Pass& pass : list) {
            if (pass.kind == PassKind::command) continue;
            Names& names = written[std::string(pass.shader)];
            if (pass.kind == PassKind::compute) names.insert(pass.writes.begin(), pass.writes.end());
        }
    };
    for (const ModuleLists& lists : moduleLists()) {
        add(lists.build);
        add(lists.query);
    }
    add(casterStatePasses(kListCasters));
    add(viewSamplePasses(kListWidth, kListHeight));
    const ClusterOptions layers{.layers = true};
    add(clusterBuildPasses(kListWidth, kListHeight, kListCasters, layers));
    add(clusterQueryPasses(kListWidth, kListHeight, layers));
    return written;
}

/// Shaders that no list of module_lists.hpp has: tools, and queries behind other options.
const std::map<std::string, Names, std::less<>> kUnlisted{
    {"core/examples/floor.comp", {"gnoVisibility"}},
    {"core/examples/orient3d.comp", {"Answers"}},
    {"core/examples/view_samples_from_depth.comp", {"gnoSamples"}},
    {"forest/examples/query_stack.comp", {"gnoVisibility"}},
    {"forest/examples/query_stackless.comp", {"gnoVisibility"}},
    {"rivals/examples/light_bvh_query_stackless.comp", {"gnoVisibility"}},
    {"rivals/examples/light_grid_query.comp", {"gnoVisibility"}},
    {"top/examples/trace_hybrid.comp", {"gnoTopTrace", "gnoTopVisits", "gnoVisibility"}},
    {"top/examples/trace_stack.comp", {"gnoTopTrace", "gnoTopVisits", "gnoVisibility"}},
    {"top/examples/trace_stackless.comp", {"gnoTopTrace", "gnoTopVisits", "gnoVisibility"}},
};

// What the instrumented variant of a shader writes more.
Names countersOf(std::string_view shader) {
    if (shader.ends_with("/build.comp")) return {"gnoTotals"};
    if (shader.find("/traverse") != std::string_view::npos) return {"gnoCounts", "gnoSteps", "gnoTotals"};
    const bool asks = shader.find("query") != std::string_view::npos || shader.find("/trace_") != std::string_view::npos;
    if (shader.ends_with(".comp") && (asks || shader == "core/examples/floor.comp")) return {"gnoCounts"};
    return {};
}

}  // namespace

Names writtenBy(std::string_view shader) {
    constexpr std::string_view kCounters = ".counters";
    const bool counts = shader.ends_with(kCounters);
    if (counts) shader.remove_suffix(kCounters.size());
    static const auto lists = writtenInLists();
    const auto listed = lists.find(shader), unlisted = kUnlisted.find(shader);
    if (listed != lists.end() && unlisted != kUnlisted.end()) throw std::logic_error(std::string(shader) + " stands in a list now");
    Names names;
    if (listed != lists.end()) names = listed->second;
    if (unlisted != kUnlisted.end()) names = unlisted->second;
    if (counts) names.merge(countersOf(shader));
    return names;
}

}  // namespace gno::test
