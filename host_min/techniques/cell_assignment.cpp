// SPDX-License-Identifier: MIT
#include "host_min/techniques/cell_assignment.hpp"

#include <bit>
#include <span>

namespace gno::host {
namespace {

Float3 floats(glm::vec3 v) { return {v.x, v.y, v.z}; }
Float4 floats(glm::vec4 v) { return {v.x, v.y, v.z, v.w}; }

}  // namespace

GnoForestGrid forestGrid(glm::vec4 light, glm::vec3 low, glm::vec3 high, uint32_t resolution) {
    return std::bit_cast<GnoForestGrid>(gno::forestGrid(floats(light), floats(low), floats(high), resolution));
}

std::string lightCellsOverLimit(const DeviceFacts& device, const FrameLoad& load) {
    const std::string rows = overCasters(load.triangles, uint64_t(kMostForestGroups) * kForestGroup, "64 in each of 65535 work groups");
    if (!rows.empty()) return rows;
    return overCasters(load.triangles, device.maxStorageBufferRange / 64, "64 bytes each in one array, the device's maxStorageBufferRange");
}

LightCells lightCells(const FrameInputs& inputs, uint32_t resolution, bool viewCull, bool cover) {
    throwLimit(lightCellsOverLimit(inputs.device().facts(), FrameLoad::of(inputs)));
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
