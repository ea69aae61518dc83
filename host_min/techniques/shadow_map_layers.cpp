// SPDX-License-Identifier: MIT
#include "host_min/techniques/shadow_map_layers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host_min/error.hpp"

namespace gno::host {
namespace {

/// Header and views, as glsl/shadow_map/bindings.glsl reads them.
void upload(Buffer& buffer, std::span<const ShadowFrustum> frusta, uint32_t size, float constantBias) {
    const GnoShadowMapHeader header{uint32_t(frusta.size()), size, gnoState(GNO_STATE_ANY), 0};
    std::vector<GnoShadowMapView> views;
    for (const ShadowFrustum& frustum : frusta) views.push_back(gnoShadowMapConstantBias(frustum.view(), constantBias, float(size)));
    buffer.upload(std::as_bytes(std::span(&header, 1)));
    buffer.upload(std::as_bytes(std::span(views)), sizeof header);
}

}  // namespace

std::string shadowMapOverLimit(const DeviceFacts& device, uint32_t size) {
    const uint32_t limit = device.maxImageDimension2D;
    return size > limit ? fmt::format("--set map={}: over the device's maxImageDimension2D ({}): use a smaller map", size, limit) : std::string();
}

void ShadowMapLayers::prepare(const FrameInputs& inputs) {
    throwLimit(shadowMapOverLimit(inputs.device().facts(), options_.size));
    inputs_ = &inputs;
    whole_ = shadowFrusta(inputs.frame(), inputs.light());
    arrays_.fit(inputs.device(), shadowMapArrays(whole_.size()));
    upload(arrays_["gnoShadowMapWholeViews"], whole_, 1, 0);
    fit_ = PassRunner(inputs.passes(), shadowMapFitPasses(inputs.width(), inputs.height()), inputs.withCasters(arrays_.bindings()));
}

void ShadowMapLayers::record(Recording& recording, uint32_t segment) const { (segment == 0 ? fit_ : draw_).record(recording, inputs_->push()); }

void ShadowMapLayers::between(uint32_t) {
    fitted_ = fitShadowFrusta(whole_, arrays_["gnoShadowMapBounds"].downloadAs<uint32_t>(), inputs_->frame().triangles, focused_);
    const uint32_t side = fitted_.empty() ? 1 : options_.size;
    upload(arrays_["gnoShadowMapViews"], fitted_, side, options_.constantBias);
    fitMap(side, std::max(1u, viewCount()));
    draw_ = PassRunner(inputs_->passes(), shadowMapBuildPasses(inputs_->triangleCount(), viewCount(), options_), inputs_->withCasters(bindings()),
                       {.slopeBias = -options_.slopeBias});
}

void ShadowMapLayers::fitMap(uint32_t side, uint32_t layers) {
    if (map_ && map_->extent().width == side && map_->layers() == layers) return;
    map_.reset();  // before the new one: there may not be room for both
    try {
        map_.emplace(Image::array(inputs_->device(), side, side, vk::Format::eD32Sfloat, layers));
    } catch (const LimitError& error) {
        throw LimitError(fmt::format("--set map={}: {} views do not fit: {}", side, layers, error.what()));
    } catch (const MemoryError& error) {
        throw MemoryError(fmt::format("--set map={}: {} views do not fit: {}", side, layers, error.what()));
    }
    Recording recording(inputs_->device());
    recording.toGeneral(*map_);
    recording.submit();
}

std::vector<Binding> ShadowMapLayers::bindings() const {
    std::vector<Binding> all = arrays_.bindings();
    all.push_back({"gnoShadowMap", &*map_});
    return all;
}

uint64_t ShadowMapLayers::texels() const { return uint64_t(map_->extent().width) * map_->extent().height * map_->layers(); }

}  // namespace gno::host
