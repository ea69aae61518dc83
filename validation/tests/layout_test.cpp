// SPDX-License-Identifier: MIT
// One definition for C++ and GLSL: offsets, strides and sizes of the structs that both read, as C++ has them and as the compiled SPIR-V has them.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstring>
#include <optional>
#include <spirv_cross/spirv_cross.hpp>

#include "glsl/clusters/cluster.h"
#include "glsl/clusters/passes.hpp"
#include "glsl/core/pass.hpp"
#include "glsl/forest/cells.h"
#include "glsl/rivals/light_bvh.h"
#include "glsl/rivals/light_grid.h"
#include "glsl/shadow_map/view.h"
#include "glsl/top/node.h"
#include "host_min/frame/inputs.hpp"
#include "host_min/vulkan/shader.hpp"

namespace gno {
namespace {

struct Member {
    std::string name;
    size_t offset;
};

/// What SPIR-V says of a struct: members, and its bytes without padding at the end.
struct Layout {
    std::vector<Member> members;
    size_t bytes = 0;
};

class Reflection {
public:
    explicit Reflection(const std::string& shader)
        : compiler_([&] {
              const auto spirv = host::embeddedShader(shader);
              return spirv_cross::Compiler(spirv.data(), spirv.size());
          }()) {}

    [[nodiscard]] Layout layout(spirv_cross::TypeID id) const {
        const spirv_cross::SPIRType& type = compiler_.get_type(id);
        Layout result;
        for (uint32_t i = 0; i < type.member_types.size(); ++i)
            result.members.push_back({compiler_.get_member_name(type.self, i), compiler_.type_struct_member_offset(type, i)});
        result.bytes = compiler_.get_declared_struct_size(type);
        return result;
    }

    /// The whole block of the buffer of this name.
    [[nodiscard]] Layout whole(const std::string& buffer) const { return layout(block(buffer).self); }
    [[nodiscard]] Layout member(const std::string& buffer, uint32_t index) const {
        return layout(compiler_.get_type(block(buffer).member_types[index]).self);
    }
    /// Type of the first member of the storage buffer of this name (instance or block), e.g. of the array `v`.
    [[nodiscard]] const spirv_cross::SPIRType& contents(const std::string& buffer) const {
        return compiler_.get_type(block(buffer).member_types[0]);
    }
    [[nodiscard]] uint32_t stride(const std::string& buffer) const { return compiler_.type_struct_member_array_stride(block(buffer), 0); }
    [[nodiscard]] std::optional<Layout> pushBlock() const {
        const auto blocks = compiler_.get_shader_resources().push_constant_buffers;
        if (blocks.empty()) return std::nullopt;
        return layout(blocks.front().base_type_id);
    }

private:
    [[nodiscard]] const spirv_cross::SPIRType& block(const std::string& buffer) const {
        const spirv_cross::ShaderResources all = compiler_.get_shader_resources();
        for (const auto& kind : {all.storage_buffers, all.uniform_buffers})
            for (const spirv_cross::Resource& resource : kind)
                if (compiler_.get_name(resource.id) == buffer || resource.name == buffer) return compiler_.get_type(resource.base_type_id);
        throw std::runtime_error("no buffer " + buffer);
    }
    spirv_cross::Compiler compiler_;
};

/// Empty when SPIR-V and C++ agree.
std::string difference(const Layout& got, const std::vector<Member>& want, size_t bytes) {
    if (got.members.size() != want.size()) return "different numbers of members";
    for (size_t i = 0; i < want.size(); ++i)
        if (got.members[i].name != want[i].name || got.members[i].offset != want[i].offset)
            return "SPIR-V has " + got.members[i].name + " at " + std::to_string(got.members[i].offset) + ", C++ has " + want[i].name + " at " +
                   std::to_string(want[i].offset);
    return got.bytes == bytes ? "" : "SPIR-V has " + std::to_string(got.bytes) + " bytes, C++ " + std::to_string(bytes);
}

void expectSame(const Layout& got, const std::vector<Member>& want, size_t bytes) { EXPECT_EQ(difference(got, want, bytes), ""); }

#define MEMBER(type, member) \
    Member { #member, offsetof(type, member) }

const char* const kTreeShaders[] = {"top/examples/set_up.comp",      "top/examples/build.comp",        "top/examples/build.comp.counters",
                                    "top/examples/query_stack.comp", "top/examples/query_hybrid.comp", "top/examples/query_stackless.frag"};

TEST(Layout, LinksAndPlanesOfATopTree) {
    const std::vector<Member> link{MEMBER(GnoTopLink, positiveChild), MEMBER(GnoTopLink, intersectionChild), MEMBER(GnoTopLink, aux),
                                   MEMBER(GnoTopLink, wedge)};
    for (const std::string shader : kTreeShaders) {
        SCOPED_TRACE(shader);
        const Reflection reflection(shader);
        expectSame(reflection.layout(reflection.contents("gnoTopLinks").self), link, sizeof(GnoTopLink));
        EXPECT_EQ(reflection.stride("gnoTopLinks"), sizeof(GnoTopLink));
        EXPECT_EQ(reflection.stride("gnoTopLinks"), 16u);
        const spirv_cross::SPIRType& plane = reflection.contents("gnoTopPlanes");
        EXPECT_EQ(plane.basetype, spirv_cross::SPIRType::Float);
        EXPECT_EQ(plane.vecsize, 4u);
        EXPECT_EQ(reflection.stride("gnoTopPlanes"), 16u);
    }
}

TEST(Layout, SlabsOfATopTree) {
    const std::vector<Member> slab{MEMBER(GnoTopSlab, positive), MEMBER(GnoTopSlab, negative), MEMBER(GnoTopSlab, positiveDepth),
                                   MEMBER(GnoTopSlab, intersectionDepth)};
    for (const std::string shader :
         {"forest/examples/set_up.comp", "forest/examples/build.comp", "forest/examples/query_hybrid.comp", "forest/examples/query_stack.frag"}) {
        SCOPED_TRACE(shader);
        const Reflection reflection(shader);
        expectSame(reflection.layout(reflection.contents("gnoTopSlabs").self), slab, sizeof(GnoTopSlab));
        EXPECT_EQ(reflection.stride("gnoTopSlabs"), sizeof(GnoTopSlab));
    }
}

TEST(Layout, HeaderOfATopTree) {
    const std::vector<Member> header{MEMBER(GnoTopHeader, root), MEMBER(GnoTopHeader, casterCount), MEMBER(GnoTopHeader, state),
                                     MEMBER(GnoTopHeader, inserted)};
    for (const std::string shader : kTreeShaders) {
        SCOPED_TRACE(shader);
        const Reflection reflection(shader);
        expectSame(reflection.layout(reflection.contents("gnoTopHeader").self), header, sizeof(GnoTopHeader));
    }
    EXPECT_EQ(sizeof(GnoTopHeader), 16u);
}

TEST(Layout, BytesOfATopTreeFollowFromTheStrides) {
    const Reflection reflection("top/examples/build.comp");
    const uint64_t perCaster = 4 * (reflection.stride("gnoTopPlanes") + reflection.stride("gnoTopLinks"));
    const size_t header = reflection.layout(reflection.contents("gnoTopHeader").self).bytes;
    EXPECT_EQ(perCaster, 128u);
    for (const uint64_t casters : {1u, 2u, 63u, 1000u, 2097152u}) {
        EXPECT_EQ(topTreeBytes(casters), perCaster * casters + header);
        EXPECT_EQ(topPlaneBytes(casters), 4 * casters * reflection.stride("gnoTopPlanes"));
        EXPECT_EQ(topLinkBytes(casters), 4 * casters * reflection.stride("gnoTopLinks"));
    }
    EXPECT_EQ(topTreeBytes(0), topTreeBytes(1)) << "an empty scene still has buffers to bind";
    EXPECT_EQ(topTreeBytes(1ull << 33), 128ull * (1ull << 33) + header) << "must not wrap at 32 bits";
    EXPECT_EQ(topPlaneBytes(2097152), 128ull << 20) << "what one binding of 128 MiB holds";
    EXPECT_EQ(groupsFor(0, kTopGroupSize), 1u);  // the first invocation writes an empty tree's header
    EXPECT_EQ(groupsFor(1, kTopGroupSize), 1u);
    EXPECT_EQ(groupsFor(kTopGroupSize, kTopGroupSize), 1u);
    EXPECT_EQ(groupsFor(kTopGroupSize + 1, kTopGroupSize), 2u);
}

const std::vector<std::string>& clusterShaders() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> found;
        for (const std::string& shader : host::embeddedShaderNames())
            if (shader.starts_with("clusters/examples/")) found.push_back(shader);
        return found;
    }();
    return names;
}

TEST(Layout, FrameOfAClusterHierarchy) {
    const std::vector<Member> frame{MEMBER(GnoClusterFrame, origin),      MEMBER(GnoClusterFrame, right),       MEMBER(GnoClusterFrame, down),
                                    MEMBER(GnoClusterFrame, forward),     MEMBER(GnoClusterFrame, size),        MEMBER(GnoClusterFrame, casterCount),
                                    MEMBER(GnoClusterFrame, jobCapacity), MEMBER(GnoClusterFrame, boxCapacity), MEMBER(GnoClusterFrame, split),
                                    MEMBER(GnoClusterFrame, extraPlanes), MEMBER(GnoClusterFrame, frontCulled)};
    const std::vector<Member> layout{MEMBER(GnoClusterLayout, levels),  MEMBER(GnoClusterLayout, bits),   MEMBER(GnoClusterLayout, sliceBits),
                                     MEMBER(GnoClusterLayout, form),    MEMBER(GnoClusterLayout, tiles),  MEMBER(GnoClusterLayout, maskX),
                                     MEMBER(GnoClusterLayout, maskY),   MEMBER(GnoClusterLayout, maskZ),  MEMBER(GnoClusterLayout, unused0),
                                     MEMBER(GnoClusterLayout, unused1), MEMBER(GnoClusterLayout, unused2)};
    EXPECT_GE(clusterShaders().size(), 10u);
    for (const std::string& shader : clusterShaders()) {
        SCOPED_TRACE(shader);
        const Reflection reflection(shader);
        expectSame(reflection.member("gnoClusterFrame", 0), frame, sizeof(GnoClusterFrame));
        expectSame(reflection.member("gnoClusterFrame", 1), layout, sizeof(GnoClusterLayout));
        const Layout whole = reflection.whole("gnoClusterFrame");  // the host uploads one after the other
        EXPECT_EQ(whole.members.at(1).offset, sizeof(GnoClusterFrame));
        EXPECT_EQ(whole.bytes, sizeof(GnoClusterFrame) + sizeof(GnoClusterLayout));
    }
}

#define SAME_PLACE(mine, theirs, member) EXPECT_EQ(offsetof(mine, member), offsetof(theirs, member))

// clusters/passes.hpp does without GLM, so it says the same again.
TEST(Layout, ClustersOfTheHostAreThoseOfTheDevice) {
    static_assert(sizeof(ClusterFrame) == sizeof(GnoClusterFrame) && sizeof(ClusterLayout) == sizeof(GnoClusterLayout));
    SAME_PLACE(ClusterFrame, GnoClusterFrame, right);
    SAME_PLACE(ClusterFrame, GnoClusterFrame, down);
    SAME_PLACE(ClusterFrame, GnoClusterFrame, forward);
    SAME_PLACE(ClusterFrame, GnoClusterFrame, size);
    SAME_PLACE(ClusterFrame, GnoClusterFrame, casterCount);
    SAME_PLACE(ClusterFrame, GnoClusterFrame, jobCapacity);
    SAME_PLACE(ClusterFrame, GnoClusterFrame, boxCapacity);
    SAME_PLACE(ClusterFrame, GnoClusterFrame, split);
    SAME_PLACE(ClusterFrame, GnoClusterFrame, extraPlanes);
    SAME_PLACE(ClusterFrame, GnoClusterFrame, frontCulled);
    const std::array sizes{1u, 7u, 8u, 9u, 61u, 64u, 65u, 1000u, 1080u, 1920u, 4096u, 5000u, 8191u, 8192u};
    for (const uint32_t form : {GNO_CLUSTER_IMPLICIT, GNO_CLUSTER_EXPLICIT, GNO_CLUSTER_COMPACT, GNO_CLUSTER_FLAT})
        for (const uint32_t width : sizes)
            for (const uint32_t height : sizes) {
                SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height) + ", form " + std::to_string(form));
                const GnoClusterLayout want = gnoClusterLayout({width, height}, form);
                const ClusterLayout got = clusterLayout(width, height, ClusterForm(form));
                ASSERT_EQ(std::memcmp(&got, &want, sizeof want), 0);
                EXPECT_EQ(clusterWordCount(got), gnoClusterWordCount(want));
                EXPECT_EQ(clusterNodeCount(got), gnoClusterNodeCount(want));
                EXPECT_EQ(clusterSlices(got), gnoClusterSlices(want));
                EXPECT_EQ(clusterShadeWords(got), gnoClusterShadeWords(want));
                EXPECT_EQ(clusterTileHeight(got.form), gnoClusterTileHeight(want));
                for (uint32_t depth = 0; depth < want.levels; ++depth) EXPECT_EQ(clusterWordsAt(got, depth), gnoClusterWordsAt(want, depth));
            }
}

TEST(Layout, HeaderAndArraysOfAClusterHierarchy) {
    const std::vector<Member> header{MEMBER(GnoClusterHeader, leastDepth), MEMBER(GnoClusterHeader, largestDepth), MEMBER(GnoClusterHeader, slack),
                                     MEMBER(GnoClusterHeader, boxCount),   MEMBER(GnoClusterHeader, nextCaster),   MEMBER(GnoClusterHeader, nextJob),
                                     MEMBER(GnoClusterHeader, jobCount),   MEMBER(GnoClusterHeader, state),        MEMBER(GnoClusterHeader, groups),
                                     MEMBER(GnoClusterHeader, tiles),      MEMBER(GnoClusterHeader, levels),       MEMBER(GnoClusterHeader, volumes),
                                     MEMBER(GnoClusterHeader, unused0)};
    for (const std::string shader : {"reset", "range", "tiles", "allocate", "traverse", "finish_size"}) {
        SCOPED_TRACE(shader);
        expectSame(Reflection("clusters/examples/" + shader + ".comp").member("gnoClusterHeader", 0), header, sizeof(GnoClusterHeader));
    }
    EXPECT_EQ(offsetof(GnoClusterHeader, groups) % 4, 0u) << "an indirect dispatch reads it";
    const Reflection traverse("clusters/examples/traverse.comp");  // strides of what the host allocates
    for (const char* words : {"gnoClusterMasks", "gnoClusterShade", "gnoClusterLow", "gnoClusterHigh", "gnoClusterSliceTable"})
        EXPECT_EQ(traverse.stride(words), 4u) << words;
    for (const char* pairs : {"gnoClusterPointers", "gnoClusterInfo", "gnoClusterJobs"}) EXPECT_EQ(traverse.stride(pairs), 8u) << pairs;
    EXPECT_EQ(7 * traverse.stride("gnoClusterVolumes"), 112u);
}

TEST(Layout, GridCellsPairsAndHeaderOfAForest) {
    const std::vector<Member> grid{MEMBER(GnoForestGrid, across),    MEMBER(GnoForestGrid, along),      MEMBER(GnoForestGrid, stepAcross),
                                   MEMBER(GnoForestGrid, stepAlong), MEMBER(GnoForestGrid, resolution), MEMBER(GnoForestGrid, faces)};
    const std::vector<Member> cell{MEMBER(GnoForestCell, farthest), MEMBER(GnoForestCell, cover), MEMBER(GnoForestCell, pairs),
                                   MEMBER(GnoForestCell, root)};
    const std::vector<Member> pair{MEMBER(GnoForestPair, caster), MEMBER(GnoForestPair, cell)};
    const std::vector<Member> few{MEMBER(GnoForestFew, cells), MEMBER(GnoForestFew, least)};
    const std::vector<Member> header{
        MEMBER(GnoForestHeader, groupsOfPairs), MEMBER(GnoForestHeader, one0),    MEMBER(GnoForestHeader, one1), MEMBER(GnoForestHeader, pairs),
        MEMBER(GnoForestHeader, groupsOfSome),  MEMBER(GnoForestHeader, one2),    MEMBER(GnoForestHeader, one3), MEMBER(GnoForestHeader, some),
        MEMBER(GnoForestHeader, groupsOfMany),  MEMBER(GnoForestHeader, one4),    MEMBER(GnoForestHeader, one5), MEMBER(GnoForestHeader, many),
        MEMBER(GnoForestHeader, used),          MEMBER(GnoForestHeader, emitted), MEMBER(GnoForestHeader, state)};
    for (const std::string shader :
         {"reset.comp", "depth.comp", "sort.comp", "assign_few.comp", "assign_some.comp", "assign_many.comp", "allocate.comp", "sizes.comp",
          "set_up.comp", "build.comp", "query_stack.comp", "query_hybrid.frag", "query_stackless.comp.counters"}) {
        SCOPED_TRACE(shader);
        const Reflection reflection("forest/examples/" + shader);
        expectSame(reflection.member("gnoForestGrid", 0), grid, sizeof(GnoForestGrid));
        expectSame(reflection.member("gnoForestCells", 0), cell, sizeof(GnoForestCell));
        expectSame(reflection.member("gnoForestPairs", 0), pair, sizeof(GnoForestPair));
        expectSame(reflection.member("gnoForestHeader", 0), header, sizeof(GnoForestHeader));
        EXPECT_EQ(reflection.stride("gnoForestCells"), sizeof(GnoForestCell));
        expectSame(reflection.member("gnoForestFew", 0), few, sizeof(GnoForestFew));
        EXPECT_EQ(reflection.stride("gnoForestPairs"), sizeof(GnoForestPair));
        EXPECT_EQ(reflection.stride("gnoForestFew"), sizeof(GnoForestFew));
    }
    for (const size_t dispatch :
         {offsetof(GnoForestHeader, groupsOfPairs), offsetof(GnoForestHeader, groupsOfSome), offsetof(GnoForestHeader, groupsOfMany)})
        EXPECT_EQ(dispatch % 4, 0u) << "an indirect dispatch reads it";
    EXPECT_EQ(offsetof(GnoForestHeader, one1), offsetof(GnoForestHeader, groupsOfPairs) + 8) << "its three words lie together";
    EXPECT_EQ(offsetof(GnoForestHeader, one3), offsetof(GnoForestHeader, groupsOfSome) + 8);
    EXPECT_EQ(offsetof(GnoForestHeader, one5), offsetof(GnoForestHeader, groupsOfMany) + 8);
    EXPECT_EQ(gnoCellCount(64, 6), 24576u);
    EXPECT_EQ(gnoCellCount(1024, 6), 6u << 20);
}

TEST(Layout, ArraysOfALightSpaceHierarchy) {
    const std::vector<Member> header{MEMBER(GnoLightBvhHeader, groupsOfReferences),
                                     MEMBER(GnoLightBvhHeader, one0),
                                     MEMBER(GnoLightBvhHeader, one1),
                                     MEMBER(GnoLightBvhHeader, references),
                                     MEMBER(GnoLightBvhHeader, groupsOfTiles),
                                     MEMBER(GnoLightBvhHeader, one2),
                                     MEMBER(GnoLightBvhHeader, one3),
                                     MEMBER(GnoLightBvhHeader, roots),
                                     MEMBER(GnoLightBvhHeader, emitted),
                                     MEMBER(GnoLightBvhHeader, leaves),
                                     MEMBER(GnoLightBvhHeader, state)};
    const std::vector<Member> grid{MEMBER(GnoForestGrid, across),    MEMBER(GnoForestGrid, along),      MEMBER(GnoForestGrid, stepAcross),
                                   MEMBER(GnoForestGrid, stepAlong), MEMBER(GnoForestGrid, resolution), MEMBER(GnoForestGrid, faces)};
    const std::vector<Member> box{MEMBER(GnoLightBvhBox, low), MEMBER(GnoLightBvhBox, high), MEMBER(GnoLightBvhBox, least),
                                  MEMBER(GnoLightBvhBox, link)};
    const std::vector<Member> node{MEMBER(GnoLightBvhNode, low), MEMBER(GnoLightBvhNode, high), MEMBER(GnoLightBvhNode, least),
                                   MEMBER(GnoLightBvhNode, link)};
    const std::vector<Member> level{MEMBER(GnoLightBvhLevel, groups), MEMBER(GnoLightBvhLevel, one0), MEMBER(GnoLightBvhLevel, one1),
                                    MEMBER(GnoLightBvhLevel, count), MEMBER(GnoLightBvhLevel, first)};
    for (const std::string shader : {"count.comp", "emit.comp", "split.comp", "query_stack.comp", "query_stackless.frag"}) {
        SCOPED_TRACE(shader);
        const Reflection reflection("rivals/examples/light_bvh_" + shader);
        expectSame(reflection.member("gnoLightBvhGrid", 0), grid, sizeof(GnoForestGrid));
    }
    const Reflection collapse("rivals/examples/light_bvh_collapse.comp"), split("rivals/examples/light_bvh_split.comp");
    expectSame(split.member("gnoLightBvhHeader", 0), header, sizeof(GnoLightBvhHeader));
    expectSame(split.member("gnoLightBvhBoxes_", 0), box, sizeof(GnoLightBvhBox));
    expectSame(collapse.member("gnoLightBvhNode", 0), node, sizeof(GnoLightBvhNode));
    expectSame(collapse.member("gnoLightBvhLevels", 0), level, sizeof(GnoLightBvhLevel));
    expectSame(Reflection("rivals/examples/light_bvh_query_stack.frag").member("gnoLightBvhNode", 0), node, sizeof(GnoLightBvhNode));
    EXPECT_EQ(split.stride("gnoLightBvhBoxes_"), sizeof(GnoLightBvhBox));
    EXPECT_EQ(collapse.stride("gnoLightBvhNode"), sizeof(GnoLightBvhNode));
    EXPECT_EQ(collapse.stride("gnoLightBvhLevels"), sizeof(GnoLightBvhLevel));
    for (const size_t offset :
         {offsetof(GnoLightBvhHeader, groupsOfReferences), offsetof(GnoLightBvhHeader, groupsOfTiles), sizeof(GnoLightBvhLevel)})
        EXPECT_EQ(offset % 4, 0u) << "an indirect dispatch reads it";
}

TEST(Layout, ViewsOfAShadowMap) {
    const std::vector<Member> header{MEMBER(GnoShadowMapHeader, viewCount), MEMBER(GnoShadowMapHeader, size), MEMBER(GnoShadowMapHeader, state),
                                     MEMBER(GnoShadowMapHeader, unused0)};
    const std::vector<Member> view{MEMBER(GnoShadowMapView, x), MEMBER(GnoShadowMapView, y), MEMBER(GnoShadowMapView, z),
                                   MEMBER(GnoShadowMapView, w), MEMBER(GnoShadowMapView, bias)};
    for (const std::string shader : {"fit.comp", "depth.vert", "query.comp", "query.frag"}) {
        SCOPED_TRACE(shader);
        const Reflection reflection("shadow_map/examples/" + shader);
        expectSame(reflection.member("gnoShadowMapViews", 0), header, sizeof(GnoShadowMapHeader));
        expectSame(reflection.member("gnoShadowMapViews", 1), view, sizeof(GnoShadowMapView));
        EXPECT_EQ(reflection.whole("gnoShadowMapViews").members.at(1).offset, sizeof(GnoShadowMapHeader));
    }
}

TEST(Layout, CastersArePackedFloats) {
    for (const std::string shader : {"core/examples/view_samples.comp", "core/examples/gbuffer.vert", "top/examples/set_up.comp"}) {
        SCOPED_TRACE(shader);
        const Reflection reflection(shader);
        EXPECT_EQ(reflection.contents("gnoCasters").basetype, spirv_cross::SPIRType::Float);
        EXPECT_EQ(reflection.contents("gnoCasters").vecsize, 1u);
        EXPECT_EQ(reflection.stride("gnoCasters"), 4u);
    }
    EXPECT_EQ(sizeof(GnoCaster), 36u);  // uploaded as they are
    EXPECT_EQ(sizeof(host::Triangle), 36u);
}

TEST(Layout, PushBlockOfEveryShader) {
    using host::ExamplePush;
    const std::vector<Member> push{MEMBER(ExamplePush, light),  MEMBER(ExamplePush, viewer), MEMBER(ExamplePush, size),
                                   MEMBER(ExamplePush, count),  MEMBER(ExamplePush, seed),   MEMBER(ExamplePush, cull),
                                   MEMBER(ExamplePush, planes), MEMBER(ExamplePush, number)};
    size_t found = 0;
    for (const std::string& shader : host::embeddedShaderNames()) {
        SCOPED_TRACE(shader);
        const std::optional<Layout> block = Reflection(shader).pushBlock();
        if (!block || block->members.at(0).name != "light") continue;
        ++found;
        expectSame(*block, push, sizeof(ExamplePush));
    }
    EXPECT_GE(found, 16u);
}

/// The comparison can fail: C++ structs that are wrong in one way each do not pass for the SPIR-V's.
TEST(Layout, LightGrid) {
    const std::vector<Member> list{MEMBER(GnoLightGridList, first), MEMBER(GnoLightGridList, end)};
    const std::vector<Member> item{MEMBER(GnoLightGridItem, depth), MEMBER(GnoLightGridItem, caster)};
    const std::vector<Member> header{
        MEMBER(GnoLightGridHeader, groupsOfPairs), MEMBER(GnoLightGridHeader, one0),          MEMBER(GnoLightGridHeader, one1),
        MEMBER(GnoLightGridHeader, nests),         MEMBER(GnoLightGridHeader, groupsOfLists), MEMBER(GnoLightGridHeader, one2),
        MEMBER(GnoLightGridHeader, one3),          MEMBER(GnoLightGridHeader, items),         MEMBER(GnoLightGridHeader, emitted),
        MEMBER(GnoLightGridHeader, groups),        MEMBER(GnoLightGridHeader, finished),      MEMBER(GnoLightGridHeader, state),
        MEMBER(GnoLightGridHeader, planes)};
    for (const std::string shader :
         {"rivals/examples/light_grid_pairs.comp", "rivals/examples/light_grid_sort.comp", "rivals/examples/light_grid_query_planes.frag"}) {
        SCOPED_TRACE(shader);
        const Reflection reflection(shader);
        expectSame(reflection.layout(reflection.contents("gnoGridLists").self), list, sizeof(GnoLightGridList));
        expectSame(reflection.layout(reflection.contents("gnoGridItems").self), item, sizeof(GnoLightGridItem));
        EXPECT_EQ(reflection.stride("gnoGridLists"), 8u);
        EXPECT_EQ(reflection.stride("gnoGridItems"), 8u);
        EXPECT_EQ(reflection.stride("gnoGridPlanes"), 16u);
    }
    const Reflection open("rivals/examples/light_grid_open.comp");
    expectSame(open.layout(open.contents("gnoGridHeader").self), header, sizeof(GnoLightGridHeader));
    EXPECT_EQ(open.stride("gnoGridDepths"), 4u);
    EXPECT_EQ(gnoLightGridLists(6 * 64 * 64, 3), 6u * 64 * 64 + 3 * 64);
    EXPECT_EQ(gnoLightGridLists(1, 0), 64u) << "the cells' own lists are whole work groups";
}

TEST(Layout, ComparisonSeesWrongStructs) {
    struct Swapped {
        uint intersectionChild, positiveChild, aux, wedge;
    };
    struct Moved {
        uint positiveChild, intersectionChild, gap, aux, wedge;
    };
    struct Longer {
        uint positiveChild, intersectionChild, aux, wedge, more;
    };
    const Reflection reflection("top/examples/build.comp");
    const Layout link = reflection.layout(reflection.contents("gnoTopLinks").self);
    const std::vector<Member> swapped{MEMBER(Swapped, intersectionChild), MEMBER(Swapped, positiveChild), MEMBER(Swapped, aux),
                                      MEMBER(Swapped, wedge)};
    const std::vector<Member> moved{MEMBER(Moved, positiveChild), MEMBER(Moved, intersectionChild), MEMBER(Moved, aux), MEMBER(Moved, wedge)};
    const std::vector<Member> longer{MEMBER(Longer, positiveChild), MEMBER(Longer, intersectionChild), MEMBER(Longer, aux), MEMBER(Longer, wedge)};
    EXPECT_NE(difference(link, swapped, sizeof(Swapped)), "");
    EXPECT_NE(difference(link, moved, sizeof(Moved)), "");
    EXPECT_NE(difference(link, longer, sizeof(Longer)), "");
    EXPECT_EQ(difference(link, longer, sizeof(GnoTopLink)), "");
    EXPECT_THROW((void)reflection.stride("gnoNoSuchBuffer"), std::runtime_error);
}

}  // namespace
}  // namespace gno
