// SPDX-License-Identifier: MIT
#include "host_min/techniques/cell_assignment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "host_min/error.hpp"

namespace gno::host {
namespace {

uint32_t groupsOf(uint32_t count) { return std::max(1u, (count + GNO_FOREST_GROUP - 1) / GNO_FOREST_GROUP); }

}  // namespace

GnoForestGrid forestGrid(glm::vec4 light, glm::vec3 low, glm::vec3 high, uint32_t resolution) {
    GnoForestGrid grid{};
    grid.resolution = resolution;
    if (light.w != 0) {
        grid.faces = 6;
        grid.across.w = grid.along.w = -1;
        grid.stepAcross = grid.stepAlong = 2.0f / float(resolution);
        return grid;
    }
    grid.faces = 1;
    const glm::dvec3 towards = glm::normalize(glm::dvec3(light));
    const glm::dvec3 other = std::abs(towards.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 across = glm::normalize(glm::cross(towards, other)), along = glm::cross(towards, across);
    const auto place = [&](const glm::dvec3& axis, glm::vec4& stored, float& step) {
        double least = std::numeric_limits<double>::max(), greatest = -least;
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 p((corner & 1) ? high.x : low.x, (corner & 2) ? high.y : low.y, (corner & 4) ? high.z : low.z);
            least = std::min(least, glm::dot(axis, p));
            greatest = std::max(greatest, glm::dot(axis, p));
        }
        stored = glm::vec4(glm::vec3(axis), float(least));
        step = float(std::max(greatest - least, 1e-6) / resolution);
    };
    place(across, grid.across, grid.stepAcross);
    place(along, grid.along, grid.stepAlong);
    return grid;
}

CellAssignment::CellAssignment(const FrameInputs& inputs, const char* owner, bool viewCull, bool cover, uint32_t seed)
    : inputs_(inputs),
      viewCull_(viewCull),
      cover_(cover),
      seed_(seed),
      grid_(inputs.device(), sizeof(GnoForestGrid), vk::BufferUsageFlagBits::eUniformBuffer),
      cells_(inputs.device(), sizeof(GnoForestCell)),
      header_(inputs.device(), sizeof(GnoForestHeader), vk::BufferUsageFlagBits::eStorageBuffer | vk::BufferUsageFlagBits::eIndirectBuffer),
      list_(inputs.device(), 4 * uint64_t(inputs.triangleCount())),
      few_(inputs.device(), sizeof(GnoForestFew) * uint64_t(inputs.triangleCount())),
      pool_(inputs.device(), sizeof(GnoForestPair)) {
    if (groupsOf(inputs.triangleCount()) > kMostGroups)
        throw InputError(fmt::format("{} triangles are over the {}'s limit of {}", inputs.triangleCount(), owner, kMostGroups * GNO_FOREST_GROUP));
}

void CellAssignment::setResolution(uint32_t resolution) {
    const GnoForestGrid grid = forestGrid(inputs_.light(), inputs_.frame().low, inputs_.frame().high, resolution);
    grid_.upload(std::span(&grid, 1));
    resolution_ = resolution;
    cellCount_ = gnoCellCount(grid.resolution, grid.faces);
    cells_ = Buffer(inputs_.device(), uint64_t(cellCount_) * sizeof(GnoForestCell));
}

void CellAssignment::setPool(uint64_t pairs) { pool_ = Buffer(inputs_.device(), std::max<uint64_t>(pairs, 1) * sizeof(GnoForestPair)); }

std::vector<Binding> CellAssignment::resources() const {
    return {{"gnoCasters", &inputs_.casters()},
            {"gnoStates", &inputs_.states()},
            {"gnoSamples", &inputs_.samples()},
            {"gnoForestGrid", &grid_},
            {"gnoForestCells", &cells_},
            {"gnoForestHeader", &header_},
            {"gnoForestFew", &few_},
            {"gnoList", &list_},
            {"gnoForestPairs", &pool_}};
}

const ComputePass& CellAssignment::pass(const std::string& name, Specialization constants) const {
    if (name.starts_with("assign") || name == "sort.comp") {  // what a shader does not use would only make another pipeline of it
        constants[30] = viewCull_;
        constants[31] = cover_;
    }
    return inputs_.passes().compute("forest/examples/" + name, constants);
}

void CellAssignment::recordDepth(Recording& recording) const {
    const ExamplePush push = inputs_.push(seed_);
    const auto bytes = std::as_bytes(std::span(&push, 1));
    pass("reset.comp").dispatch(recording, resources(), bytes, groupsOf(cellCount_));
    if (!viewCull_) return;
    recording.barrier();
    pass("depth.comp").dispatch(recording, resources(), bytes, (inputs_.width() + 31) / 32, (inputs_.height() + 15) / 16);
}

void CellAssignment::recordSort(Recording& recording) const {
    const ExamplePush push = inputs_.push(seed_);
    const auto bytes = std::as_bytes(std::span(&push, 1));
    pass("sort.comp").dispatch(recording, resources(), bytes, groupsOf(inputs_.triangleCount()));
    recording.barrier();
    pass("sizes.comp").dispatch(recording, resources(), bytes, 1);
}

void CellAssignment::recordCount(Recording& recording) const {
    const auto all = resources();
    if (cover_) {
        step(recording, 3, all);
        recording.barrier();
    }
    step(recording, 4, all);
}

void CellAssignment::recordEmit(Recording& recording) const { step(recording, 6, resources()); }

/// The larger casters first: `many`, `some`, `few`.
void CellAssignment::step(Recording& recording, uint32_t which, const std::vector<Binding>& resources) const {
    const ExamplePush push = inputs_.push(seed_);
    const auto bytes = std::as_bytes(std::span(&push, 1));
    const bool ordered = which == 6;
    pass("assign_many.comp", {{32, which}}).dispatchIndirect(recording, resources, bytes, header_, offsetof(GnoForestHeader, groupsOfMany));
    if (ordered) recording.barrier();
    pass("assign_some.comp", {{32, which}}).dispatchIndirect(recording, resources, bytes, header_, offsetof(GnoForestHeader, groupsOfSome));
    if (which == 3) return;
    if (ordered) recording.barrier();
    pass("assign_few.comp", {{32, which}}).dispatch(recording, resources, bytes, groupsOf(inputs_.triangleCount()));
}

}  // namespace gno::host
