// SPDX-License-Identifier: MIT
// Passes by shader and specialization, made once: a driver compiles a pipeline at its first use, and that takes longer than most frames.
#pragma once
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "host_min/vulkan/pass.hpp"

namespace gno::host {

class PassCache {
public:
    explicit PassCache(const Device& device) : device_(device) {}
    [[nodiscard]] const Device& device() const { return device_; }

    /// From now on this stands for that compute shader, interface and constants alike: tests run faults and emulations so. Before its first use.
    void substitute(const std::string& shader, std::vector<uint32_t> spirv) { substitutes_[shader] = std::move(spirv); }

    const ComputePass& compute(const std::string& shader, const Specialization& constants = {});
    const RasterPass& raster(const std::string& vertex, const std::string& fragment, std::span<const vk::Format> colors, bool depth,
                             const Specialization& constants = {});

private:
    const Device& device_;
    std::map<std::string, std::vector<uint32_t>> substitutes_;
    std::map<std::pair<std::string, Specialization>, std::unique_ptr<ComputePass>> compute_;
    std::map<std::tuple<std::string, std::string, Specialization>, std::unique_ptr<RasterPass>> raster_;
};

}  // namespace gno::host
