// SPDX-License-Identifier: MIT
// The hierarchy as the device builds it, read back and held against the view samples: every bit, every box, the measured depths, the slack.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "host_min/techniques/cluster_hierarchy.hpp"
#include "validation/support/camera_view.hpp"
#include "validation/support/device_test.hpp"
#include "validation/support/glsl_as_cpp.hpp"
#include "validation/tests/oracle_cases.hpp"

namespace {
struct Arrays {
    gno::GnoClusterFrame frame;
    gno::GnoClusterLayout tree;
    gno::GnoClusterHeader header;
    std::vector<float> slices, low, high;
    std::vector<gno::uint> masks;
    std::vector<gno::uvec2> pointers;
} arrays;
}  // namespace
#define GNO_CLUSTER_FRAME arrays.frame
#define GNO_CLUSTER_LAYOUT arrays.tree
#define GNO_CLUSTER_FORM arrays.tree.form
#define GNO_CLUSTER_SLICES arrays.slices
#define GNO_CLUSTER_MASKS arrays.masks
#define GNO_CLUSTER_LOW arrays.low
#define GNO_CLUSTER_HIGH arrays.high
#define GNO_CLUSTER_POINTERS arrays.pointers
#include "glsl/clusters/bounds.glsl"
#include "glsl/clusters/key.glsl"
namespace gno {
namespace {
#pragma GCC diagnostic ignored "-Wunused-function"
#include "glsl/clusters/nodes.glsl"

using test::CameraView;
constexpr uint32_t kSeed = 413;

void build(const CameraView& view, uint32_t form, uint32_t boxes) {
    host::FrameInputs inputs(test::passes(), view.frame, view.pixels, view.width);
    inputs.setLight({0, 0, 0, 1}, host::Cull::none);
    ClusterOptions options;
    options.form = ClusterForm(form);
    options.boxCapacity = boxes;
    // the second run finds the arrays as the first left them
    const auto hierarchy = host::built<host::ClusterHierarchy>(inputs, options, {.repeat = 2, .warmUp = false, .counters = false});
    arrays = {};
    for (const host::DumpedBuffer& buffer : hierarchy.dump()) {
        const auto fill = [&](auto& list) {
            list.resize(buffer.bytes.size() / sizeof(list[0]));
            std::memcpy(list.data(), buffer.bytes.data(), list.size() * sizeof(list[0]));
        };
        if (buffer.name == "frame") {
            std::memcpy(&arrays.frame, buffer.bytes.data(), sizeof arrays.frame);
            std::memcpy(&arrays.tree, buffer.bytes.data() + sizeof arrays.frame, sizeof arrays.tree);
        }
        if (buffer.name == "header") std::memcpy(&arrays.header, buffer.bytes.data(), sizeof arrays.header);
        if (buffer.name == "slices") fill(arrays.slices);
        if (buffer.name == "masks") fill(arrays.masks);
        if (buffer.name == "low") fill(arrays.low);
        if (buffer.name == "high") fill(arrays.high);
        if (buffer.name == "pointers") fill(arrays.pointers);
    }
    arrays.slices.resize(gnoClusterSlices(arrays.tree) + 1);
    arrays.masks.resize(gnoClusterWordCount(arrays.tree));
}

struct Box {
    vec3 low{4}, high{-4};
    float nearest = INFINITY, farthest = -INFINITY;  ///< depth
    float outside = 0;                               ///< how far the sample farthest outside lies
};
using Nodes = std::map<std::pair<uint, uint>, Box>;  ///< by depth and key

/// The nodes that the samples need, made on the CPU.
Nodes nodesOf(const CameraView& view) {
    const GnoClusterLayout& l = arrays.tree;
    Nodes nodes;
    for (uint i = 0; i < view.pixels.size(); ++i) {
        const host::OracleSample& s = view.pixels[i];
        if (s.own > GNO_NO_CASTER) continue;
        const uvec2 tile(i % view.width / 8, i / view.width / gnoClusterTileHeight(l));
        const float depth = gnoClusterDepth(arrays.frame, s.position);
        uint key = gnoClusterLeafKey(tile, depth);
        const vec2 from = gnoClusterSlope(arrays.frame, gnoClusterTilePixel(l.form, tile, 0)),
                   to = gnoClusterSlope(arrays.frame, gnoClusterTilePixel(l.form, tile + uvec2(1), 0));
        for (uint d = l.levels; d > 0; --d, key >>= 5) {
            Box& box = nodes[{d, key}];
            box.low = min(box.low, s.position), box.high = max(box.high, s.position);
            box.nearest = std::min(box.nearest, depth), box.farthest = std::max(box.farthest, depth);
            box.outside = std::max(box.outside, gnoClusterOutside(arrays.frame, s.position, from, to));
        }
    }
    return nodes;
}

void expectHeader(const Nodes& nodes) {
    Box all;
    for (const auto& [at, box] : nodes) {
        all.nearest = std::min(all.nearest, box.nearest), all.farthest = std::max(all.farthest, box.farthest);
        all.outside = std::max(all.outside, box.outside);
    }
    const GnoClusterHeader& header = arrays.header;
    if (nodes.empty()) {
        EXPECT_EQ(header.leastDepth, 0xFFFFFFFFu);
        EXPECT_EQ(header.largestDepth, 0u);
    } else {
        EXPECT_EQ(header.leastDepth, gnoClusterOrdered(all.nearest));
        EXPECT_EQ(header.largestDepth, gnoClusterOrdered(all.farthest));
        EXPECT_EQ(arrays.slices.front(), all.nearest);
        EXPECT_EQ(arrays.slices.back(), all.farthest);
    }
    EXPECT_FLOAT_EQ(uintBitsToFloat(header.slack), all.outside);
    for (size_t i = 0; i + 1 < arrays.slices.size() && !nodes.empty(); ++i) ASSERT_LE(arrays.slices[i], arrays.slices[i + 1]) << i;
}

void expectMasks(const Nodes& nodes) {
    std::vector<uint> want(arrays.masks.size(), 0);
    for (const auto& [at, box] : nodes) want[gnoClusterWord(arrays.tree, at.first - 1, at.second >> 5)] |= 1u << (at.second & 31);
    for (size_t i = 0; i < want.size(); ++i) ASSERT_EQ(arrays.masks[i], want[i]) << "word " << i;
}

/// How many nodes have no box of their own (compact, list too small).
size_t expectBoxes(const Nodes& nodes, uint32_t capacity) {
    const bool compact = arrays.tree.form == GNO_CLUSTER_COMPACT;
    size_t without = 0;
    std::set<uint> used;
    for (const auto& [at, box] : nodes) {
        const uint index = gnoClusterBoxIndex(at.first, at.second);
        if (index == GNO_CLUSTER_NONE) {
            EXPECT_TRUE(compact);
            ++without;
            continue;
        }
        EXPECT_TRUE(used.insert(index).second) << "two nodes share box " << index;
        if (compact) {
            EXPECT_LT(index, capacity);
        }
        if (arrays.tree.form == GNO_CLUSTER_FLAT) {
            EXPECT_EQ(arrays.low[index], box.nearest);
            EXPECT_EQ(arrays.high[index], box.farthest);
            continue;
        }
        const vec3 low = gnoClusterLow_(index), high = gnoClusterHigh_(index);
        if (low.x > high.x) {  // a child without a box, whose samples it cannot know
            ++without;
            continue;
        }
        EXPECT_EQ(low, box.low) << "depth " << at.first << " key " << at.second;
        EXPECT_EQ(high, box.high) << "depth " << at.first << " key " << at.second;
    }
    if (compact) {
        EXPECT_EQ(arrays.header.boxCount, nodes.size());
        if (capacity >= nodes.size()) {
            EXPECT_EQ(without, 0u);
        }
    }
    return without;
}

/// Every node's cell by its key: samples are no farther outside than the slack, and within its depths.
void expectCells(const CameraView& view) {
    const GnoClusterLayout& l = arrays.tree;
    const float slack = uintBitsToFloat(arrays.header.slack);
    for (uint i = 0; i < view.pixels.size(); ++i) {
        const host::OracleSample& s = view.pixels[i];
        if (s.own > GNO_NO_CASTER) continue;
        const float depth = gnoClusterDepth(arrays.frame, s.position);
        uint key = gnoClusterLeafKey(uvec2(i % view.width / 8, i / view.width / 8), depth);
        for (uint d = l.levels, below = 0; d > 0; --d, key >>= 5, below += 5) {
            const auto part = [&](uint mask, uint& size) {
                size = 1u << std::popcount(mask & ((1u << below) - 1));
                return gnoClusterExtract(key, mask >> below) * size;
            };
            uvec3 size;
            const uint x = part(l.maskX, size.x), y = part(l.maskY, size.y), z = part(l.maskZ, size.z);
            ASSERT_GE(depth, arrays.slices.at(z));
            ASSERT_LE(depth, arrays.slices.at(z + size.z));
            const vec2 from = gnoClusterSlope(arrays.frame, {8 * x, 8 * y}),
                       to = gnoClusterSlope(arrays.frame, {8 * (x + size.x), 8 * (y + size.y)});
            ASSERT_LE(gnoClusterOutside(arrays.frame, s.position, from, to), slack);
        }
    }
}

struct Form {
    uint32_t form, boxes;
};
constexpr Form kForms[] = {{GNO_CLUSTER_IMPLICIT, 0}, {GNO_CLUSTER_EXPLICIT, 0}, {GNO_CLUSTER_COMPACT, 1u << 16},
                           {GNO_CLUSTER_COMPACT, 1},  {GNO_CLUSTER_COMPACT, 20}, {GNO_CLUSTER_FLAT, 0}};

/// Nodes of the implicit form.
size_t expectHierarchy(const CameraView& view) {
    size_t implicitNodes = 0;
    for (const Form& f : kForms) {
        SCOPED_TRACE(fmt::format("form {}, {} boxes", f.form, f.boxes));
        build(view, f.form, f.boxes);
        const Nodes nodes = nodesOf(view);
        expectHeader(nodes);
        expectMasks(nodes);
        if (f.form != GNO_CLUSTER_IMPLICIT) {
            const size_t without = expectBoxes(nodes, f.boxes);
            if (f.form == GNO_CLUSTER_COMPACT && f.boxes < nodes.size()) {
                EXPECT_GT(without, 0u);
            }
        } else {
            implicitNodes = nodes.size();
            expectCells(view);
        }
    }
    return implicitNodes;
}

CameraView emptyView(uint32_t width, uint32_t height, bool perspective) {
    CameraView view;
    view.width = width;
    view.height = height;
    view.frame.camera = test::lookAt({0.5, 0.75, 1.25}, {0, -0.25, 0}, perspective ? 0.6 : 0.9, perspective);
    return view;
}

/// Depths of a slope with holes in it and steep edges.
std::vector<double> roughDepths(const CameraView& view, double nearest, double farthest) {
    host::cases::Random random(kSeed);
    std::vector<double> depths;
    for (uint32_t i = 0; i < view.width * view.height; ++i) {
        const double across = double(i % view.width) / view.width, step = random.below(16) == 0 ? random.real(0, 1) : across;
        depths.push_back(i / view.width % 13 == 5 ? 0.0 : nearest * std::pow(farthest / nearest, step));
    }
    return depths;
}

TEST(ClusterBuild, Perspective) {
    CameraView view = emptyView(100, 75, true);
    fillPixels(view, roughDepths(view, 0.05, 1.5));
    EXPECT_GT(expectHierarchy(view), 500u);
}

TEST(ClusterBuild, Orthographic) {
    CameraView view = emptyView(75, 100, false);
    fillPixels(view, roughDepths(view, 0.4, 2.0));
    EXPECT_GT(expectHierarchy(view), 300u);
}

TEST(ClusterBuild, SixtyFourDepthsInOneTile) {
    CameraView view = emptyView(128, 128, true);
    std::vector<double> depths(128 * 128, 0.0);
    for (uint32_t i = 0; i < 64; ++i) depths[(40 + i / 8) * 128 + 64 + i % 8] = 0.001 * std::pow(2000.0, i / 63.0);
    fillPixels(view, depths);
    expectHierarchy(view);
    build(view, GNO_CLUSTER_EXPLICIT, 0);
    const Nodes nodes = nodesOf(view);
    EXPECT_EQ(std::count_if(nodes.begin(), nodes.end(), [](const auto& n) { return n.first.first == arrays.tree.levels; }), 64);
}

TEST(ClusterBuild, OneSampleOrNone) {
    for (const uvec2 size : {uvec2(1, 1), uvec2(9, 3), uvec2(128, 64)}) {
        CameraView view = emptyView(size.x, size.y, true);
        std::vector<double> depths(size_t(size.x) * size.y, 0.0);
        fillPixels(view, depths);
        EXPECT_EQ(expectHierarchy(view), 0u);
        depths.back() = 0.75;
        fillPixels(view, depths);
        EXPECT_EQ(expectHierarchy(view), gnoClusterLayout(size, GNO_CLUSTER_IMPLICIT).levels);
    }
}

TEST(ClusterBuild, OneDepthForAll) {
    CameraView view = emptyView(64, 64, false);
    view.frame.camera = test::lookAt({0, 0, 1}, {0, 0, 0}, 0.5, false);
    fillPixels(view, std::vector<double>(64 * 64, 1.0));
    expectHierarchy(view);
    EXPECT_EQ(arrays.header.leastDepth, arrays.header.largestDepth);
}

// Samples anywhere, behind the viewer too: nothing is where its pixel is, and the slack says so.
TEST(ClusterBuild, SamplesThatNoCameraSaw) {
    CameraView view = emptyView(64, 32, true);
    host::cases::Random random(kSeed);
    for (uint32_t i = 0; i < 64 * 32; ++i)
        view.pixels.push_back({host::cases::snap(random.inCube()), random.below(5) ? GNO_NO_CASTER : GNO_BACKGROUND});
    expectHierarchy(view);
    EXPECT_GT(uintBitsToFloat(arrays.header.slack), 0.5f);
}

}  // namespace
}  // namespace gno
