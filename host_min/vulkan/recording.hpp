// SPDX-License-Identifier: MIT
// One command buffer under way: records passes with the barriers between them and a time stamp on either side; submit() runs it and waits.
#pragma once
#include <string>
#include <vector>

#include "glsl/core/pass.hpp"
#include "host_min/vulkan/device.hpp"

namespace gno::host {

class Image;

struct PassTime {
    std::string name;
    double ms;  ///< device time; NaN where the device has no time stamps
};

class Recording {
public:
    explicit Recording(const Device& device);

    [[nodiscard]] vk::CommandBuffer commands() const { return *commands_; }
    [[nodiscard]] const Device& device() const { return device_; }

    /// Descriptor sets that live as long as this recording.
    void keep(vk::raii::DescriptorPool sets) { descriptorPools_.push_back(std::move(sets)); }

    void barrier();  ///< everything before is visible to everything after
    void barrier(const MemoryBarrier& words);
    void toGeneral(const Image& image);  ///< from undefined: contents are lost
    void beginPass(std::string name);    ///< barrier and first time stamp
    void endPass();

    /// Runs the commands, waits, and tells the time of each pass. Once. Throws DeviceLost, MemoryError or WorkError: the device gave up.
    std::vector<PassTime> submit();

private:
    const Device& device_;
    vk::raii::CommandPool pool_;
    vk::raii::CommandBuffer commands_{nullptr};
    std::vector<vk::raii::DescriptorPool> descriptorPools_;
    vk::raii::QueryPool queries_{nullptr};
    std::vector<PassTime> times();

    std::vector<std::string> passes_;
};

}  // namespace gno::host
