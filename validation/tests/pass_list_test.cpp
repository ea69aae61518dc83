// SPDX-License-Identifier: MIT
// The lists of glsl/*/passes.hpp against the compiled shaders: arrays, numbers, constants, what is written, what indirect dispatches read, barriers
// that are there at all. One row a list; the second half spoils a good row and expects the fault to be found.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "glsl/clusters/cluster.h"
#include "glsl/clusters/passes.hpp"
#include "glsl/core/passes.hpp"
#include "glsl/core/radix_sort.h"
#include "glsl/forest/cells.h"
#include "glsl/forest/passes.hpp"
#include "glsl/rivals/light_bvh.h"
#include "glsl/rivals/light_bvh_passes.hpp"
#include "glsl/rivals/light_grid.h"
#include "glsl/rivals/light_grid_passes.hpp"
#include "glsl/rivals/ray_query_passes.hpp"
#include "glsl/shadow_map/passes.hpp"
#include "glsl/shadow_map/view.h"
#include "glsl/top/node.h"
#include "glsl/top/passes.hpp"
#include "host_min/vulkan/shader.hpp"
#include "validation/support/module_lists.hpp"
#include "validation/support/shader_access.hpp"

namespace gno {
namespace {

/// Of an embedded shader: read once.
const std::map<std::string, test::Access>& accessesOf(std::span<const uint32_t> embedded) {
    static std::map<const uint32_t*, std::map<std::string, test::Access>> known;
    const auto [entry, isNew] = known.try_emplace(embedded.data());
    if (isNew) entry->second = test::accessesOf(embedded);
    return entry->second;
}

/// What a technique's host walks in a frame.
struct Row {
    std::string name;
    ArrayList arrays;
    PassList build;
    std::vector<PassList> queries;    ///< each may follow the build
    std::vector<std::string> more{};  ///< images and acceleration structures of its own, and what materials bring
    std::set<std::string> early{};    ///< arrays that shaders could read before anything is in them, but do not with these constants
};

std::vector<Row> rows() {
    constexpr uint32_t casters = 1000, width = 100, height = 30;
    std::vector<Row> rows;
    PassList core = casterStatePasses(casters);
    for (const Pass& pass : viewSamplePasses(width, height)) core.push_back(pass);
    rows.push_back({"core", {}, core, {}});

    Row& top = rows.emplace_back(Row{"top", topArrays(casters), topBuildPasses(casters, {}), {}});
    for (const TopQuery query : {TopQuery::stack, TopQuery::stackless, TopQuery::hybrid})
        for (const bool fragment : {false, true}) top.queries.push_back(topQueryPasses(width, height, {.query = query, .fragment = fragment}));

    for (const bool all : {true, false}) {
        const LightCells cells{.casters = casters, .width = width, .height = height, .resolution = 16, .viewCull = all, .cover = all};
        const ForestOptions options{.slab = !all, .storePlanes = all};
        Row& forest =
            rows.emplace_back(Row{all ? "forest" : "bare forest", forestArrays(cells, 3000, options), forestBuildPasses(cells, options), {}});
        for (const ForestQuery query : {ForestQuery::stack, ForestQuery::stackless, ForestQuery::hybrid})
            for (const bool fragment : {false, true})
                forest.queries.push_back(forestQueryPasses(width, height, options, {.query = query, .fragment = fragment}));
        const LightGridOptions lists{.nest = all ? 8u : 0u};
        rows.push_back({all ? "light_grid" : "bare light_grid",
                        lightGridArrays(cells, {3000, 5000}, all ? 300 : 0, lists),
                        lightGridBuildPasses(cells, lists),
                        {lightGridQueryPasses(width, height, 2, lists, false), lightGridQueryPasses(width, height, 2, lists, true)}});
    }

    Row& lightBvh = rows.emplace_back(Row{"light_bvh", lightBvhArrays(casters, 3000), lightBvhBuildPasses(casters, 3000), {}});
    for (const bool stackless : {false, true})
        for (const bool fragment : {false, true})
            lightBvh.queries.push_back(lightBvhQueryPasses(width, height, {.stackless = stackless, .fragment = fragment}));

    PassList map = shadowMapFitPasses(width, height);
    for (const Pass& pass : shadowMapBuildPasses(casters, kShadowMapMostViews, {})) map.push_back(pass);
    rows.push_back({"shadow_map",
                    shadowMapArrays(kShadowMapMostViews),
                    map,
                    {shadowMapQueryPasses(width, height, false), shadowMapQueryPasses(width, height, true)},
                    {"gnoShadowMap"}});
    rows.push_back({"ray_query",
                    rayQueryArrays(casters),
                    rayQueryBuildPasses(casters),
                    {rayQueryPasses(width, height, false), rayQueryPasses(width, height, true)},
                    {"gnoRayStructure"}});

    const std::pair<const char*, ClusterOptions> clusters[] = {{"clusters", {}},
                                                               {"clusters, implicit", {.form = ClusterForm::implicitBounds, .split = 0}},
                                                               {"clusters, explicit", {.form = ClusterForm::explicitBounds}},
                                                               {"clusters, flat", {.form = ClusterForm::flat}},
                                                               {"clusters, layers", {.layers = true}}};
    for (const auto& [name, options] : clusters)
        rows.push_back(
            {name,
             clusterArrays(width, height, casters, options),
             clusterBuildPasses(width, height, casters, options),
             {clusterQueryPasses(width, height, options)},
             options.layers ? std::vector<std::string>{"gnoMaterialOf", "gnoSurfaces", "gnoMaterials", "gnoTexels"} : std::vector<std::string>{},
             {"gnoClusterPointers"}});  // tiles.comp looks for a box with kWhat 2, behind allocate.comp, and in compact form only
    return rows;
}

/// What a frame brings, besides casterArrays: images, and the instrumented passes' own.
const std::set<std::string> kFrame{"gnoSamples", "gnoVisibility", "gnoCounts", "gnoTotals", "gnoPositions", "gnoPrimitives"};
const std::set<std::string> kCounting{"gnoCounts", "gnoTotals", "gnoSteps"};

class Checker {
public:
    explicit Checker(const Row& row) : row_(row), frame_(casterArrays(1000)) {}

    std::vector<std::string> faults() {
        checkArrays();
        walk(row_.build, true);
        const auto afterBuild = state_;
        for (const PassList& query : row_.queries) {
            state_ = afterBuild;
            walk(query, false);
        }
        for (const Array& array : row_.arrays)
            for (const Array& other : row_.arrays)
                if (array.name < other.name && array.set == other.set && array.binding == other.binding &&
                    byName_.contains(std::string(array.name)) && byName_.contains(std::string(other.name)))
                    fault("{} and {} have one number", array.name, other.name);
        for (const Array& array : row_.arrays) {
            if (!used_.contains(std::string(array.name))) fault("{}: no pass uses it", array.name);
            const bool isAsked = asked_.contains(std::string(array.name));
            if (!row_.queries.empty() && isAsked != (array.kept == Kept::forQuery))
                fault("{}: kept {}", array.name, isAsked ? "too short" : "too long");
        }
        return faults_;
    }

private:
    template <class... T>
    void fault(fmt::format_string<T...> text, T&&... values) {
        faults_.push_back(row_.name + ": " + fmt::format(text, std::forward<T>(values)...));
    }

    void checkArrays() {
        std::set<std::string_view> names;
        for (const Array& array : row_.arrays) {
            if (!names.insert(array.name).second) fault("{}: twice", array.name);
            if (array.bytes == 0) fault("{}: no bytes", array.name);
            if (array.element.empty()) fault("{}: nobody knows what lies in it", array.name);
        }
    }

    [[nodiscard]] const Array* array(std::string_view name) const {
        for (const ArrayList* list : {&row_.arrays, &frame_})
            for (const Array& array : *list)
                if (array.name == name) return &array;
        return nullptr;
    }
    [[nodiscard]] bool isOther(const std::string& name) const {
        return kFrame.contains(name) || std::find(row_.more.begin(), row_.more.end(), name) != row_.more.end();
    }

    void walk(const PassList& passes, bool isBuild) {
        for (size_t i = 0; i < passes.size(); ++i) {
            const Pass& pass = passes[i];
            if (i == 0 && pass.before == kBeforeNothing) fault("{}: the first pass waits for nothing", pass.shader);
            if (pass.part.empty()) fault("{}: no part", pass.shader);
            if (pass.before != kBeforeNothing) state_.unseen.clear();
            if (pass.before & kBeforeIndirect) {
                if ((pass.before & kBeforeShaders) == 0) fault("{}: kBeforeIndirect without kBeforeShaders", pass.shader);
                state_.unreadable.clear();
            }
            if (pass.kind == PassKind::command) {
                for (const std::string_view name : pass.writes) state_.unseen.insert(std::string(name));
                for (const Array& array : row_.arrays)
                    if (array.usage & kUsageRayInput) used_.insert(std::string(array.name));
                continue;
            }
            checkGroups(pass);
            checkShader(pass, std::string(pass.shader), isBuild);
        }
    }

    void checkGroups(const Pass& pass) {
        if (pass.indirect.empty()) {
            const uint32_t most = pass.kind == PassKind::compute ? 65535 : 0xFFFFFFFFu;
            for (const uint32_t groups : pass.groups)
                if (groups == 0 || groups > most) fault("{}: {} groups", pass.shader, groups);
            return;
        }
        const Array* counts = array(pass.indirect);
        if (!counts) return fault("{}: no array {}", pass.shader, pass.indirect);
        used_.insert(std::string(pass.indirect));
        if ((counts->usage & kUsageIndirect) == 0) fault("{}: {} is not for indirect dispatches", pass.shader, pass.indirect);
        if (pass.indirectOffset % 4 != 0 || pass.indirectOffset + 12 > counts->bytes) fault("{}: offset {}", pass.shader, pass.indirectOffset);
        if (state_.unreadable.contains(std::string(pass.indirect))) fault("{}: its group counts wait for kBeforeIndirect", pass.shader);
    }

    void checkShader(const Pass& pass, const std::string& shader, bool isBuild) {
        std::span<const uint32_t> spirv, counting;
        try {
            spirv = host::embeddedShader(shader);
            counting = host::embeddedShader(shader + ".counters");
        } catch (const std::logic_error&) {
            return fault("{}: no such shader", shader);
        }
        checkConstants(pass, spirv);
        const auto& bindings = accessesOf(spirv);
        std::set<std::string> written, stored;
        std::map<std::string, std::string> names;  // in the shader -> array
        for (const auto& [name, access] : bindings) names[name] = name;
        for (const Renamed& other : pass.renamed) {
            if (!bindings.contains(std::string(other.inShader))) fault("{}: renames {}, which it does not bind", shader, other.inShader);
            names[std::string(other.inShader)] = std::string(other.array);
        }
        for (const auto& [name, access] : bindings) {
            checkBinding(pass, name, names[name], access);
            if (access.writes()) stored.insert(name);
        }
        for (const std::string_view name : pass.writes) written.insert(std::string(name));
        // what a graphics pass draws is no binding of its shader
        if (pass.kind == PassKind::fullscreen && written.erase("gnoVisibility") == 0)
            fault("{}: it does not say that it draws gnoVisibility", shader);
        if (pass.kind == PassKind::depth && written.empty()) return fault("{}: it does not say what it draws", shader);
        if (pass.kind == PassKind::depth) written.erase(written.begin());
        if (written != stored) fault("{}: says that it writes {}, and writes {}", shader, written, stored);
        for (const auto& [name, access] : accessesOf(counting)) {
            if (kCounting.contains(name)) continue;
            if (!bindings.contains(name)) fault("{}: binds {} when it counts", shader, name);
            if (access.writes() && !stored.contains(name)) fault("{}: writes {} when it counts", shader, name);
        }
        for (const auto& [name, access] : bindings) {
            if (!access.reads && !access.writes()) continue;
            const std::string& to = names[name];
            (isBuild ? used_ : asked_).insert(to);
            if (!isBuild) used_.insert(to);
            const Array* const known = array(to);
            const bool isNew = state_.begun.insert(to).second;
            if (isNew && known && known->first == First::anything && row_.name != "core" && isOwn(to) && !access.stores && !row_.early.contains(to))
                fault("{}: reads {} before anything is in it", shader, to);
            if (state_.unseen.contains(to)) fault("{}: {} was written and no barrier stands between", shader, to);
        }
        for (const auto& [name, access] : bindings)
            if (access.writes()) {
                state_.unseen.insert(names[name]);
                state_.unreadable.insert(names[name]);
            }
    }

    [[nodiscard]] bool isOwn(std::string_view name) const {
        return std::any_of(row_.arrays.begin(), row_.arrays.end(), [&](const Array& array) { return array.name == name; });
    }

    void checkBinding(const Pass& pass, const std::string& name, const std::string& to, const test::Access& access) {
        const Array* const known = array(to);
        if (!known) {
            if (!isOther(to)) fault("{}: nobody has {}", pass.shader, to);
        } else {
            if (name == to) byName_.insert(name);
            if (name == to && (known->set != access.set || known->binding != access.binding))
                fault("{}: {} is {}.{}, the list says {}.{}", pass.shader, name, access.set, access.binding, known->set, known->binding);
            if (access.isStorageBuffer && (known->usage & kUsageStorage) == 0) fault("{}: {} is no storage buffer", pass.shader, to);
            if (access.isUniformBuffer && (known->usage & kUsageUniform) == 0) fault("{}: {} is no uniform buffer", pass.shader, to);
        }
        const bool isWritten = std::find(pass.writes.begin(), pass.writes.end(), name) != pass.writes.end();
        if (isWritten && access.isNonWritable) fault("{}: {} is to be written and NonWritable", pass.shader, name);
        if (!isWritten && !access.isNonWritable) fault("{}: {} could be written", pass.shader, name);
    }

    void checkConstants(const Pass& pass, std::span<const uint32_t> spirv) {
        std::set<std::string> there, given;
        for (const auto& [id, name] : host::reflect(spirv).specialization) there.insert(name);
        for (const Constant& constant : pass.constants) given.insert(std::string(constant.name));
        if (there != given) fault("{}: has the constants {}, the list gives {}", pass.shader, there, given);
    }

    struct State {
        std::set<std::string> begun;       ///< somebody has touched them
        std::set<std::string> unseen;      ///< written since the last barrier
        std::set<std::string> unreadable;  ///< written since the last kBeforeIndirect
    };
    const Row& row_;
    ArrayList frame_;
    State state_;
    std::set<std::string> used_, asked_;
    std::set<std::string> byName_;  ///< bound without being renamed
    std::vector<std::string> faults_;
};

TEST(PassList, AgreesWithTheShaders) {
    for (const Row& row : rows())
        for (const std::string& fault : Checker(row).faults()) ADD_FAILURE() << fault;
}

/// What glsl/MODULES.md tells is held here, too.
TEST(PassList, KnowsEveryTechniquesShaders) {
    std::set<std::string_view> known;
    const std::vector<Row> all = rows();
    for (const Row& row : all) {
        for (const Pass& pass : row.build) known.insert(pass.shader);
        for (const PassList& query : row.queries)
            for (const Pass& pass : query) known.insert(pass.shader);
    }
    for (const test::ModuleLists& lists : test::moduleLists())
        for (const PassList& passes : {lists.build, lists.query})
            for (const Pass& pass : passes) EXPECT_TRUE(known.contains(pass.shader)) << lists.technique << ": no row has " << pass.shader;
}

/// No list is so long that it would need other numbers: groups of many casters, none at all.
TEST(PassList, AnyNumberOfCasters) {
    for (const uint32_t casters : {0u, 1u, 63u, 64u, 65u, 4000000u})
        for (const PassList& passes : {topBuildPasses(casters, {}), lightBvhBuildPasses(casters, casters), rayQueryBuildPasses(casters),
                                       forestBuildPasses({.casters = casters, .resolution = 256}, {}),
                                       lightGridBuildPasses({.casters = casters, .resolution = 256}, {}), clusterBuildPasses(64, 64, casters, {})})
            for (const Pass& pass : passes)
                for (const uint32_t groups : pass.groups) EXPECT_TRUE(groups >= 1 && groups <= 65535) << pass.shader << " " << casters;
}

TEST(PassList, SizesAreThoseOfTheHeaders) {
    const ArrayList top = topArrays(7), bvh = lightBvhArrays(1000, 3000), map = shadowMapArrays(7);
    EXPECT_EQ(arrayNamed(top, "gnoTopHeader").bytes, sizeof(GnoTopHeader));
    EXPECT_EQ(arrayNamed(clusterArrays(64, 64, 7, {}), "gnoClusterHeader").bytes, sizeof(GnoClusterHeader));
    EXPECT_EQ(arrayNamed(clusterArrays(64, 64, 7, {}), "gnoClusterFrame").bytes, sizeof(GnoClusterFrame) + sizeof(GnoClusterLayout));
    EXPECT_EQ(offsetof(GnoClusterHeader, groups), kClusterGroupsAt);
    EXPECT_EQ(arrayNamed(top, "gnoTopLinks").bytes, 4 * 7 * sizeof(GnoTopLink));
    EXPECT_EQ(arrayNamed(bvh, "gnoLightBvhHeader").bytes, sizeof(GnoLightBvhHeader));
    EXPECT_EQ(arrayNamed(bvh, "gnoLightBvhLevels").bytes, GNO_LIGHT_BVH_LEVELS * sizeof(GnoLightBvhLevel));
    EXPECT_EQ(arrayNamed(bvh, "gnoLightBvhSums").bytes, 4 * gnoLightBvhGroups(1000));
    EXPECT_EQ(offsetof(GnoLightBvhHeader, references), kLightBvhReferencesAt);
    for (const uint32_t pool : {0u, 1u, 2u, 3u, 4u, 5u, 1023u, 1024u, 1025u, 100001u, 2097152u}) {
        const auto held = uint32_t(lightBvhCapacity(pool));
        EXPECT_TRUE(held >= pool && held > 0 && held % 4 == 0 && held < pool + 5) << pool;
        EXPECT_EQ(lightBvhNodes(held), gnoLightBvhNodes(held)) << pool;
        EXPECT_EQ(lightBvhBoxes(held), gnoLightBvhBoxes(held)) << pool;
        EXPECT_EQ(lightBvhNextRow(pool), gnoLightBvhNextRow(pool)) << pool;
        EXPECT_EQ(lightBvhSortCounts(held), gnoSortCounts(held)) << pool;
        uint32_t rows = 0, levels = 0, rounds = 0;
        for (const Pass& pass : lightBvhBuildPasses(1000, pool)) {
            rows += pass.shader.ends_with("_up.comp");
            levels += pass.shader.ends_with("_collapse.comp");
            rounds += pass.shader.ends_with("_scatter.comp");
        }
        uint32_t want = 0;
        for (uint32_t boxes = held; boxes > 1; ++want) boxes = gnoLightBvhNextRow(boxes);
        EXPECT_EQ(rows, want) << pool;
        EXPECT_EQ(levels, GNO_LIGHT_BVH_LEVELS);
        EXPECT_EQ(rounds, GNO_SORT_ROUNDS);
    }
    EXPECT_EQ(arrayNamed(map, "gnoShadowMapViews").bytes, sizeof(GnoShadowMapHeader) + 7 * sizeof(GnoShadowMapView));
    EXPECT_EQ(lightBvhMostReferences(128 << 20), (128u << 20) / sizeof(GnoLightBvhNode));
}

TEST(PassList, CellsAreThoseOfTheHeaders) {
    static_assert(sizeof(ForestGrid) == sizeof(GnoForestGrid) && offsetof(ForestGrid, along) == offsetof(GnoForestGrid, along));
    static_assert(offsetof(ForestGrid, stepAcross) == offsetof(GnoForestGrid, stepAcross));
    static_assert(offsetof(ForestGrid, stepAlong) == offsetof(GnoForestGrid, stepAlong));
    static_assert(offsetof(ForestGrid, resolution) == offsetof(GnoForestGrid, resolution));
    static_assert(offsetof(ForestGrid, faces) == offsetof(GnoForestGrid, faces));
    static_assert(kForestGroup == GNO_FOREST_GROUP && kForestGroup == GNO_LIGHT_GRID_GROUP);
    for (const uint32_t faces : {1u, 6u}) {
        const LightCells cells{.casters = 7, .resolution = 4, .faces = faces};
        EXPECT_EQ(cells.count(), gnoCellCount(4, faces));
        const ArrayList forest = forestArrays(cells, 10, {.slab = true}), lists = lightGridArrays(cells, {10, 20}, 3, {});
        EXPECT_EQ(arrayNamed(forest, "gnoForestGrid").bytes, sizeof(GnoForestGrid));
        EXPECT_EQ(arrayNamed(forest, "gnoForestHeader").bytes, sizeof(GnoForestHeader));
        EXPECT_EQ(arrayNamed(forest, "gnoForestCells").bytes, cells.count() * sizeof(GnoForestCell));
        EXPECT_EQ(arrayNamed(forest, "gnoForestFew").bytes, 7 * sizeof(GnoForestFew));
        EXPECT_EQ(arrayNamed(forest, "gnoForestPairs").bytes, 10 * sizeof(GnoForestPair));
        EXPECT_EQ(arrayNamed(forest, "gnoTopHeader").bytes, sizeof(GnoTopHeader));
        EXPECT_EQ(arrayNamed(forest, "gnoTopLinks").bytes, topLinkBytes(10));
        EXPECT_EQ(arrayNamed(forest, "gnoTopPlanes").bytes, topPlaneBytes(10));
        EXPECT_EQ(arrayNamed(forest, "gnoTopSlabs").bytes, topSlabBytes(10));
        EXPECT_EQ(arrayNamed(lists, "gnoGridHeader").bytes, sizeof(GnoLightGridHeader));
        EXPECT_EQ(arrayNamed(lists, "gnoGridLists").bytes, gnoLightGridLists(cells.count(), 3) * sizeof(GnoLightGridList));
        EXPECT_EQ(arrayNamed(lists, "gnoGridItems").bytes, 20 * sizeof(GnoLightGridItem));
        EXPECT_EQ(arrayNamed(lists, "gnoGridDepths").bytes, 4 * 64 * 3u);
    }
    const LightCells cells{.resolution = 4};
    std::set<std::pair<std::string_view, uint32_t>> groups;
    for (const PassList& passes : {forestBuildPasses(cells, {}), lightGridBuildPasses(cells, {})})
        for (const Pass& pass : passes)
            if (!pass.indirect.empty()) groups.insert({pass.shader.substr(pass.shader.rfind('/') + 1), pass.indirectOffset});
    const decltype(groups) want{{"assign_many.comp", uint32_t(offsetof(GnoForestHeader, groupsOfMany))},
                                {"assign_some.comp", uint32_t(offsetof(GnoForestHeader, groupsOfSome))},
                                {"set_up.comp", uint32_t(offsetof(GnoForestHeader, groupsOfPairs))},
                                {"build.comp", uint32_t(offsetof(GnoForestHeader, groupsOfPairs))},
                                {"light_grid_pairs.comp", uint32_t(offsetof(GnoLightGridHeader, groupsOfPairs))},
                                {"light_grid_allocate.comp", uint32_t(offsetof(GnoLightGridHeader, groupsOfLists))},
                                {"light_grid_sort.comp", uint32_t(offsetof(GnoLightGridHeader, groupsOfLists))}};
    EXPECT_EQ(groups, want);
    for (const uint64_t pairs : {0u, 1u, 2u, 3u, 999u, 1000u}) {
        EXPECT_TRUE(forestPool(pairs) >= std::max<uint64_t>(pairs, 1) && forestPool(pairs) % 2 == 0 && forestPool(pairs) < pairs + 3) << pairs;
        EXPECT_GE(forestPoolFor(pairs), pairs + pairs / 4);
    }
    EXPECT_EQ(forestMostPairs(1u << 27), (1u << 27) / 64);
    EXPECT_EQ(forestMostPairs(1u << 31), 65535u * 64);
}

Row named(const std::string& name) {
    for (Row& row : rows())
        if (row.name == name) return row;
    throw std::out_of_range(name);
}

Pass& pass(PassList& passes, std::string_view end, size_t nth = 0) {
    for (Pass& pass : passes)
        if (pass.shader.ends_with(end) && nth-- == 0) return pass;
    throw std::out_of_range(std::string(end));
}

Array& array(Row& row, std::string_view name) {
    for (Array& array : row.arrays)
        if (array.name == name) return array;
    throw std::out_of_range(std::string(name));
}

/// The checker finds each of these, and finds nothing in the row as it is.
TEST(PassList, TheCheckerSees) {
    struct Spoiled {
        std::string row, want;  ///< a part of the fault
        std::function<void(Row&)> spoil;
    };
    const std::vector<Spoiled> cases{
        {"top", "no such shader", [](Row& r) { r.build[0].shader = "top/examples/set_down.comp"; }},
        {"top", "no part", [](Row& r) { r.build[1].part = ""; }},
        {"top", "waits for nothing", [](Row& r) { r.build[0].before = kBeforeNothing; }},
        {"top", "no barrier stands between", [](Row& r) { r.build[1].before = kBeforeNothing; }},
        {"top", "0 groups", [](Row& r) { r.build[0].groups[1] = 0; }},
        {"top", "65536 groups", [](Row& r) { r.build[0].groups[0] = 65536; }},
        {"top", "nobody has gnoTopHeader", [](Row& r) { r.arrays.pop_back(); }},
        {"top", "gnoTopPlanes: twice", [](Row& r) { r.arrays.push_back(r.arrays[0]); }},
        {"top", "gnoTopLinks is 1.1, the list says 1.7", [](Row& r) { array(r, "gnoTopLinks").binding = 7; }},
        {"top", "gnoTopHeader and gnoTopLinks have one number", [](Row& r) { array(r, "gnoTopHeader").binding = 1; }},
        {"top", "gnoTopLinks: no bytes", [](Row& r) { array(r, "gnoTopLinks").bytes = 0; }},
        {"top", "gnoTopLinks is no storage buffer", [](Row& r) { array(r, "gnoTopLinks").usage = kUsageUniform; }},
        {"top", "gnoTopLinks: kept too short", [](Row& r) { array(r, "gnoTopLinks").kept = Kept::forBuild; }},
        {"top", "the list gives",
         [](Row& r) {
             r.build[0].constants.push_back({"kNothing", 1});
         }},
        {"top", "has the constants",
         [](Row& r) {
             r.build[0].constants = {{"kPrecision", 2}};
         }},
        {"top", "says that it writes",
         [](Row& r) {
             r.build[0].writes = {"gnoTopPlanes", "gnoTopHeader"};
         }},
        {"top", "says that it writes", [](Row& r) { r.build[1].writes.push_back("gnoTopPlanes"); }},
        {"top", "gnoCasters is to be written and NonWritable", [](Row& r) { r.build[0].writes.push_back("gnoCasters"); }},
        {"top", "draws gnoVisibility", [](Row& r) { r.queries[1][0].writes = {}; }},
        {"top", "no pass uses it",
         [](Row& r) {
             r.arrays.push_back({"gnoNothing", 1, 9, "uint", 4});
         }},
        {"light_bvh", "no array gnoNothing", [](Row& r) { pass(r.build, "_leaves.comp").indirect = "gnoNothing"; }},
        {"light_bvh", "not for indirect dispatches", [](Row& r) { array(r, "gnoLightBvhLevels").usage = kUsageStorage; }},
        {"light_bvh", "offset 18", [](Row& r) { pass(r.build, "_leaves.comp").indirectOffset = 18; }},
        {"light_bvh", "offset 1120", [](Row& r) { pass(r.build, "_collapse.comp").indirectOffset = 1120; }},
        {"light_bvh", "wait for kBeforeIndirect", [](Row& r) { pass(r.build, "_collapse.comp", 3).before = kBeforeShaders; }},
        {"light_bvh", "kBeforeIndirect without kBeforeShaders", [](Row& r) { pass(r.build, "_collapse.comp", 3).before = kBeforeIndirect; }},
        {"light_bvh", "kept too long", [](Row& r) { array(r, "gnoLightBvhMasks").kept = Kept::forQuery; }},
        {"light_bvh", "no uniform buffer", [](Row& r) { array(r, "gnoLightBvhGrid").usage = kUsageStorage; }},
        {"light_bvh", "renames gnoNothing",
         [](Row& r) {
             pass(r.build, "_leaves.comp").renamed = {{"gnoNothing", "gnoLightBvhMasks"}};
         }},
        {"light_bvh", "nobody has gnoNothing",
         [](Row& r) {
             pass(r.build, "_leaves.comp").renamed = {{"gnoLightBvhOrder", "gnoNothing"}};
         }},
        {"light_bvh", "reads gnoSortedKeys before",
         [](Row& r) {
             pass(r.build, "_sort_count.comp").renamed = {{"gnoLightBvhKeys", "gnoSortedKeys"}};
         }},
        {"forest", "wait for kBeforeIndirect", [](Row& r) { pass(r.build, "set_up.comp").before = kBeforeShaders; }},
        {"forest", "no barrier stands between", [](Row& r) { pass(r.build, "assign_few.comp").before = kBeforeNothing; }},
        {"forest", "gnoTopHeader: kept too short", [](Row& r) { array(r, "gnoTopHeader").kept = Kept::forBuild; }},
        {"light_grid", "wait for kBeforeIndirect", [](Row& r) { pass(r.build, "_sort.comp").before = kBeforeShaders; }},
        {"light_grid", "has the constants", [](Row& r) { pass(r.build, "_open.comp").constants = {}; }},
        {"clusters", "reads gnoClusterMasks before", [](Row& r) { r.build.erase(r.build.begin()); }},
        {"clusters", "reads gnoClusterPointers before", [](Row& r) { r.early = {}; }},
        {"clusters", "no barrier stands between", [](Row& r) { pass(r.build, "up.comp").before = kBeforeNothing; }},
        {"clusters", "no barrier stands between", [](Row& r) { pass(r.build, "volumes.comp").before = kBeforeNothing; }},
        {"clusters", "wait for kBeforeIndirect", [](Row& r) { r.build.back().before = kBeforeShaders; }},
        {"clusters", "kept too short", [](Row& r) { array(r, "gnoClusterShade").kept = Kept::forBuild; }},
        {"clusters", "kept too long", [](Row& r) { array(r, "gnoClusterVolumes").kept = Kept::forQuery; }},
        {"clusters, layers", "reads gnoTransmittances before",
         [](Row& r) { std::erase_if(r.build, [](const Pass& p) { return p.shader.ends_with("clear_sums.comp"); }); }},
        {"clusters, layers", "nobody has gnoTexels", [](Row& r) { r.more.pop_back(); }},
        {"shadow_map", "nobody has gnoShadowMap", [](Row& r) { r.more = {}; }},
        {"shadow_map", "does not say what it draws", [](Row& r) { pass(r.build, "depth.vert").writes = {}; }},
        {"shadow_map", "reads gnoShadowMapBounds before", [](Row& r) { r.build.erase(r.build.begin()); }},
    };
    for (const Spoiled& spoiled : cases) {
        Row row = named(spoiled.row);
        ASSERT_EQ(Checker(row).faults(), std::vector<std::string>{}) << row.name;
        spoiled.spoil(row);
        const auto faults = Checker(row).faults();
        EXPECT_TRUE(
            std::any_of(faults.begin(), faults.end(), [&](const std::string& fault) { return fault.find(spoiled.want) != std::string::npos; }))
            << spoiled.row << ": \"" << spoiled.want << "\" is not among " << fmt::format("{}", faults);
    }
}

}  // namespace
}  // namespace gno
