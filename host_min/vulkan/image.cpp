// SPDX-License-Identifier: MIT
#include "host_min/vulkan/image.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host_min/error.hpp"
#include "host_min/vulkan/buffer.hpp"
#include "host_min/vulkan/recording.hpp"

namespace gno::host {
namespace {

uint32_t bytesOf(vk::Format format) {
    switch (format) {
        case vk::Format::eR32G32B32A32Sfloat:
        case vk::Format::eR32G32B32A32Uint:
            return 16;
        case vk::Format::eR32Uint:
        case vk::Format::eR32Sfloat:
        case vk::Format::eD32Sfloat:
            return 4;
        default:
            throw WorkError(fmt::format("image format {} is not in use here", vk::to_string(format)));
    }
}

}  // namespace

Image::Image(const Device& device, uint32_t width, uint32_t height, vk::Format format)
    : Image(device, width, height, format, 1, vk::ImageViewType::e2D) {}

Image Image::array(const Device& device, uint32_t width, uint32_t height, vk::Format format, uint32_t layers) {
    return {device, width, height, format, layers, vk::ImageViewType::e2DArray};
}

Image::Image(const Device& device, uint32_t width, uint32_t height, vk::Format format, uint32_t layers, vk::ImageViewType type)
    : device_(&device), width_(width), height_(height), layers_(layers), texelBytes_(bytesOf(format)), format_(format) {
    const bool depth = format == vk::Format::eD32Sfloat;
    aspect_ = depth ? vk::ImageAspectFlagBits::eDepth : vk::ImageAspectFlagBits::eColor;
    using Usage = vk::ImageUsageFlagBits;
    const vk::ImageUsageFlags usage = depth ? Usage::eDepthStencilAttachment | Usage::eSampled | Usage::eTransferSrc
                                            : Usage::eStorage | Usage::eColorAttachment | Usage::eTransferSrc | Usage::eTransferDst;
    const vk::ImageFormatProperties limits =
        device.physical().getImageFormatProperties(format, vk::ImageType::e2D, vk::ImageTiling::eOptimal, usage);
    const uint64_t bytes = uint64_t(width) * height * layers * texelBytes_;
    if (layers > limits.maxArrayLayers || bytes > limits.maxResourceSize)
        throw LimitError(fmt::format("an image of {} bytes in {} layers is over the device's maxResourceSize ({}) or maxArrayLayers ({})", bytes,
                                     layers, limits.maxResourceSize, limits.maxArrayLayers));
    image_ = vk::raii::Image(device.handle(), vk::ImageCreateInfo({}, vk::ImageType::e2D, format, vk::Extent3D(width, height, 1), 1, layers,
                                                                  vk::SampleCountFlagBits::e1, vk::ImageTiling::eOptimal, usage));
    const vk::MemoryRequirements needs = image_.getMemoryRequirements();
    try {
        memory_ = vk::raii::DeviceMemory(
            device.handle(), vk::MemoryAllocateInfo(needs.size, device.memoryType(needs.memoryTypeBits, vk::MemoryPropertyFlagBits::eDeviceLocal)));
    } catch (const vk::OutOfDeviceMemoryError&) {
        throw MemoryError(fmt::format("no device memory left for an image of {} bytes: use a smaller --size", needs.size));
    }
    image_.bindMemory(*memory_, 0);
    view_ = vk::raii::ImageView(device.handle(), vk::ImageViewCreateInfo({}, *image_, type, format, {}, {aspect_, 0, 1, 0, layers}));
    if (type == vk::ImageViewType::e2D) return;
    for (uint32_t i = 0; i < layers; ++i)
        layerViews_.emplace_back(device.handle(), vk::ImageViewCreateInfo({}, *image_, vk::ImageViewType::e2D, format, {}, {aspect_, 0, 1, i, 1}));
}

void Image::clear(vk::ClearColorValue value) {
    Recording recording(*device_);
    recording.toGeneral(*this);
    recording.commands().clearColorImage(*image_, vk::ImageLayout::eGeneral, value, vk::ImageSubresourceRange(aspect_, 0, 1, 0, layers_));
    recording.submit();
}

void Image::upload(std::span<const std::byte> texels) {
    const uint64_t row = uint64_t(width_) * texelBytes_;
    if (texels.size() != row * height_) throw WorkError("an image upload of the wrong size");
    const uint32_t rows = uint32_t(std::clamp<uint64_t>((64u << 20) / row, 1, height_));
    const StagingBuffer staging(*device_, row * rows);
    for (uint32_t y = 0; y < height_; y += rows) {
        const uint32_t count = std::min(rows, height_ - y);
        std::memcpy(staging.data(), texels.data() + y * row, count * row);
        Recording recording(*device_);
        const vk::BufferImageCopy region(0, 0, 0, {aspect_, 0, 0, 1}, {0, int32_t(y), 0}, {width_, count, 1});
        recording.commands().copyBufferToImage(staging.handle(), *image_, vk::ImageLayout::eGeneral, region);
        recording.submit();
    }
}

std::vector<std::byte> Image::download(uint32_t layer) const {
    const uint64_t row = uint64_t(width_) * texelBytes_;
    std::vector<std::byte> result(row * height_);
    const uint32_t rows = uint32_t(std::clamp<uint64_t>((64u << 20) / row, 1, height_));
    const StagingBuffer staging(*device_, row * rows);
    for (uint32_t y = 0; y < height_; y += rows) {
        const uint32_t count = std::min(rows, height_ - y);
        Recording recording(*device_);
        const vk::BufferImageCopy region(0, 0, 0, {aspect_, 0, layer, 1}, {0, int32_t(y), 0}, {width_, count, 1});
        recording.commands().copyImageToBuffer(*image_, vk::ImageLayout::eGeneral, staging.handle(), region);
        recording.submit();
        std::memcpy(result.data() + y * row, staging.data(), count * row);
    }
    return result;
}

}  // namespace gno::host
