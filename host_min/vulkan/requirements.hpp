// SPDX-License-Identifier: MIT
// What the host asks of a device, as pure functions of its properties: tests call them with made-up devices.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gno::host {

inline constexpr uint32_t kMostGroups = 65535;  ///< work groups in a row of a dispatch: the least maxComputeWorkGroupCount[0] that Vulkan allows

/// The properties of one physical device that decide whether it will do; names are Vulkan's own.
struct DeviceFacts {
    std::string deviceName;
    std::string driverName;
    std::string driverInfo;   ///< lavapipe: "Mesa 25.0.7 …"
    bool isLavapipe = false;  ///< VkDriverId LLVMPIPE
    uint32_t apiVersionMajor = 1, apiVersionMinor = 3;
    bool dynamicRendering = true, synchronization2 = true;
    bool hasGraphicsAndComputeQueue = true;
    uint32_t timestampValidBits = 64;  ///< of that queue's family; 0: there are no times, which is told and no refusal
    uint64_t maxStorageBufferRange = 1u << 27;
    uint32_t maxImageDimension2D = 16384;
    uint32_t maxBoundDescriptorSets = 4;
    uint32_t maxPushConstantsSize = 128;
    uint32_t maxColorAttachments = 4;
    uint32_t maxComputeWorkGroupInvocations = 1024;
    uint32_t subgroupSize = 8;
    bool subgroupBallot = true;     ///< VK_SUBGROUP_FEATURE_BALLOT_BIT, in compute shaders
    bool rayQuery = false;          ///< rayQuery, accelerationStructure and bufferDeviceAddress, and the extensions that carry them
    uint32_t scratchAlignment = 1;  ///< minAccelerationStructureScratchOffsetAlignment, where rayQuery is true
};

/// What is missing, one entry each, by Vulkan's field name; empty: the device qualifies.
std::vector<std::string> missingRequirements(const DeviceFacts& facts);

/// For programs whose only results are times. Throws InputError when there are none.
void requireTimestamps(const DeviceFacts& device);

/// Index of the device to use. `wanted` (GNOMON_DEVICE): empty = the first that qualifies, a number = that one, else the first whose name
/// contains it (case-insensitive). Throws InputError, one line: no device at all, none of that name, or what each one lacks.
size_t chooseDevice(std::span<const DeviceFacts> devices, std::string_view wanted);

/// "Mesa 25.0.7-2~bpo12+1 (LLVM 15)" -> {25, 0}; {0, 0} when there is no version in it.
std::pair<int, int> mesaVersion(std::string_view driverInfo);

}  // namespace gno::host
