// SPDX-License-Identifier: MIT
// What every technique sees of one frame and one light: casters, their state, view samples. A technique never sees glTF.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "glsl/core/shared_types.h"
#include "host_min/frame/cull_front.hpp"
#include "host_min/frame/example_push.hpp"
#include "host_min/frame/materials.hpp"
#include "host_min/oracle.hpp"
#include "host_min/scene/scene.hpp"
#include "host_min/vulkan/buffer.hpp"
#include "host_min/vulkan/image.hpp"
#include "host_min/vulkan/pass_cache.hpp"
#include "host_min/vulkan/recording.hpp"

namespace gno::host {

enum class Cull : uint32_t { none = 0, front = 1, hull = 2, all = 3 };  ///< GNO_CULL_* bits of core/caster_state.glsl

class FrameInputs {
public:
    /// Uploads the casters and rasterises the G-buffer. Throws InputError when a buffer would pass the device's limits.
    FrameInputs(PassCache& passes, const Frame& frame, uint32_t width, uint32_t height);

    /// The same without a camera: given view samples, already on the grid and off their own planes, one pixel each in rows of `width`; what the last
    /// row lacks is background. Hull culling knows no frustum then and drops nothing.
    FrameInputs(PassCache& passes, const Frame& frame, std::span<const OracleSample> samples, uint32_t width = 64);

    /// Makes view samples (unless they were given) and caster states for a homogeneous light on the grid. Front-face culling leaves meshes whole for
    /// which it would not be legal (cull_front.hpp). Where samples are given, nobody judges that: it drops what Frame::closed allows.
    void setLight(glm::vec4 light, Cull cull);

    [[nodiscard]] PassCache& passes() const { return passes_; }
    [[nodiscard]] const Device& device() const { return passes_.device(); }
    [[nodiscard]] const Frame& frame() const { return frame_; }
    [[nodiscard]] uint32_t width() const { return width_; }
    [[nodiscard]] uint32_t height() const { return height_; }
    [[nodiscard]] uint32_t triangleCount() const { return uint32_t(frame_.triangles.size()); }
    [[nodiscard]] glm::vec4 light() const { return light_; }
    [[nodiscard]] glm::vec4 viewer() const { return glm::vec4(frame_.camera.viewer()); }

    [[nodiscard]] const Buffer& casters() const { return casters_; }  ///< float[9 n], glsl/core/bindings.glsl
    [[nodiscard]] const Buffer& states() const { return states_; }    ///< uint[n], glsl/core/caster_state.glsl
    [[nodiscard]] const Image& samples() const { return samples_; }   ///< rgba32ui, glsl/core/sample.glsl
    [[nodiscard]] const Image& positions() const { return positions_; }
    [[nodiscard]] const Image& normals() const { return normals_; }
    [[nodiscard]] const Image& primitives() const { return primitives_; }
    [[nodiscard]] const Image& depth() const { return depth_; }
    /// What the G-buffer was drawn with: the camera's, its near and far plane drawn close about the scene.
    [[nodiscard]] glm::dmat4 clipFromGrid() const;
    [[nodiscard]] ExamplePush push(uint32_t seed = 0) const;
    /// Casters, states and samples by their names in the shaders, behind `others`.
    [[nodiscard]] std::vector<Binding> withCasters(std::vector<Binding> others) const;

    /// Some casters are alpha-tested or coloured; without them nobody makes buffers or pipelines for that.
    [[nodiscard]] bool hasMaterials() const { return !frame_.surfaces.empty(); }
    /// Made by the first call; hasMaterials() only. Throws InputError when a buffer would pass the device's limits.
    [[nodiscard]] const MaterialBuffers& materials() const;

    /// One entry per pixel, as the techniques see it: own may be GNO_FACING_AWAY or GNO_BACKGROUND.
    [[nodiscard]] const std::vector<OracleSample>& pixels() const { return pixels_; }
    [[nodiscard]] uint64_t sampleCount() const { return sampleCount_; }
    [[nodiscard]] uint64_t facingAwayCount() const { return facingAwayCount_; }
    [[nodiscard]] uint64_t casterCount() const { return casterCount_; }  ///< kept and not edge-on
    [[nodiscard]] PassTime casterSetUp() const { return casterSetUp_; }  ///< device time of the last setLight's caster pass
    /// Which closed meshes the last setLight left whole under front-face culling, and why, in one line; empty when none.
    [[nodiscard]] const std::string& leftWhole() const { return leftWhole_; }

private:
    FrameInputs(PassCache& passes, const Frame& frame, uint32_t width, uint32_t height, bool givenSamples);  // all but the samples
    void rasterise();

    PassCache& passes_;
    const Frame& frame_;
    uint32_t width_, height_;
    bool givenSamples_;
    Buffer casters_, states_, closed_, oneSided_, camera_, planes_;
    Image positions_, normals_, primitives_, depth_, samples_;
    mutable std::optional<MaterialBuffers> materials_;
    glm::vec4 light_{0};
    Cull cull_ = Cull::none;
    uint32_t planeCount_ = 0;
    std::optional<FrontCull> frontCull_;  // made when it is first asked for
    std::string leftWhole_;
    std::vector<OracleSample> pixels_;
    uint64_t sampleCount_ = 0, facingAwayCount_ = 0, casterCount_ = 0;
    PassTime casterSetUp_{"caster_setup", 0};
};

/// Throws InputError unless 1 <= width, height and both fit the device and 8192.
void checkSize(const DeviceFacts& device, uint64_t width, uint64_t height);

}  // namespace gno::host
