// SPDX-License-Identifier: MIT
// For which triangles is front-face culling legal? Let w be a mesh's winding number at a point: 0 outside, +1 inside of a closed mesh with
// outward normals. On the way from the light L to a point p, every front face (seen from the light) adds one to w and every back face takes one
// away, so (front crossings) - (back crossings) = w(p) - w(L). If w(p) <= w(L), a way that crosses anything crosses a back face, and the front
// faces may go. A sample that a camera outside the solid sees has w(p) = 0, and outward normals give w(L) >= 0: legal wherever the light is.
// An inside-out mesh has w(L) = -1 for a light inside, and culling would light what lies outside: not legal.
//
// Judged per mesh instance, its vertices welded by position, and per part connected by edges. A part is closed when
//   - after triangles with two equal vertices have gone (they bound nothing), each of its edges belongs to exactly two triangles, once in each
//     direction. Triangles of three different collinear points stay: they have no area, but without them a T-joint's edges would not match;
//   - and its signed volume is positive. A part that crosses itself so that w is negative somewhere is not recognised.
#include <algorithm>
#include <numeric>

#include "host_min/scene/triangles.hpp"

namespace gno::host {

namespace {

// Parts of a mesh: union-find over triangles, each with what is known about its part.
class Parts {
public:
    explicit Parts(size_t triangles) : parent_(triangles), open_(triangles, 0) { std::iota(parent_.begin(), parent_.end(), 0u); }

    uint32_t root(uint32_t triangle) {
        while (parent_[triangle] != triangle) triangle = parent_[triangle] = parent_[parent_[triangle]];
        return triangle;
    }
    void join(uint32_t one, uint32_t other) { parent_[root(one)] = root(other); }
    void markOpen(uint32_t triangle) { open_[triangle] = 1; }
    void spread() {  // a part is open when one of its triangles is
        for (uint32_t i = 0; i < parent_.size(); ++i)
            if (open_[i]) open_[root(i)] = 1;
    }
    bool isOpen(uint32_t root_) const { return open_[root_] != 0; }

private:
    std::vector<uint32_t> parent_;
    std::vector<uint8_t> open_;
};

struct HalfEdge {
    uint32_t end;  // its larger point
    uint32_t triangle;
    bool rising;  // runs from its smaller to its larger point
};

bool hasEqualPoints(glm::uvec3 t) { return t.x == t.y || t.y == t.z || t.z == t.x; }

// All half edges, those with the same smaller point p in [start[p], start[p + 1]).
std::vector<HalfEdge> sortedByPoint(std::span<const glm::uvec3> triangles, size_t pointCount, std::vector<uint32_t>& start) {
    start.assign(pointCount + 2, 0);
    const auto forEach = [&](auto&& use) {
        for (uint32_t i = 0; i < triangles.size(); ++i) {
            const glm::uvec3 t = triangles[i];
            if (hasEqualPoints(t)) continue;
            for (int corner = 0; corner < 3; ++corner) use(i, t[corner], t[(corner + 1) % 3]);
        }
    };
    forEach([&](uint32_t, uint32_t from, uint32_t to) { ++start[std::min(from, to) + 2]; });
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<HalfEdge> edges(start.back());
    forEach([&](uint32_t i, uint32_t from, uint32_t to) { edges[start[std::min(from, to) + 1]++] = {std::max(from, to), i, from < to}; });
    return edges;
}

void joinAtEdges(std::vector<HalfEdge>& edges, const std::vector<uint32_t>& start, Parts& parts) {
    for (size_t point = 0; point + 1 < start.size(); ++point) {
        const auto last = edges.begin() + start[point + 1];
        auto first = edges.begin() + start[point];
        std::sort(first, last, [](const HalfEdge& a, const HalfEdge& b) { return a.end < b.end; });
        while (first != last) {
            const auto next = std::find_if(first, last, [&](const HalfEdge& edge) { return edge.end != first->end; });
            const bool matched = next - first == 2 && first->rising != (first + 1)->rising;
            for (auto edge = first; edge != next; ++edge) {
                parts.join(first->triangle, edge->triangle);
                if (!matched) parts.markOpen(edge->triangle);
            }
            first = next;
        }
    }
}

}  // namespace

std::vector<uint8_t> closedTriangles(const std::vector<glm::vec3>& points, std::span<const glm::uvec3> triangles) {
    Parts parts(triangles.size());
    std::vector<uint32_t> start;
    std::vector<HalfEdge> edges = sortedByPoint(triangles, points.size(), start);
    joinAtEdges(edges, start, parts);
    parts.spread();

    constexpr double kNoise = 1e-12;  // far above the rounding of the sums below
    std::vector<double> volume(triangles.size(), 0.0), size(triangles.size(), 0.0);
    for (uint32_t i = 0; i < triangles.size(); ++i) {
        const uint32_t root = parts.root(i);
        const glm::dvec3 origin(points[triangles[root].x]);
        const glm::uvec3 t = triangles[i];
        const glm::dvec3 a = glm::dvec3(points[t.x]) - origin, b = glm::dvec3(points[t.y]) - origin, c = glm::dvec3(points[t.z]) - origin;
        const double six = glm::dot(a, glm::cross(b, c));
        volume[root] += six;
        size[root] += std::abs(six);
    }
    std::vector<uint8_t> closed(triangles.size(), 0);
    for (uint32_t i = 0; i < triangles.size(); ++i) {
        const uint32_t root = parts.root(i);
        closed[i] = !parts.isOpen(root) && volume[root] > kNoise * size[root] && !hasEqualPoints(triangles[i]);
    }
    return closed;
}

}  // namespace gno::host
