// SPDX-License-Identifier: MIT
// Holds a light-space hierarchy (glsl/rivals/light_bvh.h) against what it has to be: every node below one parent, bounds that are the unions of what
// is below them, every caster once a face and with its facing, full nodes above inner ones.
#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "glsl/rivals/light_bvh.h"
#include "host_min/scene/scene.hpp"
#include "validation/support/exact_reference.hpp"

namespace gno::test {

inline int lightBvhFacing(const host::Triangle& t, glm::vec4 light) {
    return exact::orient3dLight(light, exact::fixed(t.a), exact::fixed(t.b), exact::fixed(t.c));
}

struct LightBvhBox {
    uint32_t x0 = 65535, y0 = 65535, x1 = 0, y1 = 0;
    float least = 3e38f;
    [[nodiscard]] bool holds(const LightBvhBox& other) const {
        return x0 <= other.x0 && y0 <= other.y0 && x1 >= other.x1 && y1 >= other.y1 && least <= other.least;
    }
    [[nodiscard]] bool holds(glm::uvec2 at) const { return at.x >= x0 && at.x <= x1 && at.y >= y0 && at.y <= y1; }
    void add(const LightBvhBox& other) {
        *this = {std::min(x0, other.x0), std::min(y0, other.y0), std::max(x1, other.x1), std::max(y1, other.y1), std::min(least, other.least)};
    }
};

inline LightBvhBox lightBvhBox(const GnoLightBvhNode& node, int child) {
    return {node.low[child] & 0xFFFF, node.low[child] >> 16, node.high[child] & 0xFFFF, node.high[child] >> 16, node.least[child]};
}

/// Goes through all nodes below the roots, once.
struct LightBvhWalk {
    const std::vector<host::Triangle>& triangles;
    glm::vec4 light;
    std::map<std::pair<uint32_t, uint32_t>, LightBvhBox> leaves{};  ///< by face and caster
    std::vector<GnoLightBvhNode> nodes{};
    std::vector<uint32_t> parents{};
    std::vector<int> visits{};
    std::string error{};  ///< the first thing that is wrong; empty: nothing

    void say(const std::string& what, uint32_t node) {
        if (error.empty()) error = fmt::format("{}, node {}", what, node);
    }
    /// The union of what is below the node.
    LightBvhBox below(uint32_t face, uint32_t index) {
        LightBvhBox all;
        if (index >= nodes.size() || visits[index]++ > 0) {
            say("a link out of range, or a node that is met twice", index);
            return all;
        }
        int children = 0, inner = 0;
        for (int c = 0; c < 4; ++c) {
            const uint32_t link = nodes[index].link[c];
            if (link == GNO_LIGHT_BVH_NONE) continue;
            if (children++ != c) say("a gap among the children", index);
            const LightBvhBox box = lightBvhBox(nodes[index], c);
            all.add(box);
            if ((link & GNO_LIGHT_BVH_LEAF) == 0) {
                ++inner;
                if (link < parents.size() && parents[link] != 4 * index + uint32_t(c)) say("a wrong parent", link);
                const LightBvhBox real = below(face, link);
                if (!box.holds(real)) say("a child's bounds lack something below it", index);
                if (!real.holds(box)) say("a child's bounds are wider than what is below it", index);
                continue;
            }
            const uint32_t caster = link & GNO_LIGHT_BVH_CASTER;
            if (caster >= triangles.size() || !leaves.emplace(std::pair(face, caster), box).second)
                say("a leaf that is there twice", index);
            else if (lightBvhFacing(triangles[caster], light) != ((link & GNO_LIGHT_BVH_POSITIVE) != 0 ? 1 : -1))
                say("a leaf with a wrong facing", index);
        }
        if (children < 4 && inner > 0) say("an inner child where there was room for its own children", index);
        if (children == 0) say("no children", index);
        return all;
    }
    /// From all faces' roots; returns the number of nodes.
    uint64_t all(std::span<const uint32_t> roots) {
        visits.assign(nodes.size(), 0);
        for (uint32_t face = 0; face < roots.size(); ++face) {
            const uint32_t root = roots[face];
            if (root == GNO_LIGHT_BVH_NONE) continue;
            below(face, root);
            if (root < parents.size() && parents[root] != GNO_LIGHT_BVH_NONE) say("a root with a parent", root);
        }
        return uint64_t(std::count(visits.begin(), visits.end(), 1));
    }
};

}  // namespace gno::test
