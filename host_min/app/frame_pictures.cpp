// SPDX-License-Identifier: MIT
#include "host_min/app/frame_pictures.hpp"

#include <algorithm>
#include <cmath>

#include "host_min/output/shade_picture.hpp"

namespace gno::host {
namespace {

std::vector<glm::vec3> xyz(const Image& image) {
    std::vector<glm::vec3> result;
    for (const glm::vec4& texel : image.downloadAs<glm::vec4>()) result.emplace_back(texel);
    return result;
}

}  // namespace

std::vector<uint8_t> narrowVisibility(const std::vector<uint32_t>& values) {
    std::vector<uint8_t> result;
    result.reserve(values.size());
    for (const uint32_t value : values) result.push_back(uint8_t(std::min(value, 255u)));
    return result;
}

Raster<glm::vec3> passingLight(const FrameInputs& inputs, const std::vector<glm::uvec3>& sumsOfPixels) {
    Raster<glm::vec3> passing(inputs.width(), inputs.height());
    for (size_t i = 0; i < sumsOfPixels.size(); ++i)
        for (int channel = 0; channel < 3; ++channel)
            passing.pixels[i][channel] = sumsOfPixels[i][channel] >= kNoLight ? 0.0f : std::exp2(-float(sumsOfPixels[i][channel]) / 65536.0f);
    return passing;
}

FramePictures::FramePictures(const FrameInputs& inputs, const SceneFile& file, const Light& light)
    : inputs_(inputs),
      light_(light),
      positions_(inputs.width(), inputs.height(), xyz(inputs.positions())),
      normals_(inputs.width(), inputs.height(), xyz(inputs.normals())),
      baseColors_(inputs.width(), inputs.height()),
      primitives_(inputs.primitives().downloadAs<uint32_t>()) {
    for (size_t i = 0; i < primitives_.size(); ++i) {
        isSample_.push_back(inputs.pixels()[i].own <= GNO_NO_CASTER);
        if (primitives_[i] != GNO_BACKGROUND) baseColors_.pixels[i] = glm::vec3(file.materials()[inputs.frame().material[primitives_[i]]].baseColor);
    }
}

Picture FramePictures::shaded(const Raster<uint8_t>& visibility, const Raster<glm::vec3>* passing) const {
    return shadePicture({positions_, normals_, baseColors_, visibility, light_.homogeneous, light_.color, {0, 1, 0}, inputs_.viewer(), passing});
}

Raster<uint8_t> FramePictures::wanted(const Raster<uint8_t>& visibility, const OracleAnswer& answer, bool withSums) const {
    Raster<uint8_t> want = visibility;
    size_t sample = 0;
    for (size_t i = 0; i < want.size(); ++i) {
        if (!isSample_[i]) continue;
        const bool dark = withSums ? answer.sums[sample] == glm::uvec3(kNoLight) : answer.inShadow[sample] != 0;
        want.pixels[i] = uint8_t(dark ? GNO_VISIBILITY_SHADOW : GNO_VISIBILITY_LIT);
        ++sample;
    }
    return want;
}

}  // namespace gno::host
