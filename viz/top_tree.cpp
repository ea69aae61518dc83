// SPDX-License-Identifier: MIT
#include "viz/top_tree.hpp"

#include <fmt/format.h>

#include <bit>

#include "host_min/error.hpp"

namespace gno::viz {

using host::InputError;

TopTree TopTree::read(const Dump& dump) {
    if (!dump.has("planes") || !dump.has("links"))
        throw InputError(fmt::format("{}: technique {} has no TOP tree; make the dump with psv, d-psv, d-stackless or d-hybrid", dump.name(), dump.technique()));
    TopTree tree;
    tree.casters = dump.casterCount();
    tree.planes = dump.read<glm::vec4>("planes", 4 * tree.casters);
    tree.links = dump.read<GnoTopLink>("links", 4 * tree.casters);
    tree.visits = dump.read<uint32_t>("visits", 4 * tree.casters);
    tree.root = dump.read<GnoTopHeader>("header", 1).front().root;
    const double shift = dump.light().w == 0 ? 4.0 : 0.0;  // gnoLightDepth

    std::vector<char> isIn(tree.casters, 0);
    const auto add = [&](uint32_t node, uint32_t parent, Link link, uint32_t depth, uint32_t planesAbove) {
        if (node == GNO_TOP_NONE) return;
        const uint32_t caster = node / 4;
        if (node % 4 != 0 || caster >= tree.casters || isIn[caster])
            throw InputError(fmt::format("{}: the tree is broken: a link leads to node {}{}", dump.name(), node, caster < tree.casters && isIn[caster] ? " twice" : ""));
        isIn[caster] = 1;
        Volume volume{caster, parent, link, depth, planesAbove};
        volume.leastDistance = float((double(std::bit_cast<float>(tree.links[node].aux)) - shift) * dump.metres());
        for (uint32_t place = 0; place < 4; ++place) volume.visits += tree.visits[node + place];
        tree.volumes.push_back(volume);
    };
    add(tree.root, GNO_TOP_NONE, Link::root, 0, 0);
    for (size_t i = 0; i < tree.volumes.size(); ++i) {  // breadth first: the list is its own queue
        const Volume volume = tree.volumes[i];
        for (uint32_t place = 0; place < 4; ++place) {
            const GnoTopLink& link = tree.links[4 * volume.caster + place];
            add(link.positiveChild, volume.caster, place == 3 ? Link::capPositive : Link::lateralPositive, volume.depth + 1, volume.planesAbove + place + 1);
            add(link.intersectionChild, volume.caster, Link::intersection, volume.depth + 1, volume.planesAbove + place + 1);
        }
    }
    return tree;
}

std::vector<std::optional<uint32_t>> TopTree::volumeOfCaster() const {
    std::vector<std::optional<uint32_t>> result(casters);
    for (uint32_t i = 0; i < volumes.size(); ++i) result[volumes[i].caster] = i;
    return result;
}

}  // namespace gno::viz
