// SPDX-License-Identifier: MIT
#include "host_min/vulkan/buffer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host_min/error.hpp"
#include "host_min/vulkan/recording.hpp"

namespace gno::host {
namespace {

constexpr uint64_t kStagingBytes = 64u << 20;  // larger transfers go in pieces

vk::raii::DeviceMemory allocate(const Device& device, const vk::MemoryRequirements& needs, vk::MemoryPropertyFlags wanted,
                                vk::MemoryAllocateFlags flags = {}) {
    const vk::MemoryAllocateFlagsInfo more(flags);
    try {
        return {device.handle(), vk::MemoryAllocateInfo(needs.size, device.memoryType(needs.memoryTypeBits, wanted), flags ? &more : nullptr)};
    } catch (const vk::OutOfDeviceMemoryError&) {
        throw MemoryError(fmt::format("the device has no memory left for {} bytes: use a smaller --size or scene", needs.size));
    } catch (const vk::OutOfHostMemoryError&) {
        throw MemoryError(fmt::format("no memory left for {} bytes: use a smaller --size or scene", needs.size));
    }
}

}  // namespace

Buffer::Buffer(const Device& device, uint64_t bytes, vk::BufferUsageFlags usage)
    : device_(&device), bytes_((std::max<uint64_t>(bytes, 1) + 15) / 16 * 16) {
    if ((usage & vk::BufferUsageFlagBits::eStorageBuffer) && bytes_ > device.facts().maxStorageBufferRange)
        throw LimitError(fmt::format("a buffer of {} bytes is over the device's maxStorageBufferRange ({}): use a smaller scene or --size", bytes_,
                                     device.facts().maxStorageBufferRange));
    usage |= vk::BufferUsageFlagBits::eTransferSrc | vk::BufferUsageFlagBits::eTransferDst;
    buffer_ = vk::raii::Buffer(device.handle(), vk::BufferCreateInfo({}, bytes_, usage));
    const bool hasAddress = bool(usage & vk::BufferUsageFlagBits::eShaderDeviceAddress);
    memory_ = allocate(device, buffer_.getMemoryRequirements(), vk::MemoryPropertyFlagBits::eDeviceLocal,
                       hasAddress ? vk::MemoryAllocateFlagBits::eDeviceAddress : vk::MemoryAllocateFlags());
    buffer_.bindMemory(*memory_, 0);
}

vk::DeviceAddress Buffer::address() const { return device_->handle().getBufferAddress(vk::BufferDeviceAddressInfo(*buffer_)); }

void Buffer::upload(std::span<const std::byte> data, uint64_t offset) {
    if (data.empty()) return;
    if (offset + data.size() > bytes_) throw WorkError("upload past the end of a buffer");
    const StagingBuffer staging(*device_, std::min<uint64_t>(data.size(), kStagingBytes));
    for (uint64_t at = 0; at < data.size(); at += kStagingBytes) {
        const uint64_t size = std::min<uint64_t>(kStagingBytes, data.size() - at);
        std::memcpy(staging.data(), data.data() + at, size);
        Recording recording(*device_);
        recording.commands().copyBuffer(staging.handle(), *buffer_, vk::BufferCopy(0, offset + at, size));
        recording.submit();
    }
}

void Buffer::fill(uint32_t word) {
    Recording recording(*device_);
    recording.commands().fillBuffer(*buffer_, 0, VK_WHOLE_SIZE, word);
    recording.submit();
}

std::vector<std::byte> Buffer::download() const {
    std::vector<std::byte> result(bytes_);
    const StagingBuffer staging(*device_, std::min(bytes_, kStagingBytes));
    for (uint64_t at = 0; at < bytes_; at += kStagingBytes) {
        const uint64_t size = std::min(kStagingBytes, bytes_ - at);
        Recording recording(*device_);
        recording.commands().copyBuffer(*buffer_, staging.handle(), vk::BufferCopy(at, 0, size));
        recording.submit();
        std::memcpy(result.data() + at, staging.data(), size);
    }
    return result;
}

StagingBuffer::StagingBuffer(const Device& device, uint64_t bytes)
    : buffer_(device.handle(), vk::BufferCreateInfo({}, bytes, vk::BufferUsageFlagBits::eTransferSrc | vk::BufferUsageFlagBits::eTransferDst)),
      memory_(
          allocate(device, buffer_.getMemoryRequirements(), vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent)) {
    buffer_.bindMemory(*memory_, 0);
    data_ = static_cast<std::byte*>(memory_.mapMemory(0, VK_WHOLE_SIZE));
}

}  // namespace gno::host
