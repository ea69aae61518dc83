// SPDX-License-Identifier: MIT
// The definition of what alpha-tested and coloured casters take from a sample (header of glsl/core/transmittance.glsl), word for word: determinants
// of unlimited integers, texels and logarithms in plain C++. Nothing of glsl/ is included.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "host_min/oracle.hpp"

namespace gno::host::oracle {

/// Integer weights of a caster's vertices where the way from the light to p crosses it; p in its shadow volume.
std::array<int64_t, 3> hitWeights(const Triangle& caster, glm::vec4 light, glm::vec3 p);

/// A image's channels at a texel coordinate (1/256 texel), by the material's wrap modes and filter; colour linear.
std::array<int64_t, 4> sampled(const Material& material, const TextureImage& image, int64_t u, int64_t v);

/// What passes a material of which this texel was sampled, 0 to 255 a channel.
std::array<int64_t, 3> passing(const Material& material, const std::array<int64_t, 4>& texel);

/// round(-log2(passed / 255) * 2^16); kNoLight for 0.
uint32_t contribution(int64_t passed);

/// Throws WorkError when a question's surfaces, materials or images name what does not exist.
void checkSurfaces(const OracleQuestion& question);

/// Contribution of triangle `caster` of the question to p, which lies in its shadow volume.
glm::uvec3 contributionOf(const OracleQuestion& question, uint32_t caster, glm::vec3 p);

}  // namespace gno::host::oracle
