// SPDX-License-Identifier: MIT
#include "host_min/vulkan/pass_cache.hpp"

namespace gno::host {

const ComputePass& PassCache::compute(const std::string& shader, const Specialization& constants) {
    auto& pass = compute_[{shader, constants}];
    if (pass) return *pass;
    const auto other = substitutes_.find(shader);
    pass = other == substitutes_.end() ? std::make_unique<ComputePass>(device_, shader, constants)
                                       : std::make_unique<ComputePass>(device_, std::span<const uint32_t>(other->second), constants);
    return *pass;
}

const RasterPass& PassCache::raster(const std::string& vertex, const std::string& fragment, std::span<const vk::Format> colors, bool depth,
                                    const Specialization& constants) {
    auto& pass = raster_[{vertex, fragment, constants}];
    if (!pass) pass = std::make_unique<RasterPass>(device_, vertex, fragment, colors, depth, constants);
    return *pass;
}

}  // namespace gno::host
