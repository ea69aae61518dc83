// SPDX-License-Identifier: MIT
// One acceleration structure (VK_KHR_acceleration_structure), bottom or top level: its memory, and the command that builds it. The caller puts
// the barriers: indices or the bottom level before a build, the build before a query.
#pragma once
#include <optional>

#include "host_min/vulkan/buffer.hpp"

namespace gno::host {

class Recording;

class AccelerationStructure {
public:
    /// Bottom level: `triangles` triangles, three 32-bit indices each into `vertices`, which holds 3 * triangles of them, packed floats. No ray
    /// meets a triangle whose indices are the same. Both buffers have kInputUsage and outlive this. Throws WorkError when there is no memory left.
    static AccelerationStructure ofTriangles(const Device& device, const Buffer& vertices, const Buffer& indices, uint32_t triangles);
    /// Top level: `bottom` once, untransformed.
    static AccelerationStructure ofInstance(const Device& device, const AccelerationStructure& bottom);

    /// Records the build; what was there before is replaced.
    void build(Recording& recording) const;

    [[nodiscard]] vk::AccelerationStructureKHR handle() const { return *structure_; }
    [[nodiscard]] uint64_t bytes() const { return memory_.bytes(); }
    [[nodiscard]] uint64_t scratchBytes() const { return scratch_.bytes(); }  ///< needed while it is built only

    /// What a buffer must be good for that a build reads.
    static constexpr vk::BufferUsageFlags kInputUsage =
        vk::BufferUsageFlagBits::eShaderDeviceAddress | vk::BufferUsageFlagBits::eAccelerationStructureBuildInputReadOnlyKHR;

private:
    AccelerationStructure(const Device& device, vk::AccelerationStructureTypeKHR type, const vk::AccelerationStructureGeometryKHR& geometry,
                          uint32_t primitives, std::optional<Buffer> instances);

    const Device* device_;
    vk::AccelerationStructureTypeKHR type_;
    vk::AccelerationStructureGeometryKHR geometry_;
    uint32_t primitives_;
    std::optional<Buffer> instances_;
    vk::AccelerationStructureBuildSizesInfoKHR sizes_;
    Buffer memory_, scratch_;
    vk::raii::AccelerationStructureKHR structure_{nullptr};
};

}  // namespace gno::host
