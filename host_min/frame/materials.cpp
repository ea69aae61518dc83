// SPDX-License-Identifier: MIT
#include "host_min/frame/materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "host_min/error.hpp"

namespace gno::host {
namespace {

uint32_t rounded(double value) { return static_cast<uint32_t>(std::floor(std::min(value, 4294967295.0) + 0.5)); }

uint32_t wrapBits(Wrap wrap) {
    switch (wrap) {
        case Wrap::repeat:
            return GNO_WRAP_REPEAT;
        case Wrap::mirrored:
            return GNO_WRAP_MIRRORED;
        case Wrap::clamp:
            return GNO_WRAP_CLAMP;
    }
    return GNO_WRAP_REPEAT;
}

std::array<uint8_t, 256> linearTable() {
    std::array<uint8_t, 256> table{};
    for (size_t i = 0; i < table.size(); ++i) table[i] = linearChannel(static_cast<uint8_t>(i));
    return table;
}

uint64_t texelCount(const MaterialSet& look) {
    uint64_t count = 0;
    for (const TextureImage& image : look.images) count += uint64_t{image.width} * image.height;
    return count;
}

uint64_t checkedTexelBytes(const Device& device, const MaterialSet& look) {
    const uint64_t bytes = 4 * texelCount(look), limit = device.facts().maxStorageBufferRange;
    if (bytes > limit)
        throw LimitError(
            fmt::format("the images of casters that are not opaque have {} texels, over the limit of {} that the device's "
                        "maxStorageBufferRange sets: use smaller images",
                        bytes / 4, limit / 4));
    return bytes;
}

std::vector<GnoSurface> packSurfaces(const std::vector<Surface>& surfaces) {
    std::vector<GnoSurface> packed;
    packed.reserve(surfaces.size());
    for (const Surface& s : surfaces) packed.push_back({s.corners[0], s.corners[1], s.corners[2], s.material, 0});
    return packed;
}

}  // namespace

GnoMaterial packMaterial(const Material& from, const TextureImage* image, uint32_t firstTexel) {
    GnoMaterial to{};
    to.kind = from.alpha == Material::Alpha::mask    ? GNO_MATERIAL_MASK
              : from.alpha == Material::Alpha::blend ? GNO_MATERIAL_BLEND
                                                     : GNO_MATERIAL_SOLID;
    to.kind |= wrapBits(from.wrapU) << GNO_MATERIAL_WRAP_U | wrapBits(from.wrapV) << GNO_MATERIAL_WRAP_V;
    if (from.linearFilter) to.kind |= GNO_MATERIAL_LINEAR;
    if (image != nullptr) {
        to.width = image->width;
        to.height = image->height;
        to.firstTexel = firstTexel;
    }
    const auto factor = [&](int i) { return rounded(double{from.baseColor[i]} * 65535); };
    to.red = factor(0);
    to.green = factor(1);
    to.blue = factor(2);
    to.alpha = factor(3);
    to.cutoff = rounded(double{from.alphaCutoff} * 255 * 65535);
    to.transmission = rounded(double{from.transmission} * 255);
    return to;
}

std::vector<uint32_t> packTexels(const TextureImage& image) {
    static const std::array<uint8_t, 256> linear = linearTable();
    std::vector<uint32_t> texels(image.rgba.size() / 4);
    for (size_t i = 0; i < texels.size(); ++i) {
        const uint8_t* c = &image.rgba[4 * i];
        const auto channel = [&](int k) { return uint32_t{image.isLinear ? c[k] : linear[c[k]]} << 8 * k; };
        texels[i] = channel(0) | channel(1) | channel(2) | uint32_t{c[3]} << 24;
    }
    return texels;
}

MaterialBuffers::MaterialBuffers(const Device& device, const Frame& frame)
    : of_(device, frame.surfaceOf.size() * sizeof(uint32_t)),
      surfaces_(device, frame.surfaces.size() * sizeof(GnoSurface)),
      list_(device, frame.look->materials.size() * sizeof(GnoMaterial)),
      texels_(device, checkedTexelBytes(device, *frame.look)) {
    std::vector<uint32_t> texels, firstTexels;
    for (const TextureImage& image : frame.look->images) {
        firstTexels.push_back(static_cast<uint32_t>(texels.size()));
        const std::vector<uint32_t> packed = packTexels(image);
        texels.insert(texels.end(), packed.begin(), packed.end());
    }
    std::vector<GnoMaterial> materials;
    for (const Material& material : frame.look->materials) {
        const auto image = static_cast<size_t>(std::max(material.image, 0));
        materials.push_back(material.image < 0 ? packMaterial(material, nullptr, 0)
                                               : packMaterial(material, &frame.look->images[image], firstTexels[image]));
    }
    of_.upload(std::span<const uint32_t>(frame.surfaceOf));
    surfaces_.upload(std::span<const GnoSurface>(packSurfaces(frame.surfaces)));
    list_.upload(std::span<const GnoMaterial>(materials));
    texels_.upload(std::span<const uint32_t>(texels));
}

}  // namespace gno::host
