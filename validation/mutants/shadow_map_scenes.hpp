// SPDX-License-Identifier: MIT
// Scenes for the shadow map's text: samples whose answers are the same all around, and maps of what the light sees, drawn in double at the centre of
// each texel. No arithmetic of the modules.
#pragma once
#include "validation/support/shadow_map_on_cpu.hpp"

namespace gno::mutants {

using cpu::ShadowFrustum;
using glm::dvec3;

/// The faces of a cube, +x -x +y -y +z -z.
std::vector<ShadowFrustum> cubeFaces();

/// A view along `forward`, which need not be a unit vector.
ShadowFrustum viewAlong(dvec3 forward, vec4 rect);

/// Where q lies in a view, by the definition of `rect`: 0 .. 1 inside, to the right and downwards; and its depth (shadow_map/view.h) without bias.
struct Place {
    double x, y, depth, along;  ///< along: the distance along `forward`
};
Place placeOf(const ShadowFrustum& f, vec3 q);

constexpr uint kMapSize = 256;  ///< texels along a side

struct ShadowScene {
    std::string name;
    vec4 light;
    std::vector<GnoCaster> casters;
    std::vector<vec3> samples;  ///< as far from every silhouette as some texels are wide
    std::vector<uint8_t> want;  ///< by the definition
    std::vector<ShadowFrustum> frusta;
    std::vector<std::vector<float>> maps;  ///< with a slope bias of one texel
};

/// Point and directional lights over a ground with a wall and a square above it, a light in a room: views as large as they may be, and fitted ones.
std::vector<ShadowScene> makeShadowScenes();

}  // namespace gno::mutants
