// SPDX-License-Identifier: MIT
// Instance, device, one queue, and the validation layer's ear. Everything else borrows this; nothing is global.
#pragma once
#include <atomic>
#include <string>
#include <vector>

#include "host_min/vulkan/requirements.hpp"
#include "host_min/vulkan/vulkan.hpp"

namespace gno::host {

struct DeviceOptions {
    std::string wanted;       ///< GNOMON_DEVICE, see chooseDevice
    bool validation = false;  ///< Khronos validation layer with synchronization validation; warnings and errors go to stderr and are counted (advice
                              ///< on speed is not asked for)
    static DeviceOptions fromEnvironment();  ///< GNOMON_DEVICE; GNOMON_VALIDATE=0|1, by default on in debug builds
};

class Device {
public:
    explicit Device(const DeviceOptions& options);  ///< throws InputError when no device qualifies, or the layer is missing
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    [[nodiscard]] const vk::raii::Device& handle() const { return device_; }
    [[nodiscard]] const vk::raii::PhysicalDevice& physical() const { return physical_; }
    [[nodiscard]] const vk::raii::Queue& queue() const { return queue_; }
    [[nodiscard]] uint32_t queueFamily() const { return queueFamily_; }
    [[nodiscard]] const DeviceFacts& facts() const { return facts_; }
    [[nodiscard]] double timestampPeriod() const { return timestampPeriod_; }  ///< nanoseconds per tick
    [[nodiscard]] uint32_t memoryType(uint32_t allowed, vk::MemoryPropertyFlags wanted) const;
    [[nodiscard]] uint64_t validationMessages() const { return messages_.load(); }

    /// All devices of this machine, qualified or not.
    static std::vector<DeviceFacts> list();

private:
    std::atomic<uint64_t> messages_{0};
    vk::raii::Context context_;
    vk::raii::Instance instance_{nullptr};
    vk::raii::DebugUtilsMessengerEXT messenger_{nullptr};
    vk::raii::PhysicalDevice physical_{nullptr};
    vk::raii::Device device_{nullptr};
    vk::raii::Queue queue_{nullptr};
    vk::PhysicalDeviceMemoryProperties memory_;
    DeviceFacts facts_;
    uint32_t queueFamily_ = 0;
    double timestampPeriod_ = 1;
};

}  // namespace gno::host
