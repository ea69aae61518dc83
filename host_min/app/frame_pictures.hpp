// SPDX-License-Identifier: MIT
// The pictures of one frame and light that a visibility raster turns into.
#pragma once
#include <vector>

#include "host_min/output/image.hpp"
#include "host_min/techniques/technique.hpp"

namespace gno::host {

/// 8 bits are enough for GNO_VISIBILITY_*; what is more (a shader that wrote nothing) stays 255.
std::vector<uint8_t> narrowVisibility(const std::vector<uint32_t>& values);

/// Per pixel, the share of the light that the sums let pass, 0 to 1.
Raster<glm::vec3> passingLight(const FrameInputs& inputs, const std::vector<glm::uvec3>& sumsOfPixels);

class FramePictures {
public:
    /// Reads the G-buffer back. `inputs` has to live as long.
    FramePictures(const FrameInputs& inputs, const SceneFile& file, const Light& light);

    [[nodiscard]] const Raster<glm::vec3>& positions() const { return positions_; }
    [[nodiscard]] const Raster<glm::vec3>& normals() const { return normals_; }
    [[nodiscard]] const std::vector<uint32_t>& primitives() const { return primitives_; }
    [[nodiscard]] const std::vector<uint8_t>& isSample() const { return isSample_; }  ///< one per pixel

    /// `passing`: as in ShadeInputs, may be null.
    [[nodiscard]] Picture shaded(const Raster<uint8_t>& visibility, const Raster<glm::vec3>* passing) const;

    /// What the oracle wants to see: the visibility, with its answer at all samples. `withSums`: dark is where nothing arrives.
    [[nodiscard]] Raster<uint8_t> wanted(const Raster<uint8_t>& visibility, const OracleAnswer& answer, bool withSums) const;

private:
    const FrameInputs& inputs_;
    Light light_;
    Raster<glm::vec3> positions_, normals_, baseColors_;
    std::vector<uint32_t> primitives_;
    std::vector<uint8_t> isSample_;
};

}  // namespace gno::host
