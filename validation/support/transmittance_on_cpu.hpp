// SPDX-License-Identifier: MIT
// core/hit_weights.glsl, core/transmittance.glsl and core/transmittance_sum.glsl on the CPU, made of the same GLSL text that the device runs. A
// variant is one compilation of transmittance_on_cpu.cpp, as with the TOP tree (top_on_cpu.hpp).
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "glsl/core/material.h"

namespace gno::cpu {

/// What the buffers of core/material_bindings.glsl hold.
struct Look {
    std::vector<uint> materialOf, texels;
    std::vector<GnoSurface> surfaces;
    std::vector<GnoMaterial> materials;
};

/// The functions of the modules' headers, by their names. They throw std::runtime_error when the text leaves its arrays.
class Transmittance {
public:
    virtual ~Transmittance() = default;
    virtual void install(const Look& look) = 0;

    [[nodiscard]] virtual glm::uvec3 hitWeights(vec4 light, const GnoCaster& t, vec3 p) const = 0;
    [[nodiscard]] virtual uint weightedMean(glm::uvec3 weights, glm::uvec3 values) const = 0;
    [[nodiscard]] virtual glm::ivec2 hitTexel(glm::uvec3 weights, const GnoSurface& surface) const = 0;
    [[nodiscard]] virtual uvec4 sampleTexture(const GnoMaterial& material, glm::ivec2 at) const = 0;
    [[nodiscard]] virtual glm::uvec3 transmitted(const GnoMaterial& material, uvec4 texel) const = 0;
    [[nodiscard]] virtual uint contribution(uint transmitted) const = 0;
    [[nodiscard]] virtual glm::uvec3 transmittance(uint caster, const GnoCaster& t, vec4 light, vec3 p) const = 0;

    virtual void resetSums(uint pixels) = 0;
    virtual void add(uint pixel, glm::uvec3 contribution) = 0;
    virtual void addOpaque(uint pixel) = 0;
    /// An addition by somebody who looked at the pixel's stops before anybody else added.
    virtual void addLate(uint pixel, uint channel, uint contribution) = 0;
    [[nodiscard]] virtual bool isDark(uint pixel) const = 0;
    [[nodiscard]] virtual glm::uvec3 sum(uint pixel) const = 0;
};

struct TransmittanceVariant {
    std::string name;
    std::unique_ptr<Transmittance> (*make)();
};

/// All variants that this program is linked with. Each has one state: use one of a variant at a time.
inline std::vector<TransmittanceVariant>& transmittanceVariants() {
    static std::vector<TransmittanceVariant> variants;
    return variants;
}

}  // namespace gno::cpu
