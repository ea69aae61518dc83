// SPDX-License-Identifier: MIT
#include "validation/oracle/caster_tree.hpp"

#include <algorithm>
#include <array>

namespace gno::host::oracle {

namespace {

struct Box {
    glm::vec3 low{std::numeric_limits<float>::max()}, high{std::numeric_limits<float>::lowest()};

    void add(const Box& other) {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
    // Half the surface: a choice of split, not a decision, so rounding does not matter.
    [[nodiscard]] float area() const {
        const glm::vec3 e = high - low;
        return e.x * e.y + e.y * e.z + e.z * e.x;
    }
};

struct Entry {
    Box box;
    uint32_t caster;
    [[nodiscard]] glm::vec3 middle() const { return 0.5f * (box.low + box.high); }
};

constexpr uint32_t kLeaf = 4;
constexpr uint32_t kBins = 16;
constexpr uint32_t kProgressStep = 1u << 16;

}  // namespace

struct CasterTree::Builder {
    CasterTree& tree;
    std::vector<Entry> entries;
    const std::function<void(double)>& progress;
    uint32_t reported = 0;

    // A node over entries [begin, end), and everything below it.
    void build(uint32_t begin, uint32_t end, uint32_t depth) {
        Box box, middles;
        for (uint32_t i = begin; i < end; ++i) {
            box.add(entries[i].box);
            middles.add({entries[i].middle(), entries[i].middle()});
        }
        const auto index = uint32_t(tree.nodes_.size());
        tree.nodes_.push_back({{box.low.x, box.low.y, box.low.z}, {box.high.x, box.high.y, box.high.z}, begin, end - begin});
        if (end - begin <= kLeaf) return report(end);
        const uint32_t split = depth < kBinnedDepth ? binnedSplit(begin, end, middles) : (begin + end) / 2;
        build(begin, split, depth + 1);
        tree.nodes_[index].first = uint32_t(tree.nodes_.size());
        tree.nodes_[index].count = 0;
        build(split, end, depth + 1);
    }

    // The split with the least expected cost (surface area heuristic) along the longest axis of the boxes' middles. Both sides get entries.
    uint32_t binnedSplit(uint32_t begin, uint32_t end, const Box& middles) {
        const glm::vec3 extent = middles.high - middles.low;
        const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
        if (!(extent[axis] > 0)) return (begin + end) / 2;
        const float perBin = float(kBins) / extent[axis];
        const auto binOf = [&](const Entry& e) { return std::min(uint32_t((e.middle()[axis] - middles.low[axis]) * perBin), kBins - 1); };

        std::array<Box, kBins> boxes;
        std::array<uint32_t, kBins> counts{};
        for (uint32_t i = begin; i < end; ++i) {
            boxes[binOf(entries[i])].add(entries[i].box);
            ++counts[binOf(entries[i])];
        }
        std::array<float, kBins> lowCost{};  // of bins [0, b)
        Box low, high;
        uint32_t lowCount = 0, highCount = 0;
        for (uint32_t b = 1; b < kBins; ++b) {
            low.add(boxes[b - 1]);
            lowCost[b] = low.area() * float(lowCount += counts[b - 1]);
        }
        uint32_t best = 0;
        float bestCost = std::numeric_limits<float>::max();
        for (uint32_t b = kBins - 1; b > 0; --b) {
            high.add(boxes[b]);
            highCount += counts[b];
            if (highCount == 0 || highCount == end - begin) continue;
            const float cost = lowCost[b] + high.area() * float(highCount);
            if (cost < bestCost) {
                best = b;
                bestCost = cost;
            }
        }
        if (best == 0) return (begin + end) / 2;
        const auto middle = std::partition(entries.begin() + begin, entries.begin() + end, [&](const Entry& e) { return binOf(e) < best; });
        return uint32_t(middle - entries.begin());
    }

    void report(uint32_t done) {
        if (!progress || done - reported < kProgressStep) return;
        reported = done;
        progress(double(done) / double(entries.size()));
    }
};

CasterTree::CasterTree(std::span<const Triangle> triangles, std::span<const uint32_t> casters, const std::function<void(double)>& progress) {
    if (casters.empty()) return;
    Builder builder{*this, {}, progress};
    builder.entries.reserve(casters.size());
    for (const uint32_t i : casters) {
        const Triangle& t = triangles[i];
        builder.entries.push_back({{glm::min(t.a, glm::min(t.b, t.c)), glm::max(t.a, glm::max(t.b, t.c))}, i});
    }
    builder.build(0, uint32_t(casters.size()), 0);
    order_.reserve(casters.size());
    for (const Entry& e : builder.entries) order_.push_back(e.caster);
}

}  // namespace gno::host::oracle
