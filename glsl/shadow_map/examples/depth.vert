#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Pass 2, once per view: draw 3 * casters vertices of instance number `view` into that view's layer; no vertex input, no fragment shader, clear 0,
// greater passes.
#include "../../core/constant_ids.h"
layout(constant_id = GNO_ID_FACES) const uint kFaces = 0u;  // GNO_SHADOW_MAP_BOTH ...
#include "../../core/bindings.glsl"
#include "../../core/examples/frame.glsl"
#include "../bindings.glsl"
#include "../project.glsl"
layout(set = 2, binding = 0, std430) readonly buffer GnoExampleStates { uint v[]; } gnoStates;

void main() {
    uint caster = uint(gl_VertexIndex) / 3u;
    uint corner = uint(gl_VertexIndex) - 3u * caster;
    GnoCaster t = GNO_LOAD_CASTER(caster);
    vec3 p = corner == 0u ? t.a : corner == 1u ? t.b : t.c;
    bool drawn = gnoShadowMapDraws(gnoStates.v[caster], kFaces);
    gl_Position = drawn ? gnoShadowMapClip(GNO_SHADOW_MAP_LOAD_VIEW(gl_InstanceIndex), gnoFromLight(GNO_LIGHT, p)) : vec4(2.0, 2.0, 0.0, 1.0);
}
