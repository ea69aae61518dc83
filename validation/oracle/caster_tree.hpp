// SPDX-License-Identifier: MIT
// A bounding volume hierarchy over casters, in double precision, that never loses a caster: the oracle asks it which casters a segment may meet.
//
// Why nothing is lost. Let q = p + t d be a point of a caster's box [lo, hi] with 0 < t < tMax; p, d, lo, hi are multiples of 2^-40, positions
// at most 2 in size, so d and the differences below are exact in double. A box is grown by g = 2^-41 on each side, which is half a grid unit:
// lo - g - p is exact and never zero. Per axis with d > 0 (d < 0 is the mirror image), the true t is at least (lo - p) / d, and the computed
// (lo - g - p) * inv with inv = fl(1 / d) is at most (lo - p) / d - g / d + e, where e <= 2.01 * 2^-53 * |lo - g - p| / d < 2^-49 / d < g / d.
// So the computed entry is below t and, likewise, the computed exit above it. With d = 0, inv is infinite: entry and exit are -inf and +inf
// when p is within the grown slab, and the slab is missed otherwise; 0 * inf cannot occur. |d| >= 2^-40 else, so nothing overflows. Hence a box
// that holds q is entered, and so are its ancestors' boxes, which are exact unions (minimum and maximum of fp32 numbers do not round).
#pragma once
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "host_min/scene/scene.hpp"

namespace gno::host::oracle {

/// The part of p + t d with 0 < t < tMax that a shadow ray has to look at.
class ShadowSegment {
public:
    /// From p to a point light (w = 1, tMax = 1), or from p along the direction towards the light (w = 0, endless).
    ShadowSegment(glm::vec3 p, glm::vec4 light);

    /// False only if the segment certainly misses the box.
    [[nodiscard]] bool mayMeet(const float (&low)[3], const float (&high)[3]) const;

private:
    double origin_[3], inverse_[3];
    double tMax_;
};

class CasterTree {
public:
    /// A tree over triangles[i], i in `casters`. The same input makes the same tree. `progress` is called now and then with a number in
    /// [0, 1] and may throw.
    CasterTree(std::span<const Triangle> triangles, std::span<const uint32_t> casters, const std::function<void(double)>& progress);

    /// Calls test(i) for a superset of the casters i that the segment meets, in an order that only the tree decides, until it returns true.
    /// True if one call did.
    template <class Test>
    bool any(const ShadowSegment& segment, Test&& test) const;

private:
    struct Node {
        float low[3], high[3];
        uint32_t first;  ///< leaf: first entry of order_; inner node: index of the second child (the first one follows its parent)
        uint32_t count;  ///< leaf: number of entries; 0: inner node
    };
    struct Builder;

    // Binned splits above this depth, halves below it: with 2^32 casters at most, no path is longer than kStack.
    static constexpr uint32_t kBinnedDepth = 60;
    static constexpr uint32_t kStack = kBinnedDepth + 34;

    std::vector<Node> nodes_;
    std::vector<uint32_t> order_;
};

template <class Test>
bool CasterTree::any(const ShadowSegment& segment, Test&& test) const {
    if (nodes_.empty()) return false;
    uint32_t stack[kStack];
    uint32_t depth = 0;
    stack[depth++] = 0;
    while (depth != 0) {
        const uint32_t index = stack[--depth];
        const Node& node = nodes_[index];
        if (!segment.mayMeet(node.low, node.high)) continue;
        if (node.count == 0) {
            stack[depth++] = node.first;
            stack[depth++] = index + 1;
            continue;
        }
        for (uint32_t i = 0; i < node.count; ++i) {
            if (test(order_[node.first + i])) return true;
        }
    }
    return false;
}

inline ShadowSegment::ShadowSegment(glm::vec3 p, glm::vec4 light) : tMax_(light.w != 0 ? 1.0 : std::numeric_limits<double>::max()) {
    for (int axis = 0; axis < 3; ++axis) {
        origin_[axis] = double(p[axis]);
        const double d = light.w != 0 ? double(light[axis]) - origin_[axis] : double(light[axis]);
        inverse_[axis] = d != 0 ? 1.0 / d : std::numeric_limits<double>::infinity();
    }
}

inline bool ShadowSegment::mayMeet(const float (&low)[3], const float (&high)[3]) const {
    constexpr double kGrow = 0x1p-41;
    double enter = 0, leave = tMax_;
    for (int axis = 0; axis < 3; ++axis) {
        const double toLow = (double(low[axis]) - kGrow - origin_[axis]) * inverse_[axis];
        const double toHigh = (double(high[axis]) + kGrow - origin_[axis]) * inverse_[axis];
        const double nearer = toLow < toHigh ? toLow : toHigh;
        const double farther = toLow < toHigh ? toHigh : toLow;
        enter = nearer > enter ? nearer : enter;
        leave = farther < leave ? farther : leave;
    }
    return enter <= leave;
}

}  // namespace gno::host::oracle
