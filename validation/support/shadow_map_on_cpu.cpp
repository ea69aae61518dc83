// SPDX-License-Identifier: MIT
// One variant: GNO_SHADOW_MAP_VARIANT is its name. A variant of other text finds it first on its include path (-iquote).
// Everything is in an unnamed namespace, so that one program can hold many.
#include "validation/support/shadow_map_on_cpu.hpp"

#include <stdexcept>

#include "validation/support/checked_array.hpp"
#include "validation/support/glsl_as_cpp.hpp"

#ifndef GNO_SHADOW_MAP_VARIANT
#error "define GNO_SHADOW_MAP_VARIANT, a name"
#endif

namespace gno {
namespace {

#undef GNO_NAMESPACE_BEGIN
#undef GNO_NAMESPACE_END
#define GNO_NAMESPACE_BEGIN
#define GNO_NAMESPACE_END
#include "glsl/shadow_map/view.h"

struct State {
    vec4 light{0, 0, 0, 1};
    uint size = 1;
    cpu::CheckedArray<GnoShadowMapView> views;
    cpu::CheckedArray<uint> bounds;
    const std::vector<std::vector<float>>* maps = nullptr;
} state;

float depthAt(uint view, uvec2 texel) {
    if (texel.x >= state.size || texel.y >= state.size) throw std::runtime_error("reads beside the map");
    return state.maps->at(view).at(size_t{texel.y} * state.size + texel.x);
}

#define GNO_LIGHT state.light
#define GNO_SHADOW_MAP_STATE gnoState(GNO_STATE_ANY)  // whoever draws the maps fills in the views
#define GNO_SHADOW_MAP_VIEW_COUNT uint(state.views.size())
#define GNO_SHADOW_MAP_SIZE state.size
#define GNO_SHADOW_MAP_LOAD_VIEW(index_) state.views[index_]
#define GNO_SHADOW_MAP_LOAD_DEPTH(index_, texel_) depthAt(index_, texel_)
#define GNO_SHADOW_MAP_BOUNDS state.bounds
#include "glsl/shadow_map/fit.glsl"
#include "glsl/shadow_map/query.glsl"

class OnCpu final : public cpu::ShadowMap {
public:
    void setViews(vec4 light, const std::vector<cpu::ShadowFrustum>& frusta, uint size, float constantBias) override {
        state.light = light;
        state.size = size;
        state.views.clear();
        for (const cpu::ShadowFrustum& f : frusta) {
            const GnoShadowMapView view = f.perspective ? gnoShadowMapPerspective(f.right, f.down, f.forward, f.rect)
                                                        : gnoShadowMapOrthographic(f.right, f.down, f.forward, f.rect, f.near, f.far);
            state.views.push_back(gnoShadowMapConstantBias(view, constantBias, float(size)));
        }
    }
    [[nodiscard]] vec4 clip(uint view, vec3 q) const override { return gnoShadowMapClip(state.views[view], q); }
    [[nodiscard]] bool holds(vec4 clip) const override { return gnoShadowMapHolds(clip); }
    [[nodiscard]] float depth(uint view, vec4 clip) const override { return gnoShadowMapDepth(state.views[view], clip); }
    [[nodiscard]] uvec2 texel(vec4 clip, uint size) const override { return gnoShadowMapTexel(clip, size); }
    [[nodiscard]] bool draws(uint casterState, uint faces) const override { return gnoShadowMapDraws(casterState, faces); }
    [[nodiscard]] std::vector<uint> measure(const std::vector<vec3>& samples) override {
        state.bounds.assign(4 * state.views.size(), 0);
        for (const vec3& p : samples) gnoShadowMapMeasure(GnoViewSample{p, GNO_NO_CASTER});
        return {state.bounds.begin(), state.bounds.end()};
    }
    [[nodiscard]] vec4 fit(uvec4 measured, vec4 rect) const override { return gnoShadowMapFit(measured, rect); }
    [[nodiscard]] uint answer(const std::vector<std::vector<float>>& maps, vec3 p) override {
        state.maps = &maps;
        return gnoShadowMapAnswer(GnoViewSample{p, GNO_NO_CASTER});
    }
};

[[maybe_unused]] const bool kRegistered =
    (cpu::shadowMapVariants().push_back({GNO_SHADOW_MAP_VARIANT, [] { return std::unique_ptr<cpu::ShadowMap>(std::make_unique<OnCpu>()); }}), true);

}  // namespace
}  // namespace gno
