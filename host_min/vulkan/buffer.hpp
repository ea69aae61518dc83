// SPDX-License-Identifier: MIT
// A device-local buffer with its memory; upload and read-back go through a staging buffer and wait.
#pragma once
#include <cstring>
#include <span>
#include <vector>

#include "host_min/vulkan/device.hpp"

namespace gno::host {

class Buffer {
public:
    /// `bytes` is rounded up to 16, so that an empty array still has a buffer. Throws LimitError when storage would pass
    /// maxStorageBufferRange, MemoryError when the device has no more.
    Buffer(const Device& device, uint64_t bytes, vk::BufferUsageFlags usage = vk::BufferUsageFlagBits::eStorageBuffer);

    [[nodiscard]] vk::Buffer handle() const { return *buffer_; }
    [[nodiscard]] uint64_t bytes() const { return bytes_; }

    [[nodiscard]] vk::DeviceAddress address() const;  ///< usage held eShaderDeviceAddress

    void upload(std::span<const std::byte> data, uint64_t offset = 0);
    void fill(uint32_t word);  ///< the whole buffer; tests poison outputs with it
    [[nodiscard]] std::vector<std::byte> download() const;

    template <class T>
    void upload(std::span<const T> data) {
        upload(std::as_bytes(data));
    }
    template <class T>
    [[nodiscard]] std::vector<T> downloadAs() const {
        const std::vector<std::byte> raw = download();
        std::vector<T> result(raw.size() / sizeof(T));
        std::memcpy(result.data(), raw.data(), result.size() * sizeof(T));
        return result;
    }

private:
    const Device* device_;
    uint64_t bytes_;
    vk::raii::Buffer buffer_{nullptr};
    vk::raii::DeviceMemory memory_{nullptr};
};

/// Host-visible memory behind a buffer, mapped for its life.
class StagingBuffer {
public:
    StagingBuffer(const Device& device, uint64_t bytes);
    [[nodiscard]] vk::Buffer handle() const { return *buffer_; }
    [[nodiscard]] std::byte* data() const { return data_; }

private:
    vk::raii::Buffer buffer_{nullptr};
    vk::raii::DeviceMemory memory_{nullptr};
    std::byte* data_ = nullptr;
};

}  // namespace gno::host
