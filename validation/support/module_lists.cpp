// SPDX-License-Identifier: MIT
#include "validation/support/module_lists.hpp"

#include <fstream>
#include <set>
#include <stdexcept>

#include "glsl/clusters/passes.hpp"
#include "glsl/core/passes.hpp"
#include "glsl/forest/passes.hpp"
#include "glsl/rivals/light_bvh_passes.hpp"
#include "glsl/rivals/light_grid_passes.hpp"
#include "glsl/rivals/ray_query_passes.hpp"
#include "glsl/shadow_map/passes.hpp"
#include "glsl/top/passes.hpp"

namespace gno::test {
namespace {

ModuleLists top(const std::string& technique, TopQueryOptions options, const std::string& file, const std::string& call) {
    return {technique,
            "top/passes.hpp",
            topArrays(kListCasters),
            topBuildPasses(kListCasters, {}),
            topQueryPasses(kListWidth, kListHeight, options),
            {"core/bindings.glsl", "top/bindings.glsl", "top/" + file},
            technique == "psv" ? std::vector<std::string>{"#define GNO_TOP_DEPTH_TEST 0"} : std::vector<std::string>{},
            call + "(s)",
            technique == "d-hybrid" ? "" : "d-hybrid"};
}

ModuleLists clusters(const std::string& technique, ClusterForm form, const std::string& formName) {
    const ClusterOptions options{.form = form};
    return {technique,
            "clusters/passes.hpp",
            clusterArrays(kListWidth, kListHeight, kListCasters, options),
            clusterBuildPasses(kListWidth, kListHeight, kListCasters, options),
            clusterQueryPasses(kListWidth, kListHeight, options),
            {"clusters/bindings.glsl", "clusters/merge.glsl"},
            {"#define GNO_CLUSTER_FORM " + formName},
            "gnoClusterInShadow(uvec2(gl_FragCoord.xy), s.position)"};
}

ModuleLists forest() {
    const LightCells cells{.casters = kListCasters, .width = kListWidth, .height = kListHeight};
    return {"forest",
            "forest/passes.hpp",
            forestArrays(cells, forestFirstPool(kListCasters), {}),
            forestBuildPasses(cells, {}),
            forestQueryPasses(kListWidth, kListHeight, {}, {}),
            {"core/bindings.glsl", "forest/bindings.glsl", "top/bindings.glsl", "top/query_hybrid.glsl"},
            {"#define GNO_FOREST_TREES 1"},
            "gnoTopQueryHybrid(s)"};
}

ModuleLists lightGrid() {
    const LightCells cells{.casters = kListCasters, .width = kListWidth, .height = kListHeight};
    const LightGridPools pools = lightGridFirstPools(kListCasters);
    return {"light-grid",
            "rivals/light_grid_passes.hpp",
            lightGridArrays(cells, pools, lightGridNests(cells, pools.pairs, 8, 128u << 20), {}),
            lightGridBuildPasses(cells, {}),
            lightGridQueryPasses(kListWidth, kListHeight, 2, {}, false),
            {"core/bindings.glsl", "forest/bindings.glsl", "rivals/light_grid_bindings.glsl", "rivals/light_grid_query.glsl"},
            {"#define GNO_FOREST_TREES 0", "#define GNO_LIGHT_GRID_PLANES 1"},
            "gnoLightGridQuery(s)"};
}

ModuleLists lightBvh() {
    const uint64_t pool = lightBvhFirstPool(kListCasters, false);
    return {"light-bvh",
            "rivals/light_bvh_passes.hpp",
            lightBvhArrays(kListCasters, pool),
            lightBvhBuildPasses(kListCasters, pool),
            lightBvhQueryPasses(kListWidth, kListHeight, {}),
            {"core/bindings.glsl", "rivals/light_bvh_bindings.glsl", "rivals/light_bvh_query.glsl"},
            {},
            "gnoLightBvhQuery(s)"};
}

ModuleLists shadowMap() {
    PassList build = shadowMapFitPasses(kListWidth, kListHeight);
    for (const Pass& pass : shadowMapBuildPasses(kListCasters, 6, {})) build.push_back(pass);
    return {"shadow-map",
            "shadow_map/passes.hpp",
            shadowMapArrays(6),
            build,
            shadowMapQueryPasses(kListWidth, kListHeight, false),
            {"shadow_map/bindings.glsl", "shadow_map/map_bindings.glsl", "shadow_map/query.glsl"},
            {},
            "gnoShadowMapQuery(s)"};
}

ModuleLists rayQuery() {
    return {"ray-query",
            "rivals/ray_query_passes.hpp",
            rayQueryArrays(kListCasters),
            rayQueryBuildPasses(kListCasters),
            rayQueryPasses(kListWidth, kListHeight, false),
            {"rivals/ray_query_bindings.glsl", "rivals/ray_query.glsl"},
            {},
            "gnoRayQueryInShadow(s)"};
}

/// Adds `file` and all that it includes, by paths relative to `glsl`.
void addWithIncludes(const std::filesystem::path& glsl, const std::string& file, std::set<std::string>& found) {
    if (!found.insert(file).second) return;
    std::ifstream stream(glsl / file);
    if (!stream) throw std::runtime_error("glsl/ has no file " + file);
    for (std::string line; std::getline(stream, line);) {
        const size_t first = line.find_first_not_of(' ');
        if (first == std::string::npos || line.compare(first, 9, "#include ") != 0) continue;
        const size_t open = line.find('"'), close = line.rfind('"');
        if (open == std::string::npos || close == open) continue;  // a system header
        const auto path = (std::filesystem::path(file).parent_path() / line.substr(open + 1, close - open - 1)).lexically_normal();
        addWithIncludes(glsl, path.generic_string(), found);
    }
}

}  // namespace

std::vector<ModuleLists> moduleLists() {
    return {top("d-hybrid", {}, "query_hybrid.glsl", "gnoTopQueryHybrid"),
            top("d-stackless", {.query = TopQuery::stackless}, "query_stackless.glsl", "gnoTopQueryStackless"),
            top("d-psv", {.query = TopQuery::stack, .stack = 32}, "query_stack.glsl", "gnoTopQueryStack"),
            top("psv", {.query = TopQuery::stack, .stack = 32, .depthTest = false}, "query_stack.glsl", "gnoTopQueryStack"),
            clusters("ptsv", ClusterForm::compact, "GNO_CLUSTER_COMPACT"),
            clusters("ptsv-2011", ClusterForm::flat, "GNO_CLUSTER_FLAT"),
            forest(),
            lightGrid(),
            lightBvh(),
            shadowMap(),
            rayQuery()};
}

std::vector<std::string> filesToCopy(const ModuleLists& lists, const std::filesystem::path& glsl) {
    std::set<std::string> found{"LICENSE"};
    addWithIncludes(glsl, lists.header, found);
    addWithIncludes(glsl, "core/passes.hpp", found);
    addWithIncludes(glsl, "core/grid.hpp", found);
    for (const std::string& file : lists.includes) addWithIncludes(glsl, file, found);
    for (const PassList& list : {casterStatePasses(kListCasters), viewSamplePasses(kListWidth, kListHeight), lists.build, lists.query})
        for (const Pass& pass : list) {
            if (pass.kind == PassKind::command) continue;
            addWithIncludes(glsl, std::string(pass.shader), found);
            if (pass.kind == PassKind::fullscreen) addWithIncludes(glsl, "core/examples/fullscreen.vert", found);
        }
    return {found.begin(), found.end()};
}

}  // namespace gno::test
