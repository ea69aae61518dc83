#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Way B: our buffers, other sets and bindings.
layout(push_constant) uniform Push { vec4 light; vec4 viewer; vec4 position; uint count; uint seed; } push;
layout(constant_id = 9) const uint kStorePlanes = 0u;
#define GNO_LIGHT push.light
#define GNO_TOP_STORE_PLANES kStorePlanes
#define GNO_CORE_SET 2
#define GNO_CORE_BINDING_CASTERS 7
#define GNO_TOP_SET 3
#define GNO_TOP_BINDING_PLANES 5
#define GNO_TOP_BINDING_LINKS 6
#define GNO_TOP_BINDING_HEADER 9
#define GNO_TOP_BINDING_SLABS 10
#define GNO_TOP_BIND_SLABS 1
#define GNO_TOP_SLAB 1
#define GNO_PRECISION GNO_PRECISION_PUBLISHED
#include "gnomon/core/bindings.glsl"
#define GNO_TOP_BUILDS 1
#include "gnomon/top/bindings.glsl"
#include "gnomon/top/build.glsl"
#include "gnomon/core/orient3d.glsl"
layout(local_size_x = 64) in;

void main() {
    uint at = gl_GlobalInvocationID.x;
    if (at < push.count) gnoTopSetUp(at, gnoFacing(push.light, GNO_LOAD_CASTER(at)));
}
