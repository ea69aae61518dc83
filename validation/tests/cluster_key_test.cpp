// SPDX-License-Identifier: MIT
// clusters/cluster.h, key.glsl and the look-up of nodes.glsl, compiled as C++: the paper's numbers, every size up to 8192x8192, keys and indices
// without a gap or a clash, and depth slices that hold what they should.
#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <random>
#include <vector>

#include "validation/support/glsl_as_cpp.hpp"

#include "glsl/clusters/cluster.h"

namespace {
gno::GnoClusterFrame frame;
gno::GnoClusterLayout tree;
std::vector<float> slices;
std::vector<gno::uint> masks;
std::vector<float> low, high;
std::vector<gno::uvec2> pointers;
}  // namespace
#define GNO_CLUSTER_FRAME frame
#define GNO_CLUSTER_LAYOUT tree
#define GNO_CLUSTER_FORM tree.form
#define GNO_CLUSTER_SLICES slices
#define GNO_CLUSTER_MASKS masks
#define GNO_CLUSTER_LOW low
#define GNO_CLUSTER_HIGH high
#define GNO_CLUSTER_POINTERS pointers
#include "glsl/clusters/key.glsl"
#pragma GCC diagnostic ignored "-Wunused-function"
namespace gno {
namespace {
#include "glsl/clusters/nodes.glsl"

constexpr uint kForms[] = {GNO_CLUSTER_IMPLICIT, GNO_CLUSTER_EXPLICIT, GNO_CLUSTER_COMPACT, GNO_CLUSTER_FLAT};
constexpr uint32_t kSeed = 411;

// Section 3: "With a maximum resolution of 1024x1024 [...] the total number of nodes in a full tree is 8.65 million"; figure 2: 7 + 7 + 9 bits.
TEST(ClusterLayout, NumbersOfThePaper) {
    const GnoClusterLayout a = gnoClusterLayout({1024, 1024}, GNO_CLUSTER_EXPLICIT);
    EXPECT_EQ(a.bits, 23u);
    EXPECT_EQ(a.levels, 5u);
    EXPECT_EQ(a.sliceBits, 9u);
    const uint words[5] = {1, 8, 256, 8192, 262144};
    for (uint depth = 0; depth < 5; ++depth) EXPECT_EQ(gnoClusterWordsAt(a, depth), words[depth]);
    EXPECT_EQ(gnoClusterNodeCount(a), 8659208u);
    EXPECT_EQ(a.maskX, 0b00001001001001001001001u);
    EXPECT_EQ(a.maskY, 0b00010010010010010010010u);
    EXPECT_EQ(a.maskZ, 0b11100100100100100100100u);
    const GnoClusterLayout b = gnoClusterLayout({1920, 1080}, GNO_CLUSTER_COMPACT);
    EXPECT_EQ(b.bits, 26u);
    EXPECT_EQ(b.levels, 6u);
    EXPECT_EQ(gnoClusterNodeCount(b), 69273666u);
    EXPECT_EQ(gnoClusterLayout({8192, 8192}, GNO_CLUSTER_IMPLICIT).sliceBits, 9u);
    EXPECT_EQ(gnoClusterLayout({8192, 8192}, GNO_CLUSTER_COMPACT).sliceBits, 8u);
    const GnoClusterLayout c = gnoClusterLayout({1024, 1024}, GNO_CLUSTER_FLAT);  // 2011: tiles of 8x4
    EXPECT_EQ(c.bits, 15u);
    EXPECT_EQ(c.maskZ, 0u);
    EXPECT_EQ(gnoClusterShadeWords(c), 1024u * 1024u / 32u);
    EXPECT_EQ(gnoClusterShadeWords(a), 1024u * 1024u / 32u);
}

/// Empty: the masks hold every tile, keys and indices are as promised.
std::string fault(const GnoClusterLayout& l, uvec2 size) {
    const uint height = gnoClusterTileHeight(l);
    if (l.tiles.x * 8 < size.x || l.tiles.x * 8 >= size.x + 8 || l.tiles.y * height < size.y || l.tiles.y * height >= size.y + height)
        return "tiles";
    if (l.bits < 1 || l.bits > (l.form == GNO_CLUSTER_COMPACT ? 28u : 29u)) return "bits";
    if (l.levels < 1 || l.levels > GNO_CLUSTER_MOST_LEVELS || l.levels != (l.bits + 4) / 5) return "levels";
    if ((l.maskX & l.maskY) != 0 || (l.maskX & l.maskZ) != 0 || (l.maskY & l.maskZ) != 0) return "masks overlap";
    const uint all = l.maskX | l.maskY | l.maskZ;
    if (all != (1u << l.bits) - 1 && !(all == 0 && l.bits == 1)) return "masks leave a gap";
    if ((1u << std::popcount(l.maskX)) < l.tiles.x || (1u << std::popcount(l.maskY)) < l.tiles.y) return "a mask holds too few tiles";
    if (gnoClusterSlices(l) != 1u << std::popcount(l.maskZ)) return "slices";
    return "";
}

TEST(ClusterLayout, EverySize) {
    std::vector<uint> others;
    for (uint power = 1; power <= 8192; power *= 2)
        for (const uint size : {power - 1, power, power + 1})
            if (size >= 1 && size <= 8192) others.push_back(size);
    uint layouts = 0;
    for (const uint form : kForms)
        for (uint width = 1; width <= 8192; ++width)
            for (const uint other : others)
                for (const uvec2 size : {uvec2(width, other), uvec2(other, width)}) {
                    ++layouts;
                    ASSERT_EQ(fault(gnoClusterLayout(size, form), size), "") << size.x << "x" << size.y << " form " << form;
                }
    std::printf("%u layouts\n", layouts);
}

TEST(ClusterKey, InvertsForEveryTileAndSlice) {
    for (const uint form : kForms)
        for (const uvec2 size : {uvec2(1, 1), uvec2(9, 4), uvec2(333, 217), uvec2(1024, 1024), uvec2(8192, 1), uvec2(1, 8192), uvec2(8192, 8192)}) {
            const GnoClusterLayout l = gnoClusterLayout(size, form);
            // Masks do not overlap (EverySize), so a key that gives back each of its parts belongs to no other cluster.
            for (const uint mask : {l.maskX, l.maskY, l.maskZ})
                for (uint value = 0; value < 1u << std::popcount(mask); ++value) {
                    const uint key = gnoClusterDeposit(value, mask);
                    ASSERT_EQ(key & ~mask, 0u);
                    ASSERT_EQ(gnoClusterExtract(key | ~mask, mask), value);
                }
        }
}

TEST(ClusterKey, NeighboursShareAParent) {  // the rearranged Morton order: x, y and slice alternate, x lowest
    const GnoClusterLayout l = gnoClusterLayout({1024, 1024}, GNO_CLUSTER_IMPLICIT);
    const auto key = [&](uint x, uint y, uint z) {
        return gnoClusterDeposit(x, l.maskX) | gnoClusterDeposit(y, l.maskY) | gnoClusterDeposit(z, l.maskZ);
    };
    EXPECT_EQ(key(1, 0, 0), 1u);
    EXPECT_EQ(key(0, 1, 0), 2u);
    EXPECT_EQ(key(0, 0, 1), 4u);
    EXPECT_EQ(key(3, 3, 1) >> 5, 0u);  // 4 x 4 tiles and 2 slices under a node
    EXPECT_EQ(key(4, 0, 0) >> 5, 2u);
    EXPECT_EQ(key(0, 0, 2) >> 5, 1u);
    EXPECT_EQ(key(127, 127, 511), (1u << 23) - 1);
}

TEST(ClusterIndex, DenseAndDisjoint) {
    std::map<std::pair<uint, uint>, GnoClusterLayout> distinct;  // indices follow from bits and levels
    for (const uint form : kForms)
        for (uint size = 1; size <= 8192; size = size < 64 ? size + 1 : size * 2) {
            const GnoClusterLayout l = gnoClusterLayout({size, size}, form);
            distinct[{l.bits, l.levels}] = l;
        }
    EXPECT_GE(distinct.size(), 15u);
    for (const auto& [key, l] : distinct) {
        uint64_t nodes = 0, words = 0;
        for (uint depth = 0; depth < l.levels; ++depth) {
            const uint count = gnoClusterWordsAt(l, depth);
            ASSERT_EQ(gnoClusterWord(l, depth, 0), words) << "depth " << depth;
            ASSERT_EQ(gnoClusterWord(l, depth, count - 1), words + count - 1);
            words += count;
            const uint64_t children = depth == 0 ? 1u << (l.bits - 5 * (l.levels - 1)) : 32ull * count;
            ASSERT_EQ(gnoClusterFirstNode(l, depth + 1), nodes) << "depth " << depth + 1;
            if (depth + 1 < l.levels) {
                ASSERT_EQ(gnoClusterWordsAt(l, depth + 1), children) << "a word for every inner node";
            }
            nodes += children;
        }
        EXPECT_EQ(gnoClusterWordCount(l), words);
        EXPECT_EQ(gnoClusterNodeCount(l), nodes);
        EXPECT_EQ(nodes - gnoClusterFirstNode(l, l.levels), 1ull << l.bits) << "a leaf for every key";
        EXPECT_LE(4 * words, 128ull << 20) << "one binding";
    }
}

TEST(ClusterKey, OfATileAndADepth) {
    tree = gnoClusterLayout({64, 64}, GNO_CLUSTER_IMPLICIT);
    slices.clear();
    for (uint i = 0; i <= gnoClusterSlices(tree); ++i) slices.push_back(float(i));
    EXPECT_EQ(gnoClusterLeafKey({5, 2}, 9.5f),
              gnoClusterDeposit(5, tree.maskX) | gnoClusterDeposit(2, tree.maskY) | gnoClusterDeposit(9, tree.maskZ));
    EXPECT_EQ(gnoClusterTilePixel(tree.form, {5, 2}, 63), uvec2(47, 23));
    tree = gnoClusterLayout({64, 64}, GNO_CLUSTER_FLAT);
    EXPECT_EQ(gnoClusterLeafKey({5, 2}, 9.5f), gnoClusterDeposit(5, tree.maskX) | gnoClusterDeposit(2, tree.maskY));
    EXPECT_EQ(gnoClusterTilePixel(tree.form, {5, 2}, 31), uvec2(47, 11));
}

TEST(ClusterIndex, BoxByRankAmongSiblings) {
    tree = gnoClusterLayout({64, 64}, GNO_CLUSTER_COMPACT);
    pointers.assign(gnoClusterWordCount(tree), uvec2(0));
    const uint key = 5u << 5;
    pointers[gnoClusterWord(tree, tree.levels - 1, 5)] = uvec2(100, 0x80000012u);  // children 1, 4 and 31
    EXPECT_EQ(gnoClusterBoxIndex(tree.levels, key | 1u), 100u);
    EXPECT_EQ(gnoClusterBoxIndex(tree.levels, key | 4u), 101u);
    EXPECT_EQ(gnoClusterBoxIndex(tree.levels, key | 31u), 102u);
    pointers[gnoClusterWord(tree, tree.levels - 1, 5)].x = GNO_CLUSTER_NONE;
    EXPECT_EQ(gnoClusterBoxIndex(tree.levels, key | 31u), GNO_CLUSTER_NONE);
    tree.form = GNO_CLUSTER_EXPLICIT;
    EXPECT_EQ(gnoClusterBoxIndex(1, 3), 3u);
    EXPECT_EQ(gnoClusterBoxIndex(2, 3), gnoClusterFirstNode(tree, 2) + 3);
}

TEST(ClusterDepth, OrderedIntegersCompareAsFloats) {
    std::mt19937 random(kSeed);
    std::vector<float> values{-2.0f, -1e-30f, -0.0f, 0.0f, 1e-30f, 1.0f, 3.0f};
    for (int i = 0; i < 1000; ++i) values.push_back(std::ldexp(float(int32_t(random())) * 0x1p-31f, int(random() % 40) - 38));
    for (const float x : values) {
        EXPECT_EQ(std::bit_cast<uint32_t>(gnoClusterFromOrdered(gnoClusterOrdered(x))), std::bit_cast<uint32_t>(x));
        EXPECT_NE(gnoClusterOrdered(x), 0u) << "0 stands for none";
        EXPECT_NE(gnoClusterOrdered(x), 0xFFFFFFFFu) << "so does the largest";
        for (const float y : values) ASSERT_TRUE(!(x < y) || gnoClusterOrdered(x) < gnoClusterOrdered(y)) << x << " " << y;
    }
}

void useSlices(uvec2 size, uint form, float slope, bool perspective, float least, float largest) {
    frame = {};
    frame.origin.w = perspective ? 1.0f : 0.0f;
    frame.down.w = slope;
    frame.size = size;
    tree = gnoClusterLayout(size, form);
    slices.clear();
    for (uint i = 0; i <= gnoClusterSlices(tree); ++i) slices.push_back(gnoClusterSliceStart(frame, tree, least, largest, i));
}

/// Empty: not decreasing, from the least depth to the largest, and the look-up finds the slice that holds a depth.
std::string sliceFault(float least, float largest, std::mt19937& random) {
    if (slices.front() != least || slices.back() != largest) return "ends";
    for (size_t i = 0; i + 1 < slices.size(); ++i)
        if (!(slices[i] <= slices[i + 1])) return "decreases at " + std::to_string(i);
    std::vector<float> depths(slices);
    for (int i = 0; i < 50; ++i) depths.push_back(std::clamp(least + (largest - least) * (float(uint32_t(random())) * 0x1p-32f), least, largest));
    for (const float depth : depths) {
        const uint at = gnoClusterSliceOf(depth);
        if (at + 1 >= slices.size()) return "no such slice";
        const bool last = at + 2 == slices.size();
        if (!(slices[at] <= depth) || !(last ? depth <= slices[at + 1] : depth < slices[at + 1]))
            return "depth " + std::to_string(depth) + " is not in slice " + std::to_string(at);
    }
    return "";
}

TEST(ClusterSlices, HoldEveryDepth) {
    std::mt19937 random(kSeed);
    const auto real = [&] { return float(uint32_t(random())) * 0x1p-32f; };
    for (int round = 0; round < 3000; ++round) {
        const float a = std::ldexp(real() + 0.5f, -int(random() % 24)) * (random() % 6 == 0 ? -1.0f : 1.0f);
        const float b = random() % 8 == 0 ? a : std::ldexp(real() + 0.5f, 2 - int(random() % 20)) * (random() % 6 == 0 ? -1.0f : 1.0f);
        const uvec2 size(1 + random() % 2048, 1 + random() % 2048);
        const uint form = kForms[random() % 3];
        useSlices(size, form, 0.01f + 2.0f * real(), random() % 4 != 0, std::min(a, b), std::max(a, b));
        ASSERT_EQ(sliceFault(std::min(a, b), std::max(a, b), random), "") << "seed " << kSeed << " round " << round;
    }
}

TEST(ClusterSlices, RatioOfEquationOne) {
    useSlices({1024, 1024}, GNO_CLUSTER_IMPLICIT, 0.5f, true, 0.25f, 1.5f);
    const double ratio = 1.0 + 2.0 * 0.5 / 128;  // 1 + 2 tan(half field of view) / tiles in height
    uint full = 0;
    while (slices[full + 1] < 1.5f) {
        EXPECT_NEAR(slices[full + 1] / double(slices[full]), ratio, 1e-5) << full;
        ++full;
    }
    EXPECT_EQ(full, uint(std::log(6.0) / std::log(ratio)));
    EXPECT_LT(full, 300u) << "511 slices are not all needed";
}

TEST(ClusterSlices, CoarserWhereThereAreTooFew) {
    useSlices({64, 64}, GNO_CLUSTER_IMPLICIT, 0.02f, true, 0.01f, 4.0f);  // 32 slices; equation 1 alone would take 1201
    for (uint i = 0; i < 32; ++i) EXPECT_NEAR(slices[i + 1] / double(slices[i]), std::pow(400.0, 1.0 / 32), 1e-4) << i;
}

TEST(ClusterSlices, NearAndFarMillionfold) {
    useSlices({1024, 1024}, GNO_CLUSTER_IMPLICIT, 0.5f, true, 4e-6f, 4.0f);
    EXPECT_EQ(gnoClusterSliceOf(4e-6f), 0u);
    EXPECT_EQ(gnoClusterSliceOf(4.0f * 0x1p-16f), 0u) << "2^-16 of the farthest: all in slice 0";
    EXPECT_GT(gnoClusterSliceOf(4.0f * 0x1.2p-16f), 0u);
    EXPECT_GT(gnoClusterSliceOf(3.9f), gnoClusterSliceOf(2.0f) + 25u);
}

TEST(ClusterSlices, Orthographic) {
    useSlices({512, 512}, GNO_CLUSTER_IMPLICIT, 1.0f, false, -1.0f, 1.0f);
    for (uint i = 0; i < 64; ++i) EXPECT_NEAR(slices[i + 1] - slices[i], 2.0 / 64, 1e-6) << "as deep as a tile is high";
    EXPECT_EQ(slices[65], 1.0f);
    useSlices({512, 512}, GNO_CLUSTER_IMPLICIT, 0.001f, false, -1.0f, 1.0f);
    for (uint i = 0; i < 256; ++i) EXPECT_NEAR(slices[i + 1] - slices[i], 2.0 / 256, 1e-6) << "or deeper";
}

TEST(ClusterSlices, OneDepthOrAllBehindTheViewer) {
    for (const float depth : {0.5f, 0.0f, -0.5f}) {
        useSlices({512, 512}, GNO_CLUSTER_COMPACT, 0.5f, true, depth, depth);
        for (const float start : slices) EXPECT_EQ(start, depth);
    }
    useSlices({512, 512}, GNO_CLUSTER_COMPACT, 0.5f, true, -1.0f, -0.25f);
    EXPECT_EQ(gnoClusterSliceOf(-1.0f), 0u);
    EXPECT_EQ(gnoClusterSliceOf(-0.5f), 0u) << "one slice for all of them";
}

}  // namespace
}  // namespace gno
