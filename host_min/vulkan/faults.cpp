// SPDX-License-Identifier: MIT
#include "host_min/vulkan/faults.hpp"

#include <fmt/format.h>

#include "host_min/error.hpp"
#include "host_min/vulkan/vulkan.hpp"

namespace gno::host {

void rethrowVulkanFault() {
    try {
        throw;
    } catch (const vk::DeviceLostError& error) {
        throw DeviceLost(
            fmt::format("the device is lost ({}): its driver gave up; start again, with a smaller scene or --size if it stays so", error.what()));
    } catch (const vk::OutOfDeviceMemoryError& error) {
        throw MemoryError(fmt::format("the device has no memory left ({}): use a smaller --size or scene", error.what()));
    } catch (const vk::OutOfHostMemoryError& error) {
        throw MemoryError(fmt::format("the driver has no memory left ({}): use a smaller --size or scene", error.what()));
    } catch (const vk::SystemError& error) {
        throw WorkError(fmt::format("the device gave up ({})", error.what()));
    }
}

void withVulkanFaults(const std::function<void()>& work) {
    try {
        work();
    } catch (const vk::SystemError&) {
        rethrowVulkanFault();
    }
}

}  // namespace gno::host
