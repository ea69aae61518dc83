// SPDX-License-Identifier: MIT
#include "viz/top_tree.hpp"

#include <fmt/format.h>

#include <bit>

#include "host_min/error.hpp"

namespace gno::viz {

using host::InputError;

std::vector<Volume> volumesOf(const Dump& dump, std::span<const GnoTopLink> links, uint32_t root, uint32_t first, uint32_t end) {
    const double shift = dump.light().w == 0 ? 4.0 : 0.0;  // gnoLightDepth
    std::vector<Volume> volumes;
    std::vector<char> isIn(end - first, 0);
    const auto add = [&](uint32_t node, uint32_t parent, Link link, uint32_t depth, uint32_t planesAbove) {
        if (node == GNO_TOP_NONE) return;
        const uint32_t block = node / 4;
        const bool isOwn = block >= first && block < end;
        if (node % 4 != 0 || !isOwn || isIn[block - first])
            throw InputError(
                fmt::format("{}: the tree is broken: a link leads to node {}{}", dump.name(), node, isOwn && isIn[block - first] ? " twice" : ""));
        isIn[block - first] = 1;
        Volume volume{block, parent, link, depth, planesAbove};
        volume.leastDistance = float((double(std::bit_cast<float>(links[node].aux)) - shift) * dump.metres());
        volumes.push_back(volume);
    };
    add(root, GNO_TOP_NONE, Link::root, 0, 0);
    for (size_t i = 0; i < volumes.size(); ++i) {  // breadth first: the list is its own queue
        const Volume volume = volumes[i];
        for (uint32_t place = 0; place < 4; ++place) {
            const GnoTopLink& link = links[4 * size_t(volume.caster) + place];
            add(link.positiveChild, volume.caster, place == 3 ? Link::capPositive : Link::lateralPositive, volume.depth + 1,
                volume.planesAbove + place + 1);
            add(link.intersectionChild, volume.caster, Link::intersection, volume.depth + 1, volume.planesAbove + place + 1);
        }
    }
    return volumes;
}

TopTree TopTree::read(const Dump& dump) {
    if (dump.has("forest_header"))
        throw InputError(
            fmt::format("{}: technique {} has a TOP tree per cell of the light's grid, and no tree of all casters; use `gnomon-viz forest`",
                        dump.name(), dump.technique()));
    if (!dump.has("planes") || !dump.has("links"))
        throw InputError(
            fmt::format("{}: technique {} has no TOP tree; make the dump with psv, d-psv, d-stackless or d-hybrid", dump.name(), dump.technique()));
    TopTree tree;
    tree.casters = dump.casterCount();
    tree.planes = dump.read<glm::vec4>("planes", 4 * tree.casters);
    tree.links = dump.read<GnoTopLink>("links", 4 * tree.casters);
    tree.visits = dump.read<uint32_t>("visits", 4 * tree.casters);
    tree.root = dump.read<GnoTopHeader>("header", 1).front().root;
    tree.volumes = volumesOf(dump, tree.links, tree.root, 0, uint32_t(tree.casters));
    for (Volume& volume : tree.volumes)
        for (uint32_t place = 0; place < 4; ++place) volume.visits += tree.visits[4 * size_t(volume.caster) + place];
    return tree;
}

std::vector<std::optional<uint32_t>> TopTree::volumeOfCaster() const {
    std::vector<std::optional<uint32_t>> result(casters);
    for (uint32_t i = 0; i < volumes.size(); ++i) result[volumes[i].caster] = i;
    return result;
}

}  // namespace gno::viz
