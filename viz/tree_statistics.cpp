// SPDX-License-Identifier: MIT
#include "viz/tree_statistics.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace gno::viz {
namespace {

constexpr int kWedgeBins = 18;         // each twice as wide as the one before
constexpr double kSceneRadius = 1.75;  // GNO_SCENE_RADIUS of glsl/core/light.glsl

/// How wide the intersection child's volumes reach on both sides of the plane, as the device bounds it (top/plane.glsl, gnoTopWedge): sines, or for
/// a light at infinity distances over GNO_SCENE_RADIUS. Negative: no bound.
std::array<double, 2> wedgeOf(uint32_t wedge, bool published) {
    const auto bound = [](uint32_t bits) {
        const double value = std::bit_cast<float>(bits);
        return value < 1e29 ? value : -1.0;
    };
    if (published) return {bound(wedge), bound(wedge)};
    return {bound(wedge & 0xFFFF0000u), bound(wedge << 16)};
}

void addWedges(const Dump& dump, const TopTree& tree, TreeStatistics& result) {
    const bool atPoint = dump.light().w != 0;
    const double most = atPoint ? 180.0 : 2 * kSceneRadius * dump.metres();
    result.wedges = {"wedge", atPoint ? "degrees" : "m", {}, std::vector<uint64_t>(kWedgeBins, 0)};
    result.wedges.edges.push_back(0);
    for (int i = kWedgeBins - 1; i >= 0; --i) result.wedges.edges.push_back(std::ldexp(most, -i));
    for (const Volume& volume : tree.volumes)
        for (uint32_t place = 0; place < 3; ++place) {  // a cap's intersection child is entered without a test
            const GnoTopLink& link = tree.links[4 * volume.caster + place];
            if (link.intersectionChild == GNO_TOP_NONE) continue;
            double width = 0;
            bool bounded = true;
            for (const double side : wedgeOf(link.wedge, dump.precision() == "published")) {
                bounded = bounded && side >= 0 && (!atPoint || side < 1);
                width += atPoint ? glm::degrees(std::asin(std::clamp(side, 0.0, 1.0))) : side * kSceneRadius * dump.metres();
            }
            if (!bounded)
                ++result.wedgesWithoutBound;
            else
                ++result.wedges
                      .counts[size_t(std::clamp(kWedgeBins - 1 + int(std::floor(std::log2(std::max(width, 1e-30) / most))) + 1, 0, kWedgeBins - 1))];
        }
}

void addVisits(const TopTree& tree, TreeStatistics& result) {
    result.visitsOfNodes = {"visits of a node", "visits", {0}, {}};
    uint32_t most = 1;
    for (const Volume& volume : tree.volumes)
        for (uint32_t place = 0; place < 4; ++place) most = std::max(most, tree.visits[4 * volume.caster + place]);
    result.visitsOfNodes.counts.resize(size_t(std::bit_width(most)) + 1);
    for (size_t i = 0; i < result.visitsOfNodes.counts.size(); ++i) result.visitsOfNodes.edges.push_back(std::ldexp(1.0, int(i)));
    for (const Volume& volume : tree.volumes)
        for (uint32_t place = 0; place < 4; ++place) ++result.visitsOfNodes.counts[size_t(std::bit_width(tree.visits[4 * volume.caster + place]))];
}

nlohmann::ordered_json jsonOf(const Histogram& histogram) {
    return {{"unit", histogram.unit}, {"edges", histogram.edges}, {"counts", histogram.counts}};
}

}  // namespace

double TreeStatistics::intersectionShare() const {
    const uint64_t all = lateralPositive + capPositive + intersection;
    return all > 0 ? double(intersection) / double(all) : 0;
}

nlohmann::ordered_json TreeStatistics::json() const {
    return {{"casters", casters},
            {"volumes", volumes},
            {"links", {{"lateral_positive", lateralPositive}, {"cap_positive", capPositive}, {"intersection", intersection}}},
            {"intersection_share", intersectionShare()},
            {"mean_depth", meanDepth},
            {"deepest", deepest},
            {"samples", samples},
            {"visits", visits},
            {"volumes_at_depth", volumesAtDepth},
            {"visits_at_depth", visitsAtDepth},
            {"wedges", jsonOf(wedges)},
            {"wedges_without_bound", wedgesWithoutBound},
            {"visits_of_nodes", jsonOf(visitsOfNodes)}};
}

TreeStatistics statisticsOf(const Dump& dump, const TopTree& tree) {
    TreeStatistics result;
    result.casters = tree.casters;
    result.volumes = tree.volumes.size();
    result.samples = dump.record().value("samples", uint64_t(0));
    for (const Volume& volume : tree.volumes) {
        result.lateralPositive += volume.link == Link::lateralPositive;
        result.capPositive += volume.link == Link::capPositive;
        result.intersection += volume.link == Link::intersection;
        result.visits += volume.visits;
        result.meanDepth += volume.depth / double(tree.volumes.size());
        result.deepest = std::max(result.deepest, volume.depth);
    }
    result.volumesAtDepth.resize(result.deepest + 1);
    result.visitsAtDepth.resize(result.deepest + 1);
    for (const Volume& volume : tree.volumes) {
        ++result.volumesAtDepth[volume.depth];
        result.visitsAtDepth[volume.depth] += volume.visits;
    }
    addWedges(dump, tree, result);
    addVisits(tree, result);
    return result;
}

}  // namespace gno::viz
