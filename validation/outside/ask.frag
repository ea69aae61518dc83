#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// The snippet of glsl/README.md in an engine's fragment shader.
layout(push_constant) uniform Frame { vec4 light; } frame;
layout(location = 0) in vec3 position;
layout(location = 1) flat in uint primitive;
layout(location = 0) out vec4 color;
#define GNO_LIGHT frame.light
#include "gnomon/core/bindings.glsl"
#include "gnomon/top/bindings.glsl"
#include "gnomon/top/query_hybrid.glsl"
void main() { color = vec4(gnoTopQueryHybrid(GnoViewSample(position, primitive)) ? 0.0 : 1.0); }
