#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Must fail with the #error of shadow_map/fit.glsl that names GNO_SHADOW_MAP_VIEW_COUNT.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/shadow_map/view.h"
layout(set = 0, binding = 1, std430) buffer Ours { GnoShadowMapView views[8]; uint bounds[32]; float depths[]; } ours;
#define GNO_LIGHT push.light
#define GNO_SHADOW_MAP_LOAD_VIEW(index_) ours.views[index_]
#define GNO_SHADOW_MAP_BOUNDS ours.bounds
#include "gnomon/shadow_map/fit.glsl"
layout(local_size_x = 64) in;
void main() {}
