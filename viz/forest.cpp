// SPDX-License-Identifier: MIT
#include "viz/forest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "host_min/error.hpp"

namespace gno::viz {
namespace {

using host::InputError;

GnoForestGrid gridOf(const Dump& dump) {
    const GnoForestGrid grid = dump.readOne<GnoForestGrid>("grid");
    const bool isFinite = std::isfinite(glm::dot(grid.across, grid.along)) && grid.stepAcross > 0 && grid.stepAlong > 0 &&
                          std::isfinite(grid.stepAcross * grid.stepAlong);
    if (!std::has_single_bit(grid.resolution) || grid.resolution > 1024 || grid.faces != (dump.light().w != 0 ? 6u : 1u) || !isFinite)
        throw InputError(
            fmt::format("{}: its grid of {} faces with {} cells along an edge is none of a forest", dump.name(), grid.faces, grid.resolution));
    return grid;
}

/// Which blocks of the pool are whose.
void addPairs(const Dump& dump, const std::vector<GnoForestCell>& stored, uint32_t pairs, Forest& forest) {
    const auto pool = dump.read<GnoForestPair>("pairs");
    if (pairs > pool.size())
        throw InputError(fmt::format("{}: the forest is not complete: {} pairs, and the pool holds {}", dump.name(), pairs, pool.size()));
    for (uint32_t block = 0; block < pairs; ++block) {
        const GnoForestPair& pair = pool[block];
        if (pair.cell >= forest.cells.size() || pair.caster >= dump.casterCount())
            throw InputError(fmt::format("{}: the pool is broken: block {} is of caster {} in cell {}", dump.name(), block, pair.caster, pair.cell));
        ForestCell& cell = forest.cells[pair.cell];
        forest.used += cell.casters == 0;
        if (cell.casters++ == 0) cell.first = block;
        if (block - cell.first + 1 != cell.casters)
            throw InputError(fmt::format("{}: the pool is broken: the blocks of cell {} are not beside each other", dump.name(), pair.cell));
        forest.casterOfBlock.push_back(pair.caster);
    }
    for (uint32_t i = 0; i < stored.size(); ++i) {
        ForestCell& cell = forest.cells[i];
        cell.root = stored[i].root;
        if (stored[i].pairs != (cell.casters > 0 ? cell.first + cell.casters : 0) || (cell.root != GNO_FOREST_NONE && cell.casters == 0))
            throw InputError(fmt::format("{}: the pool is broken: cell {} has {} blocks of it from {}, and says otherwise", dump.name(), i,
                                         cell.casters, cell.first));
    }
}

void addTrees(const Dump& dump, Forest& forest) {
    std::vector<char> isIn(forest.casterOfBlock.size(), 0);
    for (ForestCell& cell : forest.cells) {
        if (cell.casters == 0) continue;
        const auto volumes = volumesOf(dump, forest.links, cell.root, cell.first, cell.first + cell.casters);
        cell.volumes = uint32_t(volumes.size());
        if (!volumes.empty()) cell.deepest = volumes.back().depth;
        forest.volumes += cell.volumes;
        for (const Volume& volume : volumes) isIn[volume.caster] = 1;
    }
    for (size_t block = 0; block < isIn.size(); ++block) {  // a caster that was left out was never a parent
        if (isIn[block]) continue;
        for (size_t node = 4 * block; node < 4 * block + 4; ++node)
            if (forest.links[node].positiveChild != GNO_TOP_NONE || forest.links[node].intersectionChild != GNO_TOP_NONE)
                throw InputError(fmt::format("{}: the tree is broken: node {} has children, and no link leads to it", dump.name(), node));
    }
}

void addSamples(const Dump& dump, Forest& forest) {
    struct Sample {
        glm::vec3 position;
        uint32_t own;
    };
    const auto samples = dump.readPerPixel<Sample>("samples");
    const auto visited = dump.readPerPixel<uint32_t>("visited_nodes");
    for (size_t i = 0; i < samples.size(); ++i) {
        if (samples[i].own > GNO_NO_CASTER) continue;
        ForestCell& cell = forest.cells[forest.cellAt(samples[i].position)];
        if (visited[i] > 0 && cell.casters == 0)
            throw InputError(fmt::format("{}: pixel {} visited nodes, and its cell keeps no casters", dump.name(), i));
        ++cell.samples;
        cell.visits += visited[i];
        cell.mostVisits = std::max(cell.mostVisits, visited[i]);
        ++forest.samples;
        forest.visits += visited[i];
    }
}

}  // namespace

Forest Forest::read(const Dump& dump) {
    if (!dump.has("forest_header") || !dump.has("cells"))
        throw InputError(fmt::format("{}: technique {} has no forest; make the dump with forest", dump.name(), dump.technique()));
    Forest forest;
    forest.grid = gridOf(dump);
    forest.light = dump.light();
    const auto stored = dump.read<GnoForestCell>("cells", gnoCellCount(forest.grid.resolution, forest.grid.faces));
    forest.cells.resize(stored.size());
    const auto header = dump.readOne<GnoForestHeader>("forest_header");
    addPairs(dump, stored, header.pairs, forest);
    forest.links = dump.read<GnoTopLink>("links");
    if (forest.links.size() < 4 * forest.casterOfBlock.size())
        throw InputError(fmt::format("{}: the pool is broken: it has {} nodes", dump.name(), forest.links.size()));
    addTrees(dump, forest);
    addSamples(dump, forest);
    for (const auto& [name, found] : {std::pair("pairs", uint64_t(forest.casterOfBlock.size())), std::pair("used_cells", forest.used),
                                      std::pair("visited_nodes", forest.visits)})
        if (found != dump.counter(name))
            throw InputError(fmt::format("{}: {} add up to {}, and the record counted {}: a part of the dump is damaged, or of another run",
                                         dump.name(), name, found, dump.counter(name)));
    if (header.used != forest.used)
        throw InputError(fmt::format("{}: {} cells keep casters, and the header says {}", dump.name(), forest.used, header.used));
    return forest;
}

std::vector<Volume> Forest::treeOf(const Dump& dump, uint32_t cell) const {
    const ForestCell& own = cells[cell];
    std::vector<Volume> tree = volumesOf(dump, links, own.root, own.first, own.first + own.casters);
    for (Volume& volume : tree) {
        volume.caster = casterOfBlock[volume.caster];
        if (volume.parent != GNO_TOP_NONE) volume.parent = casterOfBlock[volume.parent];
    }
    return tree;
}

uint32_t Forest::fullestCell() const {
    return uint32_t(std::max_element(cells.begin(), cells.end(), [](const ForestCell& a, const ForestCell& b) { return a.casters < b.casters; }) -
                    cells.begin());
}

uint32_t Forest::dearestCell() const {
    return uint32_t(std::max_element(cells.begin(), cells.end(),
                                     [](const ForestCell& a, const ForestCell& b) { return a.visitsPerSample() < b.visitsPerSample(); }) -
                    cells.begin());
}

// The steps of gnoCellOf in glsl/forest/cells.glsl, in fp32: a sample within rounding of a border must be found where the device found it.
uint32_t Forest::cellAt(glm::vec3 p) const {
    const glm::vec3 q = p - glm::vec3(light) * light.w, far = glm::abs(q);
    uint32_t face = 0;
    glm::vec3 place(0);
    if (light.w != 0) {
        face = far.x >= far.y && far.x >= far.z ? (q.x < 0 ? 1u : 0u) : far.y >= far.z ? (q.y < 0 ? 3u : 2u) : (q.z < 0 ? 5u : 4u);
        place = face < 2 ? glm::vec3(q.y, q.z, q.x) : face < 4 ? glm::vec3(q.z, q.x, q.y) : q;
        if (face % 2 == 1) place.z = -place.z;
    } else {
        const auto along = [&](const glm::vec4& axis) { return axis.x * q.x + axis.y * q.y + axis.z * q.z; };
        place = {along(grid.across), along(grid.along), 1};
    }
    const auto index = [&](float value, float least, float step) {
        const float at = (value - least) / step;
        return at > 0 ? std::min(uint32_t(std::min(at, 2048.0f)), grid.resolution - 1) : 0u;
    };
    const uint32_t column = index(place.x / place.z, grid.across.w, grid.stepAcross), row = index(place.y / place.z, grid.along.w, grid.stepAlong);
    return (face * grid.resolution + row) * grid.resolution + column;
}

glm::dvec3 Forest::axisOf(uint32_t face) const { return light.w != 0 ? direction(face, glm::dvec2(0)) : -glm::normalize(glm::dvec3(light)); }

double Forest::depthOf(uint32_t face, glm::dvec3 p) const { return glm::dot(axisOf(face), p - glm::dvec3(light) * double(light.w)); }

glm::dvec2 Forest::cornerOf(uint32_t cell, uint32_t corner) const {
    const double column = columnOf(cell) + (corner == 1 || corner == 2 ? 1 : 0), row = rowOf(cell) + (corner >= 2 ? 1 : 0);
    return {grid.across.w + column * grid.stepAcross, grid.along.w + row * grid.stepAlong};
}

glm::dvec3 Forest::direction(uint32_t face, glm::dvec2 place) const {
    const double forwards = face % 2 == 0 ? 1 : -1;
    return face < 2   ? glm::dvec3(forwards, place.x, place.y)
           : face < 4 ? glm::dvec3(place.y, forwards, place.x)
                      : glm::dvec3(place.x, place.y, forwards);
}

std::array<CellEdge, 4> Forest::edgesOf(uint32_t cell) const {
    std::array<CellEdge, 4> edges;
    for (uint32_t corner = 0; corner < 4; ++corner) {
        const glm::dvec2 place = cornerOf(cell, corner);
        if (light.w != 0)
            edges[corner] = {glm::dvec3(light), direction(faceOf(cell), place)};
        else
            edges[corner] = {place.x * glm::dvec3(grid.across) + place.y * glm::dvec3(grid.along), axisOf(0)};
    }
    return edges;
}

std::array<glm::dvec4, 4> Forest::sidesOf(uint32_t cell) const {
    const auto edges = edgesOf(cell);
    glm::dvec3 inside(0);
    for (const CellEdge& edge : edges) inside += (edge.at + edge.along) / 4.0;
    std::array<glm::dvec4, 4> sides;
    for (size_t i = 0; i < 4; ++i) {
        const CellEdge &a = edges[i], &b = edges[(i + 1) % 4];
        glm::dvec3 normal = glm::normalize(glm::cross(a.along, b.at + b.along - a.at));
        if (glm::dot(normal, inside - a.at) > 0) normal = -normal;
        sides[i] = glm::dvec4(normal, -glm::dot(normal, a.at));
    }
    return sides;
}

std::string faceName(const Forest& forest, uint32_t face) {
    if (forest.grid.faces == 1) return "seen from the light";
    constexpr std::array kNames{"+x", "-x", "+y", "-y", "+z", "-z"};
    return kNames.at(face);
}

std::string cellName(const Forest& forest, uint32_t cell) {
    const std::string place = fmt::format("column {}, row {}", forest.columnOf(cell), forest.rowOf(cell));
    return forest.grid.faces == 1 ? fmt::format("cell {} ({})", cell, place)
                                  : fmt::format("cell {} (face {}, {})", cell, faceName(forest, forest.faceOf(cell)), place);
}

}  // namespace gno::viz
