// SPDX-License-Identifier: MIT
#include "host_min/vulkan/recording.hpp"

#include <array>
#include <limits>

#include "host_min/error.hpp"
#include "host_min/vulkan/faults.hpp"
#include "host_min/vulkan/image.hpp"

namespace gno::host {
namespace {
constexpr uint32_t kMaxPasses = 32;

/// Between two time stamps of so many bits, which begin anew when they are full.
double ticksBetween(uint64_t first, uint64_t last, uint32_t bits) {
    return double((last - first) & (bits >= 64 ? ~uint64_t(0) : (uint64_t(1) << bits) - 1));
}
}  // namespace

Recording::Recording(const Device& device)
    : device_(device), pool_(device.handle(), vk::CommandPoolCreateInfo(vk::CommandPoolCreateFlagBits::eTransient, device.queueFamily())) {
    commands_ = std::move(vk::raii::CommandBuffers(device.handle(), {*pool_, vk::CommandBufferLevel::ePrimary, 1}).front());
    commands_.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
}

void Recording::barrier(const MemoryBarrier& words) {
    const vk::MemoryBarrier2 memory{vk::PipelineStageFlags2(words.srcStages), vk::AccessFlags2(words.srcAccess),
                                    vk::PipelineStageFlags2(words.dstStages), vk::AccessFlags2(words.dstAccess)};
    commands_.pipelineBarrier2(vk::DependencyInfo({}, memory));
}

void Recording::barrier() {
    using Stage = vk::PipelineStageFlagBits2;
    using Access = vk::AccessFlagBits2;
    const vk::MemoryBarrier2 memory(Stage::eAllCommands, Access::eMemoryWrite, Stage::eAllCommands, Access::eMemoryRead | Access::eMemoryWrite);
    commands_.pipelineBarrier2(vk::DependencyInfo({}, memory));
}

void Recording::toGeneral(const Image& image) {
    using Stage = vk::PipelineStageFlagBits2;
    using Access = vk::AccessFlagBits2;
    const vk::ImageMemoryBarrier2 transition(
        Stage::eAllCommands, Access::eMemoryWrite, Stage::eAllCommands, Access::eMemoryRead | Access::eMemoryWrite, vk::ImageLayout::eUndefined,
        vk::ImageLayout::eGeneral, VK_QUEUE_FAMILY_IGNORED, VK_QUEUE_FAMILY_IGNORED, image.handle(), {image.aspect(), 0, 1, 0, image.layers()});
    commands_.pipelineBarrier2(vk::DependencyInfo({}, {}, {}, transition));
}

void Recording::beginPass(std::string name) {
    const bool timed = device_.facts().timestampValidBits > 0;
    if (passes_.empty() && timed) {
        queries_ = vk::raii::QueryPool(device_.handle(), vk::QueryPoolCreateInfo({}, vk::QueryType::eTimestamp, 2 * kMaxPasses));
        commands_.resetQueryPool(*queries_, 0, 2 * kMaxPasses);
    }
    if (passes_.size() == kMaxPasses) throw WorkError("more passes in one recording than time stamps");
    barrier();
    if (timed) commands_.writeTimestamp2(vk::PipelineStageFlagBits2::eAllCommands, *queries_, uint32_t(2 * passes_.size()));
    passes_.push_back(std::move(name));
}

void Recording::endPass() {
    if (device_.facts().timestampValidBits > 0)
        commands_.writeTimestamp2(vk::PipelineStageFlagBits2::eAllCommands, *queries_, uint32_t(2 * passes_.size() - 1));
    barrier();
}

std::vector<PassTime> Recording::submit() {
    using Stage = vk::PipelineStageFlagBits2;
    using Access = vk::AccessFlagBits2;
    const vk::MemoryBarrier2 toHost(Stage::eAllCommands, Access::eMemoryWrite, Stage::eHost, Access::eHostRead);
    commands_.pipelineBarrier2(vk::DependencyInfo({}, toHost));
    commands_.end();
    const vk::CommandBufferSubmitInfo buffer(*commands_);
    try {
        const vk::raii::Fence fence(device_.handle(), vk::FenceCreateInfo());
        device_.queue().submit2(vk::SubmitInfo2({}, {}, buffer), *fence);
        if (device_.handle().waitForFences(*fence, VK_TRUE, UINT64_MAX) != vk::Result::eSuccess) throw WorkError("waiting for the device failed");
        return times();
    } catch (const vk::SystemError&) {
        rethrowVulkanFault();
    }
}

std::vector<PassTime> Recording::times() {
    std::vector<PassTime> times;
    const uint32_t bits = device_.facts().timestampValidBits;
    if (bits == 0)
        for (const std::string& pass : passes_) times.push_back({pass, std::numeric_limits<double>::quiet_NaN()});
    else if (!passes_.empty()) {
        const auto [result, ticks] = queries_.getResults<uint64_t>(0, uint32_t(2 * passes_.size()), 16 * passes_.size(), 8,
                                                                   vk::QueryResultFlagBits::e64 | vk::QueryResultFlagBits::eWait);
        if (result != vk::Result::eSuccess) throw WorkError("reading time stamps failed");
        for (size_t i = 0; i < passes_.size(); ++i)
            times.push_back({passes_[i], ticksBetween(ticks[2 * i], ticks[2 * i + 1], bits) * device_.timestampPeriod() * 1e-6});
    }
    return times;
}

}  // namespace gno::host
