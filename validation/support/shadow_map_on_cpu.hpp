// SPDX-License-Identifier: MIT
// glsl/shadow_map on the CPU, made of the same GLSL text that the device runs: views, measuring and fitting, and the query over maps that somebody
// else drew. A variant is one compilation of shadow_map_on_cpu.cpp, as with the TOP tree (top_on_cpu.hpp).
#pragma once
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "glsl/core/shared_types.h"

namespace gno::cpu {

/// What a view is made of (shadow_map/view.h).
struct ShadowFrustum {
    vec3 right, down, forward;
    vec4 rect;
    float near = 0, far = 1;
    bool perspective = true;
};

class ShadowMap {
public:
    virtual ~ShadowMap() = default;

    virtual void setViews(vec4 light, const std::vector<ShadowFrustum>& frusta, uint size, float constantBias) = 0;
    [[nodiscard]] virtual vec4 clip(uint view, vec3 q) const = 0;
    [[nodiscard]] virtual bool holds(vec4 clip) const = 0;
    [[nodiscard]] virtual float depth(uint view, vec4 clip) const = 0;
    [[nodiscard]] virtual glm::uvec2 texel(vec4 clip, uint size) const = 0;
    [[nodiscard]] virtual bool draws(uint state, uint faces) const = 0;
    /// Four numbers per view, 0 before the first sample.
    [[nodiscard]] virtual std::vector<uint> measure(const std::vector<vec3>& samples) = 0;
    [[nodiscard]] virtual vec4 fit(uvec4 measured, vec4 rect) const = 0;
    /// maps: per view size * size depths, rows from the top. GNO_VISIBILITY_*. Throws std::runtime_error when the text asks beside them.
    [[nodiscard]] virtual uint answer(const std::vector<std::vector<float>>& maps, vec3 p) = 0;
};

struct ShadowMapVariant {
    std::string name;
    std::unique_ptr<ShadowMap> (*make)();
};

/// All variants that this program is linked with. Each has one state: use one of a variant at a time.
inline std::vector<ShadowMapVariant>& shadowMapVariants() {
    static std::vector<ShadowMapVariant> variants;
    return variants;
}

}  // namespace gno::cpu
