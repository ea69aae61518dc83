#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Must fail with the #error of shadow_map/query.glsl that names GNO_SHADOW_MAP_SIZE.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
#include "gnomon/shadow_map/view.h"
layout(set = 0, binding = 1, std430) buffer Ours { GnoShadowMapView views[8]; uint bounds[32]; float depths[]; } ours;
#define GNO_LIGHT push.light
#define GNO_SHADOW_MAP_VIEW_COUNT push.count
#define GNO_SHADOW_MAP_LOAD_VIEW(index_) ours.views[index_]
#define GNO_SHADOW_MAP_LOAD_DEPTH(index_, texel_) ours.depths[(texel_).y * 512u + (texel_).x]
#include "gnomon/shadow_map/query.glsl"
layout(local_size_x = 64) in;
void main() {}
