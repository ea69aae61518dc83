// SPDX-License-Identifier: MIT
#include "host_min/app/lists.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host_min/techniques/technique.hpp"
#include "host_min/vulkan/device.hpp"

namespace gno::host {
namespace {

void printSettings(const std::vector<SettingInfo>& settings) {
    for (const SettingInfo& setting : settings)
        fmt::print("    --set {}={}   default {}: {}\n", setting.key, setting.range(), setting.fallback, setting.meaning);
}

}  // namespace

void printTechniques() {
    const DeviceOptions options = DeviceOptions::fromEnvironment();
    const auto devices = Device::list();
    const DeviceFacts& device = devices[chooseDevice(devices, options.wanted)];
    fmt::print("on {}:\n", device.deviceName);
    for (const auto& technique : techniques()) {
        const TechniqueInfo& info = technique->info();
        std::vector<std::string> rungs;
        for (const Precision precision : info.precisions) rungs.emplace_back(name(precision));
        fmt::print("{:14} {}\n    precision {}; effects {}\n", info.name, info.paper, fmt::join(rungs, ", "), fmt::join(info.effects, ", "));
        const std::string missing = missingFor(info, device);
        if (!missing.empty()) fmt::print("    this device lacks {}\n", missing);
        printSettings(info.settings);
    }
    fmt::print("every technique\n");
    printSettings(frameSettings());
    fmt::print("not in this build yet:\n");
    for (const auto& [planned, what] : plannedTechniques()) fmt::print("{:14} {}\n", planned, what);
}

void printDevices() {
    const DeviceOptions options = DeviceOptions::fromEnvironment();
    const auto devices = Device::list();
    for (size_t i = 0; i < devices.size(); ++i) {
        const DeviceFacts& f = devices[i];
        fmt::print(
            "{} {}\n  driver {} {}\n  Vulkan {}.{}, subgroup width {}\n  maxStorageBufferRange {}, maxImageDimension2D {}, maxBoundDescriptorSets "
            "{}, maxPushConstantsSize {}, ray queries {}, time stamps {}\n",
            i, f.deviceName, f.driverName, f.driverInfo, f.apiVersionMajor, f.apiVersionMinor, f.subgroupSize, f.maxStorageBufferRange,
            f.maxImageDimension2D, f.maxBoundDescriptorSets, f.maxPushConstantsSize, f.rayQuery ? "yes" : "no",
            f.timestampValidBits > 0 ? "yes" : "no");
        const auto missing = missingRequirements(f);
        if (!missing.empty()) fmt::print("  missing: {}\n", fmt::join(missing, ", "));
    }
    const size_t chosen = chooseDevice(devices, options.wanted);
    fmt::print("in use: {} (GNOMON_DEVICE chooses)\n", chosen);
}

}  // namespace gno::host
