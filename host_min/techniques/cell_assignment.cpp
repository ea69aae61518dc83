// SPDX-License-Identifier: MIT
#include "host_min/techniques/cell_assignment.hpp"

#include <fmt/format.h>

#include <bit>
#include <span>

#include "host_min/error.hpp"

namespace gno::host {
namespace {

Float3 floats(glm::vec3 v) { return {v.x, v.y, v.z}; }
Float4 floats(glm::vec4 v) { return {v.x, v.y, v.z, v.w}; }

}  // namespace

GnoForestGrid forestGrid(glm::vec4 light, glm::vec3 low, glm::vec3 high, uint32_t resolution) {
    return std::bit_cast<GnoForestGrid>(gno::forestGrid(floats(light), floats(low), floats(high), resolution));
}

LightCells lightCells(const FrameInputs& inputs, const char* owner, uint32_t resolution, bool viewCull, bool cover) {
    if (groupsFor(inputs.triangleCount(), kForestGroup) > kMostForestGroups)
        throw InputError(fmt::format("{} triangles are over the {}'s limit of {}", inputs.triangleCount(), owner, kMostForestGroups * kForestGroup));
    return {.casters = inputs.triangleCount(),
            .width = inputs.width(),
            .height = inputs.height(),
            .resolution = resolution,
            .faces = forestFaces(floats(inputs.light())),
            .viewCull = viewCull,
            .cover = cover};
}

void writeGrid(Buffer& grid, const FrameInputs& inputs, const LightCells& cells) {
    const GnoForestGrid value = forestGrid(inputs.light(), inputs.frame().low, inputs.frame().high, cells.resolution);
    grid.upload(std::span(&value, 1));
}

}  // namespace gno::host
