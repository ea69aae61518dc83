// SPDX-License-Identifier: MIT
// A two-dimensional device-local image with its memory and view, always in the general layout once cleared.
#pragma once
#include <cstring>
#include <span>
#include <vector>

#include "host_min/vulkan/device.hpp"

namespace gno::host {

class Image {
public:
    /// Colour: storage, attachment and transfer; depth formats: attachment only. Contents are undefined until the first clear.
    Image(const Device& device, uint32_t width, uint32_t height, vk::Format format);

    [[nodiscard]] vk::Image handle() const { return *image_; }
    [[nodiscard]] vk::ImageView view() const { return *view_; }
    [[nodiscard]] vk::Format format() const { return format_; }
    [[nodiscard]] vk::Extent2D extent() const { return {width_, height_}; }
    [[nodiscard]] vk::ImageAspectFlags aspect() const { return aspect_; }
    [[nodiscard]] uint32_t texelBytes() const { return texelBytes_; }

    void clear(vk::ClearColorValue value);  ///< colour only; moves the image to the general layout; waits
    void upload(std::span<const std::byte> rows);           ///< all texels, rows top to bottom, tightly packed; the image is in the general layout; waits
    [[nodiscard]] std::vector<std::byte> download() const;  ///< rows top to bottom, tightly packed

    template <class T>
    [[nodiscard]] std::vector<T> downloadAs() const {
        const std::vector<std::byte> raw = download();
        std::vector<T> result(raw.size() / sizeof(T));
        std::memcpy(result.data(), raw.data(), result.size() * sizeof(T));
        return result;
    }

private:
    const Device* device_;
    uint32_t width_, height_, texelBytes_;
    vk::Format format_;
    vk::ImageAspectFlags aspect_;
    vk::raii::Image image_{nullptr};
    vk::raii::DeviceMemory memory_{nullptr};
    vk::raii::ImageView view_{nullptr};
};

}  // namespace gno::host
