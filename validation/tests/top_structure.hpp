// SPDX-License-Identifier: MIT
// A TOP tree read back from the device, and what must be true of any one, whatever the insertion order. Recomputed in double from the casters;
// nothing here calls the modules.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string>
#include <vector>

#include "host_min/techniques/top_tree.hpp"
#include "validation/support/exact_reference.hpp"

namespace gno::test {

struct TopBuffers {
    std::vector<glm::vec4> planes;
    std::vector<GnoTopLink> links;
    GnoTopHeader header{};

    /// Bit for bit.
    [[nodiscard]] bool operator==(const TopBuffers& other) const { return bytes() == other.bytes(); }
    [[nodiscard]] std::vector<std::byte> bytes() const {
        std::vector<std::byte> all;
        const auto append = [&](auto span) { all.insert(all.end(), span.begin(), span.end()); };
        append(std::as_bytes(std::span(planes)));
        append(std::as_bytes(std::span(links)));
        append(std::as_bytes(std::span(&header, 1)).first(8));  // what follows is unused
        return all;
    }
};

inline TopBuffers download(const host::TopTree& tree) {
    return {tree.planes().downloadAs<glm::vec4>(), tree.links().downloadAs<GnoTopLink>(), tree.header().downloadAs<GnoTopHeader>().front()};
}

/// What the walk through a tree found; `error` is empty when the links make a tree.
struct TopWalk {
    std::string error;
    std::vector<uint32_t> order;     ///< casters in it, parents before children
    std::vector<uint32_t> parent;    ///< per caster: the node that links to it, GNO_TOP_NONE for the root and for what is not in the tree
    std::vector<uint8_t> reached;    ///< per caster
    std::vector<uint32_t> ancestor;  ///< per caster: the node whose intersection subtree it stands in, by the walk
};

/// `kept`: one flag per caster, 1 where it must be in the tree or inside another's volume.
inline TopWalk walk(const TopBuffers& tree, const std::vector<uint8_t>& kept) {
    const uint32_t count = uint32_t(kept.size());
    TopWalk result{{}, {}, std::vector<uint32_t>(count, GNO_TOP_NONE), std::vector<uint8_t>(count, 0), std::vector<uint32_t>(count, GNO_TOP_NONE)};
    struct Step {
        uint32_t node, parent, ancestor;
    };
    std::vector<Step> steps;
    if (tree.header.root != GNO_TOP_NONE) steps.push_back({tree.header.root, GNO_TOP_NONE, GNO_TOP_NONE});
    const auto say = [&](const std::string& what, uint32_t node) {
        if (result.error.empty()) result.error = what + ", node " + std::to_string(node);
    };
    if (tree.header.casterCount != count) say("the header has another number of casters", tree.header.casterCount);
    while (!steps.empty() && result.error.empty()) {
        const Step step = steps.back();
        steps.pop_back();
        const uint32_t caster = step.node / 4;
        if (step.node % 4 != 0 || caster >= count) {
            say("a link that is no volume's first node", step.node);
            break;
        }
        if (result.reached[caster]) say("a caster that is there twice", step.node);
        if (!kept[caster]) say("a caster that was left out", step.node);
        if (tree.links[step.node + 1].aux != step.ancestor) say("a wrong ancestor link", step.node);
        result.reached[caster] = 1;
        result.parent[caster] = step.parent;
        result.ancestor[caster] = step.ancestor;
        result.order.push_back(caster);
        for (uint32_t node = step.node; node < step.node + 4; ++node) {
            if (tree.links[node].positiveChild != GNO_TOP_NONE) steps.push_back({tree.links[node].positiveChild, node, step.ancestor});
            if (tree.links[node].intersectionChild != GNO_TOP_NONE) steps.push_back({tree.links[node].intersectionChild, node, node});
        }
    }
    for (uint32_t caster = 0; caster < count && result.error.empty(); ++caster) {
        if (result.reached[caster]) continue;
        for (uint32_t node = 4 * caster; node < 4 * caster + 4; ++node)
            if (tree.links[node].positiveChild != GNO_TOP_NONE || tree.links[node].intersectionChild != GNO_TOP_NONE)
                say("children below a caster that is not in the tree", node);
    }
    return result;
}

/// Distance of the nearest point of a triangle from a point light at the origin of `v`, or the least depth along a direction; in double.
inline double exactDepth(const std::array<glm::dvec3, 3>& v, glm::vec4 light) {
    if (light.w == 0) {
        const glm::dvec3 d(light);
        return 4 - std::max({glm::dot(d, v[0]), glm::dot(d, v[1]), glm::dot(d, v[2])});
    }
    double least = std::min({glm::length(v[0]), glm::length(v[1]), glm::length(v[2])});
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 e = v[(i + 1) % 3] - v[i];
        const double along = std::clamp(-glm::dot(v[i], e) / std::max(glm::dot(e, e), 1e-300), 0.0, 1.0);
        least = std::min(least, glm::length(v[i] + along * e));
    }
    const glm::dvec3 n = glm::cross(v[1] - v[0], v[2] - v[0]);
    const double area = glm::dot(n, n);
    bool inside = area > 0;
    for (int i = 0; i < 3 && inside; ++i) inside = glm::dot(glm::cross(v[(i + 1) % 3] - v[i], -v[i]), n) >= 0;
    if (inside) least = std::min(least, std::abs(glm::dot(n, v[0])) / std::sqrt(area));
    return least;
}

inline std::array<glm::dvec3, 3> fromLight(const host::Triangle& t, glm::vec4 light) {
    const glm::dvec3 origin = light.w == 0 ? glm::dvec3(0) : glm::dvec3(light);
    return {glm::dvec3(t.a) - origin, glm::dvec3(t.b) - origin, glm::dvec3(t.c) - origin};
}

/// Would a query whose point has this side and scale at a lateral plane go into the node's intersection child? `halves`: the word holds one bound
/// per side.
inline bool wedgeAdmits(const GnoTopLink& link, double side, double scale, bool halves) {
    const uint32_t bits = !halves ? link.wedge : side > 0 ? link.wedge & 0xFFFF0000u : link.wedge << 16;
    return std::abs(side) <= double(std::bit_cast<float>(bits)) * scale;
}

/// Bounds of every node against every caster below it. `bulge`: also between the vertices (`published` promises the vertices only, up to `slack`).
inline std::string checkBounds(const TopBuffers& tree, const TopWalk& walked, std::span<const host::Triangle> casters, glm::vec4 light, bool bulge,
                               double slack) {
    constexpr int kSteps = 4;  // points per edge of the barycentric lattice
    std::vector<glm::dvec3> weights{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int i = 0; i <= kSteps && bulge; ++i)
        for (int j = 0; i + j <= kSteps; ++j) weights.emplace_back(i / double(kSteps), j / double(kSteps), (kSteps - i - j) / double(kSteps));
    for (const uint32_t caster : walked.order) {
        const auto v = fromLight(casters[caster], light);
        const double depth = exactDepth(v, light);
        std::vector<glm::dvec3> points;
        for (const glm::dvec3 w : weights) {
            const glm::dvec3 q = w.x * v[0] + w.y * v[1] + w.z * v[2];
            points.push_back(q);
            if (light.w == 0 && bulge)
                for (const double mu : {0.5, 1.0}) points.push_back(q - mu * glm::normalize(glm::dvec3(light)));
        }
        const auto leastOf = [&](uint32_t volume) { return double(std::bit_cast<float>(tree.links[4 * volume].aux)); };
        if (!(leastOf(caster) >= 0) || leastOf(caster) > depth * (1 + slack) + slack)
            return "least depth of volume " + std::to_string(caster) + " is beyond its own caster";
        uint32_t below = caster;
        for (uint32_t node = walked.parent[caster]; node != GNO_TOP_NONE; node = walked.parent[below]) {
            const uint32_t volume = node / 4;
            if (leastOf(volume) > leastOf(below))
                return "least depth of volume " + std::to_string(volume) + " is beyond that of volume " + std::to_string(below);
            const bool intersection = tree.links[node].intersectionChild == 4 * below;
            below = volume;
            if (!intersection || node % 4 == 3) continue;
            const glm::dvec4 plane(tree.planes[node]);
            for (const glm::dvec3 q : points) {
                const double scale = light.w == 0 ? double(1.75f) : glm::length(q);
                const double side = glm::dot(glm::dvec3(plane), q) + plane.w;
                if (std::abs(side) > slack * scale && !wedgeAdmits(tree.links[node], side - std::copysign(slack * scale, side), scale, bulge))
                    return "the wedge of node " + std::to_string(node) + " leaves out a part of caster " + std::to_string(caster);
            }
        }
    }
    return {};
}

}  // namespace gno::test
