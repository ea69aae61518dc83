// SPDX-License-Identifier: MIT
// One variant: GNO_TRANSMITTANCE_VARIANT is its name. A variant of other text finds it first on its include path (-iquote).
// Everything is in an unnamed namespace, so that one program can hold many.
#include "validation/support/transmittance_on_cpu.hpp"

#include "validation/support/checked_array.hpp"
#include "validation/support/glsl_as_cpp.hpp"

#ifndef GNO_TRANSMITTANCE_VARIANT
#error "define GNO_TRANSMITTANCE_VARIANT, a name"
#endif

namespace gno {
namespace {

struct State {
    cpu::CheckedArray<uint> materialOf, texels, sums;
    cpu::CheckedArray<GnoSurface> surfaces;
    cpu::CheckedArray<GnoMaterial> materials;
} state;

#define GNO_LOAD_MATERIAL_OF(caster_) state.materialOf[caster_]
#define GNO_LOAD_SURFACE(index_) state.surfaces[index_]
#define GNO_LOAD_MATERIAL(index_) state.materials[index_]
#define GNO_LOAD_TEXEL(index_) state.texels[index_]
#define GNO_TRANSMITTANCE_SUMS state.sums

#undef GNO_NAMESPACE_BEGIN
#undef GNO_NAMESPACE_END
#define GNO_NAMESPACE_BEGIN
#define GNO_NAMESPACE_END
#include "glsl/core/transmittance.glsl"
#include "glsl/core/transmittance_sum.glsl"

class OnCpu final : public cpu::Transmittance {
public:
    void install(const cpu::Look& look) override {
        state.materialOf.assign(look.materialOf.begin(), look.materialOf.end());
        state.texels.assign(look.texels.begin(), look.texels.end());
        state.surfaces.assign(look.surfaces.begin(), look.surfaces.end());
        state.materials.assign(look.materials.begin(), look.materials.end());
    }

    [[nodiscard]] uvec3 hitWeights(vec4 light, const GnoCaster& t, vec3 p) const override { return gnoHitWeights(light, t, p); }
    [[nodiscard]] uint weightedMean(uvec3 weights, uvec3 values) const override { return gnoWeightedMean(weights, values); }
    [[nodiscard]] ivec2 hitTexel(uvec3 weights, const GnoSurface& surface) const override { return gnoHitTexel(weights, surface); }
    [[nodiscard]] uvec4 sampleTexture(const GnoMaterial& material, ivec2 at) const override { return gnoSampleTexture(material, at); }
    [[nodiscard]] uvec3 transmitted(const GnoMaterial& material, uvec4 texel) const override { return gnoTransmitted(material, texel); }
    [[nodiscard]] uint contribution(uint transmitted) const override { return gnoContribution(transmitted); }
    [[nodiscard]] uvec3 transmittance(uint caster, const GnoCaster& t, vec4 light, vec3 p) const override {
        return gnoTransmittance(caster, t, light, p);
    }

    void resetSums(uint pixels) override { state.sums.assign(4 * size_t{pixels}, 0); }
    void add(uint pixel, uvec3 contribution) override { gnoAddTransmittance(pixel, contribution); }
    void addOpaque(uint pixel) override { gnoAddOpaque(pixel); }
    void addLate(uint pixel, uint channel, uint contribution) override {
        if (const uint stop = gnoAddChannel_(pixel, channel, contribution); stop != 0u) atomicOr(state.sums[4u * pixel + 3u], stop);
    }
    [[nodiscard]] bool isDark(uint pixel) const override { return gnoIsDark(pixel); }
    [[nodiscard]] uvec3 sum(uint pixel) const override { return gnoTransmittanceSum(pixel); }
};

[[maybe_unused]] const bool kRegistered =
    (cpu::transmittanceVariants().push_back(
         {GNO_TRANSMITTANCE_VARIANT, [] { return std::unique_ptr<cpu::Transmittance>(std::make_unique<OnCpu>()); }}),
     true);

}  // namespace
}  // namespace gno
