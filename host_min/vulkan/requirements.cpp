// SPDX-License-Identifier: MIT
#include "host_min/vulkan/requirements.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <utility>

#include "host_min/error.hpp"

namespace gno::host {
namespace {

constexpr std::pair<int, int> kOldestMesa{24, 1};  // before it, lavapipe gives silently wrong results

std::string lower(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

}  // namespace

std::pair<int, int> mesaVersion(std::string_view driverInfo) {
    const size_t at = driverInfo.find("Mesa ");
    if (at == std::string_view::npos) return {0, 0};
    const char* first = driverInfo.data() + at + 5;
    const char* last = driverInfo.data() + driverInfo.size();
    int major = 0, minor = 0;
    const auto [dot, error] = std::from_chars(first, last, major);
    if (error != std::errc{} || dot == last || *dot != '.') return {0, 0};
    std::from_chars(dot + 1, last, minor);
    return {major, minor};
}

std::vector<std::string> missingRequirements(const DeviceFacts& f) {
    std::vector<std::string> missing;
    const auto need = [&](bool there, std::string_view what) {
        if (!there) missing.emplace_back(what);
    };
    need(std::pair(f.apiVersionMajor, f.apiVersionMinor) >= std::pair(1u, 3u),
         fmt::format("apiVersion 1.3 (it has {}.{})", f.apiVersionMajor, f.apiVersionMinor));
    need(f.dynamicRendering, "dynamicRendering");
    need(f.synchronization2, "synchronization2");
    need(f.hasGraphicsAndComputeQueue, "a queue with VK_QUEUE_GRAPHICS_BIT and VK_QUEUE_COMPUTE_BIT");
    need(f.maxStorageBufferRange >= (1u << 27), fmt::format("maxStorageBufferRange 134217728 (it has {})", f.maxStorageBufferRange));
    need(f.maxBoundDescriptorSets >= 4, "maxBoundDescriptorSets 4");
    need(f.maxPushConstantsSize >= 128, "maxPushConstantsSize 128");
    need(f.maxColorAttachments >= 4, "maxColorAttachments 4");
    if (f.isLavapipe && mesaVersion(f.driverInfo) < kOldestMesa)
        missing.push_back(
            fmt::format("a newer lavapipe ({} gives silently wrong results; {}.{} or newer is needed: on Debian 12 install mesa-vulkan-drivers "
                        "from bookworm-backports, as host_min/setup.sh does)",
                        f.driverInfo.empty() ? "this one" : f.driverInfo, kOldestMesa.first, kOldestMesa.second));
    return missing;
}

void requireTimestamps(const DeviceFacts& device) {
    if (device.timestampValidBits == 0)
        throw InputError(
            fmt::format("{} has no time stamps (timestampValidBits 0), so there is nothing to measure with: use another device, see "
                        "GNOMON_DEVICE",
                        device.deviceName));
}

size_t chooseDevice(std::span<const DeviceFacts> devices, std::string_view wanted) {
    if (devices.empty()) throw InputError("no Vulkan device found: install a driver (Debian: mesa-vulkan-drivers) or check VK_DRIVER_FILES");
    size_t index = devices.size();
    std::string refused;
    const bool isNumber = !wanted.empty() && std::all_of(wanted.begin(), wanted.end(), [](unsigned char c) { return std::isdigit(c); });
    for (size_t i = 0; i < devices.size() && index == devices.size(); ++i) {
        const bool named =
            wanted.empty() || (isNumber ? std::to_string(i) == wanted : lower(devices[i].deviceName).find(lower(wanted)) != std::string::npos);
        if (!named) continue;
        const auto missing = missingRequirements(devices[i]);
        if (missing.empty())
            index = i;
        else
            refused += fmt::format("{}{} lacks {}", refused.empty() ? "" : "; ", devices[i].deviceName, fmt::join(missing, ", "));
    }
    if (index < devices.size()) return index;
    if (refused.empty()) throw InputError(fmt::format("no Vulkan device matches GNOMON_DEVICE={}: `gnomon device` lists them", wanted));
    throw InputError("no Vulkan device qualifies: " + refused);
}

}  // namespace gno::host
