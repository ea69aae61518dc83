// SPDX-License-Identifier: MIT
// The shadow map of one light on the device, by the pass lists of glsl/shadow_map/passes.hpp: views fitted to the view samples, a layer drawn for
// each of them. The host waits once a frame, for the bounds of the samples.
#pragma once
#include <optional>
#include <vector>

#include "glsl/shadow_map/passes.hpp"
#include "host_min/frame/pass_runner.hpp"
#include "host_min/techniques/array_buffers.hpp"
#include "host_min/techniques/shadow_views.hpp"
#include "host_min/techniques/structure.hpp"
#include "host_min/vulkan/image.hpp"

namespace gno::host {

/// Why the device has no map of `size` texels along a side, and what to do; empty: it has.
std::string shadowMapOverLimit(const DeviceFacts& device, uint32_t size);

class ShadowMapLayers final : public Structure {
public:
    /// focused: a view covers just the view samples, otherwise all that the light sees.
    ShadowMapLayers(const ShadowMapOptions& options, bool focused) : options_(options), focused_(focused) {}

    void prepare(const FrameInputs& inputs) override;
    [[nodiscard]] uint32_t segments() const override { return 2; }
    void record(Recording& recording, uint32_t segment) const override;
    void between(uint32_t segment) override;

    [[nodiscard]] std::vector<Binding> bindings() const;
    [[nodiscard]] const Buffer& views() const { return arrays_["gnoShadowMapViews"]; }
    [[nodiscard]] const Image& map() const { return *map_; }
    [[nodiscard]] uint32_t viewCount() const { return uint32_t(fitted_.size()); }
    [[nodiscard]] uint64_t texels() const;

private:
    void fitMap(uint32_t side, uint32_t layers);

    ShadowMapOptions options_;
    bool focused_;
    const FrameInputs* inputs_ = nullptr;
    ArrayBuffers arrays_;
    std::vector<ShadowFrustum> whole_, fitted_;
    std::optional<Image> map_;
    PassRunner fit_, draw_;
};

}  // namespace gno::host
