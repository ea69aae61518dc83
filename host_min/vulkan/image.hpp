// SPDX-License-Identifier: MIT
// A two-dimensional device-local image, or an array of them, with its memory and views; always in the general layout once cleared.
#pragma once
#include <cstring>
#include <span>
#include <vector>

#include "host_min/vulkan/device.hpp"

namespace gno::host {

class Image {
public:
    /// Colour: storage, attachment and transfer; depth formats: attachment, sampled and read back. Contents are undefined until the first clear.
    Image(const Device& device, uint32_t width, uint32_t height, vk::Format format);
    /// The same with `layers` layers; shaders see an array, even of one.
    static Image array(const Device& device, uint32_t width, uint32_t height, vk::Format format, uint32_t layers);

    [[nodiscard]] vk::Image handle() const { return *image_; }
    [[nodiscard]] vk::ImageView view() const { return *view_; }                                 ///< all layers
    [[nodiscard]] vk::ImageView layer(uint32_t index) const { return *layerViews_.at(index); }  ///< one of an array
    [[nodiscard]] uint32_t layers() const { return layers_; }
    [[nodiscard]] vk::Format format() const { return format_; }
    [[nodiscard]] vk::Extent2D extent() const { return {width_, height_}; }
    [[nodiscard]] vk::ImageAspectFlags aspect() const { return aspect_; }
    [[nodiscard]] uint32_t texelBytes() const { return texelBytes_; }

    void clear(vk::ClearColorValue value);         ///< colour only; moves the image to the general layout; waits
    void upload(std::span<const std::byte> rows);  ///< all texels, rows top to bottom, tightly packed; the image is in the general layout; waits
    [[nodiscard]] std::vector<std::byte> download(uint32_t layer = 0) const;  ///< rows top to bottom, tightly packed

    template <class T>
    [[nodiscard]] std::vector<T> downloadAs() const {
        const std::vector<std::byte> raw = download();
        std::vector<T> result(raw.size() / sizeof(T));
        std::memcpy(result.data(), raw.data(), result.size() * sizeof(T));
        return result;
    }

private:
    Image(const Device& device, uint32_t width, uint32_t height, vk::Format format, uint32_t layers, vk::ImageViewType type);

    const Device* device_;
    uint32_t width_, height_, layers_, texelBytes_;
    vk::Format format_;
    vk::ImageAspectFlags aspect_;
    vk::raii::Image image_{nullptr};
    vk::raii::DeviceMemory memory_{nullptr};
    vk::raii::ImageView view_{nullptr};
    std::vector<vk::raii::ImageView> layerViews_;
};

}  // namespace gno::host
