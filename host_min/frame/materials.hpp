// SPDX-License-Identifier: MIT
// A frame's casters that are not opaque, as buffers of glsl/core/material_bindings.glsl. Only frames that have some make them.
#pragma once
#include <vector>

#include "glsl/core/material.h"
#include "host_min/scene/scene.hpp"
#include "host_min/vulkan/buffer.hpp"

namespace gno::host {

/// Numbers rounded to the integers of core/material.h; a half goes up.
GnoMaterial packMaterial(const Material& material, const TextureImage* image, uint32_t firstTexel);

/// Texels of core/material.h: linearChannel of each of red, green and blue, or as they are where the image is linear; alpha as it is.
std::vector<uint32_t> packTexels(const TextureImage& image);

class MaterialBuffers {
public:
    /// `frame` has surfaces. Throws InputError when the texels are more than the device's maxStorageBufferRange holds.
    MaterialBuffers(const Device& device, const Frame& frame);

    [[nodiscard]] const Buffer& of() const { return of_; }              ///< gnoMaterialOf, uint[casters]
    [[nodiscard]] const Buffer& surfaces() const { return surfaces_; }  ///< gnoSurfaces
    [[nodiscard]] const Buffer& list() const { return list_; }          ///< gnoMaterials
    [[nodiscard]] const Buffer& texels() const { return texels_; }      ///< gnoTexels
    [[nodiscard]] uint64_t bytes() const { return of_.bytes() + surfaces_.bytes() + list_.bytes() + texels_.bytes(); }

private:
    Buffer of_, surfaces_, list_, texels_;
};

}  // namespace gno::host
