// SPDX-License-Identifier: MIT
// A dumped TOP tree (glsl/top/node.h) as a list of the shadow volumes in it.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "glsl/top/node.h"
#include "viz/dump.hpp"

namespace gno::viz {

/// By which link a volume hangs in the tree. A negative child is the next plane of the same volume, so no volume hangs by one.
enum class Link : uint32_t { root, lateralPositive, capPositive, intersection };

struct Volume {
    uint32_t caster = 0;
    uint32_t parent = GNO_TOP_NONE;  ///< caster of the volume above
    Link link = Link::root;
    uint32_t depth = 0;        ///< volumes above it
    uint32_t planesAbove = 0;  ///< nodes from the root to its first one
    float leastDistance = 0;   ///< of its subtree from the light (a light at infinity: depth along its direction), metres
    uint64_t visits = 0;       ///< of its four nodes by all queries of the frame
};

/// The volumes of one tree by depth, the root first. Its blocks of four nodes are first .. end-1 of `links`, and `caster` and `parent` are blocks;
/// no visits. Throws InputError: a link leads out of them, or twice to the same volume.
std::vector<Volume> volumesOf(const Dump& dump, std::span<const GnoTopLink> links, uint32_t root, uint32_t first, uint32_t end);

struct TopTree {
    std::vector<Volume> volumes;  ///< in the tree, by depth; the root first
    std::vector<glm::vec4> planes;
    std::vector<GnoTopLink> links;
    std::vector<uint32_t> visits;  ///< per node
    uint32_t root = GNO_TOP_NONE;
    uint64_t casters = 0;  ///< of the scene

    /// Throws InputError: the dump is no TOP tree's, or a link leads nowhere or twice to the same volume.
    static TopTree read(const Dump& dump);
    /// Index into `volumes`, by caster; none when it is not in the tree.
    [[nodiscard]] std::vector<std::optional<uint32_t>> volumeOfCaster() const;
};

}  // namespace gno::viz
