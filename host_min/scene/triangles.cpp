// SPDX-License-Identifier: MIT
#include "host_min/scene/triangles.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace gno::host {

namespace {

constexpr uint32_t kEmpty = std::numeric_limits<uint32_t>::max();

uint64_t mixed(uint64_t hash, uint64_t value) {
    hash = (hash ^ value) * 0x9E3779B97F4A7C15ull;
    return hash ^ hash >> 32;
}

uint64_t hashed(uint64_t hash, glm::vec3 p) {
    hash = mixed(hash, std::bit_cast<uint32_t>(p.x) | uint64_t{std::bit_cast<uint32_t>(p.y)} << 32);
    return mixed(hash, std::bit_cast<uint32_t>(p.z));
}

bool isBefore(glm::vec3 a, glm::vec3 b) { return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z; }

Triangle sorted(Triangle t) {
    if (isBefore(t.b, t.a)) std::swap(t.a, t.b);
    if (isBefore(t.c, t.b)) std::swap(t.b, t.c);
    if (isBefore(t.b, t.a)) std::swap(t.a, t.b);
    return t;
}

// Whether p * s = q * r. On the grid, differences of coordinates are exact in double and multiples of 2^-40 below 2^2.
bool productsEqual(double p, double s, double q, double r) {
    const double left = p * s, right = q * r;
    if (std::abs(left - right) > 0x1p-50 * (std::abs(left) + std::abs(right))) return false;  // more than both roundings
    const auto whole = [](double value) { return static_cast<__int128>(std::ldexp(value, kGridBits)); };
    return whole(p) * whole(s) == whole(q) * whole(r);
}

}  // namespace

bool isCollinear(const Triangle& t) {
    const glm::dvec3 e = glm::dvec3(t.b) - glm::dvec3(t.a), f = glm::dvec3(t.c) - glm::dvec3(t.a);
    return productsEqual(e.y, f.z, e.z, f.y) && productsEqual(e.z, f.x, e.x, f.z) && productsEqual(e.x, f.y, e.y, f.x);
}

uint64_t countDuplicates(std::span<const Triangle> triangles) {
    struct Entry {
        uint32_t triangle = kEmpty, tag = 0;
    };
    std::vector<Entry> table(std::bit_ceil(triangles.size() * 2 + 1));
    const size_t mask = table.size() - 1;
    uint64_t duplicates = 0;
    for (uint32_t i = 0; i < triangles.size(); ++i) {
        const Triangle key = sorted(triangles[i]);
        const uint64_t hash = hashed(hashed(hashed(0, key.a), key.b), key.c);
        const auto tag = static_cast<uint32_t>(hash >> 32);
        for (size_t slot = hash & mask;; slot = (slot + 1) & mask) {
            Entry& entry = table[slot];
            if (entry.triangle == kEmpty) {
                entry = {i, tag};
                break;
            }
            if (entry.tag != tag) continue;
            const Triangle other = sorted(triangles[entry.triangle]);
            if (other.a == key.a && other.b == key.b && other.c == key.c) {
                ++duplicates;
                break;
            }
        }
    }
    return duplicates;
}

void PointWelder::reset(size_t mostPoints) {
    table_.assign(std::bit_ceil(mostPoints * 2 + 1), kEmpty);
    points_.clear();
    points_.reserve(mostPoints);
}

uint32_t PointWelder::number(glm::vec3 position) {
    const size_t mask = table_.size() - 1;
    for (size_t slot = hashed(0, position) & mask;; slot = (slot + 1) & mask) {
        uint32_t& entry = table_[slot];
        if (entry == kEmpty) {
            entry = static_cast<uint32_t>(points_.size());
            points_.push_back(position);
            return entry;
        }
        if (points_[entry] == position) return entry;
    }
}

}  // namespace gno::host
