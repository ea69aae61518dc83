// SPDX-License-Identifier: MIT
#include "host_min/vulkan/acceleration_structure.hpp"

#include <array>

#include "host_min/vulkan/recording.hpp"

namespace gno::host {
namespace {

using Usage = vk::BufferUsageFlagBits;

vk::AccelerationStructureBuildGeometryInfoKHR buildInfo(vk::AccelerationStructureTypeKHR type,
                                                        const vk::AccelerationStructureGeometryKHR& geometry) {
    return {type, vk::BuildAccelerationStructureFlagBitsKHR::ePreferFastTrace, vk::BuildAccelerationStructureModeKHR::eBuild, {}, {}, 1, &geometry};
}

vk::AccelerationStructureBuildSizesInfoKHR sizesOf(const Device& device, vk::AccelerationStructureTypeKHR type,
                                                   const vk::AccelerationStructureGeometryKHR& geometry, uint32_t primitives) {
    return device.handle().getAccelerationStructureBuildSizesKHR(vk::AccelerationStructureBuildTypeKHR::eDevice, buildInfo(type, geometry),
                                                                 primitives);
}

}  // namespace

AccelerationStructure::AccelerationStructure(const Device& device, vk::AccelerationStructureTypeKHR type,
                                             const vk::AccelerationStructureGeometryKHR& geometry, uint32_t primitives,
                                             std::optional<Buffer> instances)
    : device_(&device),
      type_(type),
      geometry_(geometry),
      primitives_(primitives),
      instances_(std::move(instances)),
      sizes_(sizesOf(device, type, geometry, primitives)),
      memory_(device, sizes_.accelerationStructureSize, Usage::eAccelerationStructureStorageKHR | Usage::eShaderDeviceAddress),
      scratch_(device, sizes_.buildScratchSize + device.facts().scratchAlignment, Usage::eStorageBuffer | Usage::eShaderDeviceAddress),
      structure_(device.handle(), vk::AccelerationStructureCreateInfoKHR({}, memory_.handle(), 0, sizes_.accelerationStructureSize, type)) {}

AccelerationStructure AccelerationStructure::ofTriangles(const Device& device, const Buffer& vertices, const Buffer& indices, uint32_t triangles) {
    const vk::AccelerationStructureGeometryTrianglesDataKHR data(vk::Format::eR32G32B32Sfloat, vertices.address(), 12,
                                                                 triangles == 0 ? 0 : 3 * triangles - 1, vk::IndexType::eUint32, indices.address());
    return {device, vk::AccelerationStructureTypeKHR::eBottomLevel, {vk::GeometryTypeKHR::eTriangles, data}, triangles, std::nullopt};
}

AccelerationStructure AccelerationStructure::ofInstance(const Device& device, const AccelerationStructure& bottom) {
    vk::AccelerationStructureInstanceKHR instance;
    for (size_t i = 0; i < 3; ++i) instance.transform.matrix[i][i] = 1;
    instance.mask = 0xFF;
    instance.accelerationStructureReference = device.handle().getAccelerationStructureAddressKHR(bottom.handle());
    Buffer instances(device, sizeof(instance), kInputUsage);
    instances.upload(std::as_bytes(std::span(&instance, 1)));
    const vk::AccelerationStructureGeometryInstancesDataKHR data(VK_FALSE, instances.address());
    return {device, vk::AccelerationStructureTypeKHR::eTopLevel, {vk::GeometryTypeKHR::eInstances, data}, 1, std::move(instances)};
}

void AccelerationStructure::build(Recording& recording) const {
    vk::AccelerationStructureBuildGeometryInfoKHR info = buildInfo(type_, geometry_);
    info.dstAccelerationStructure = *structure_;
    const vk::DeviceAddress alignment = device_->facts().scratchAlignment;
    info.scratchData = (scratch_.address() + alignment - 1) / alignment * alignment;
    const vk::AccelerationStructureBuildRangeInfoKHR range(primitives_);
    const auto* const ranges = &range;
    recording.commands().buildAccelerationStructuresKHR(info, ranges, *device_->handle().getDispatcher());
}

}  // namespace gno::host
