// SPDX-License-Identifier: MIT
#include "viz/cluster_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "host_min/error.hpp"

namespace gno::viz {
namespace {

using host::InputError;

/// The bits of `key` at the mask's set bits, lowest first.
uint32_t extract(uint32_t key, uint32_t mask) {
    uint32_t result = 0;
    for (uint32_t i = 0; mask != 0; ++i, mask &= mask - 1)
        if ((key & mask & (~mask + 1)) != 0) result |= 1u << i;
    return result;
}

/// Bounds by box index: three numbers a box, or the least and largest depth of a tile's samples.
struct Bounds {
    std::vector<glm::vec3> low, high;
    std::vector<float> nearest, farthest;
    std::vector<glm::uvec2> pointers;
};

Bounds boundsOf(const Dump& dump, const GnoClusterLayout& layout) {
    Bounds bounds;
    if (layout.form == GNO_CLUSTER_FLAT) {
        bounds.nearest = dump.read<float>("low", gnoClusterNodeCount(layout));
        bounds.farthest = dump.read<float>("high", gnoClusterNodeCount(layout));
    } else if (layout.form != GNO_CLUSTER_IMPLICIT) {
        bounds.low = dump.read<glm::vec3>("low");
        bounds.high = dump.read<glm::vec3>("high", bounds.low.size());
        if (layout.form == GNO_CLUSTER_COMPACT) bounds.pointers = dump.read<glm::uvec2>("pointers", gnoClusterWordCount(layout));
    }
    return bounds;
}

void setBounds(ClusterNode& node, const Bounds& bounds, const GnoClusterLayout& layout) {
    size_t index = size_t(gnoClusterFirstNode(layout, node.level)) + node.key;
    if (layout.form == GNO_CLUSTER_FLAT) {
        node.low.z = bounds.nearest[index];
        node.high.z = bounds.farthest[index];
        return;
    }
    if (layout.form == GNO_CLUSTER_COMPACT) {
        const glm::uvec2 pointer = bounds.pointers[gnoClusterWord(layout, node.level - 1, node.key >> 5)];
        if (pointer.x == GNO_CLUSTER_NONE) return;
        index = pointer.x + size_t(std::popcount(pointer.y & ((1u << (node.key & 31u)) - 1u)));
    }
    if (index >= bounds.low.size()) return;  // the list of boxes was full, or there are none
    node.low = bounds.low[index];
    node.high = bounds.high[index];
    node.boxed = node.low.x <= node.high.x;  // else a word below it has no boxes
}

}  // namespace

ClusterTree ClusterTree::read(const Dump& dump) {
    if (!dump.has("masks_built") || !dump.has("frame"))
        throw InputError(
            fmt::format("{}: technique {} has no cluster hierarchy; make the dump with ptsv or ptsv-2011", dump.name(), dump.technique()));
    struct Head {
        GnoClusterFrame frame;
        GnoClusterLayout layout;
    };
    ClusterTree tree;
    const Head head = dump.read<Head>("frame", 1).front();
    tree.frame = head.frame;
    tree.layout = head.layout;
    const GnoClusterLayout expected = gnoClusterLayout({dump.width(), dump.height()}, tree.layout.form);
    if (tree.layout.form > GNO_CLUSTER_FLAT || std::memcmp(&expected, &tree.layout, sizeof expected) != 0)
        throw InputError(fmt::format("{}: its layout is not that of {}x{}", dump.name(), dump.width(), dump.height()));
    const auto built = dump.read<uint32_t>("masks_built", gnoClusterWordCount(tree.layout)), left = dump.read<uint32_t>("masks", built.size());
    tree.slices = dump.read<float>("slices", gnoClusterSlices(tree.layout) + 1);
    const Bounds bounds = boundsOf(dump, tree.layout);

    tree.occupied.assign(tree.layout.levels + 1, 0);
    tree.accepted.assign(tree.layout.levels + 1, 0);
    std::vector<uint32_t> parents{0}, next;
    for (uint32_t level = 1; level <= tree.layout.levels; ++level, parents = std::move(next)) {
        next.clear();
        for (const uint32_t parent : parents) {
            const uint32_t word = gnoClusterWord(tree.layout, level - 1, parent);
            if (built[word] == 0 && level > 1)
                throw InputError(
                    fmt::format("{}: the hierarchy is broken: node {} of level {} is occupied but empty", dump.name(), parent, level - 1));
            if ((left[word] & ~built[word]) != 0) throw InputError(fmt::format("{}: the traversal left a node that was not there", dump.name()));
            for (uint32_t bits = built[word]; bits != 0; bits &= bits - 1) {
                const uint32_t child = uint32_t(std::countr_zero(bits));
                ClusterNode node{level, (parent << 5) | child, (left[word] >> child & 1u) == 0};
                setBounds(node, bounds, tree.layout);
                ++tree.occupied[level];
                tree.accepted[level] += node.accepted;
                next.push_back(node.key);
                tree.nodes.push_back(node);
            }
        }
    }
    return tree;
}

std::array<glm::dvec3, 8> ClusterTree::cellOf(const ClusterNode& node) const {
    const uint32_t shift = 5 * (layout.levels - node.level), first = node.key << shift, last = first | ((1u << shift) - 1);
    const glm::uvec2 from(extract(first, layout.maskX), extract(first, layout.maskY)),
        to(extract(last, layout.maskX) + 1, extract(last, layout.maskY) + 1);
    glm::dvec2 depth(node.low.z, node.high.z);  // flat
    if (layout.form != GNO_CLUSTER_FLAT) depth = {slices[extract(first, layout.maskZ)], slices[extract(last, layout.maskZ) + 1]};
    const double tileHeight = gnoClusterTileHeight(layout);
    std::array<glm::dvec3, 8> corners;
    for (size_t i = 0; i < 8; ++i) {
        const glm::dvec2 pixel(std::min<double>(frame.size.x, (i & 1 ? to.x : from.x) * double(GNO_CLUSTER_TILE)),
                               std::min<double>(frame.size.y, (i & 2 ? to.y : from.y) * tileHeight));
        const glm::dvec2 slope = (2.0 * pixel / glm::dvec2(frame.size) - 1.0) * glm::dvec2(frame.right.w, frame.down.w);
        const double away = i & 4 ? depth.y : depth.x, spread = frame.origin.w != 0 ? away : 1;
        corners[i] = glm::dvec3(frame.origin) + glm::dvec3(frame.forward) * away +
                     spread * (slope.x * glm::dvec3(frame.right) + slope.y * glm::dvec3(frame.down));
    }
    return corners;
}

}  // namespace gno::viz
