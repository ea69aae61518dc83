#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Position, geometric normal turned to the viewer, primitive. Attachments: RGBA32F, RGBA32F, R32_UINT.
#include "../bindings.glsl"
#include "../sample.glsl"
#include "frame.glsl"
layout(location = 0) in vec3 gnoPosition;
layout(location = 1) flat in uint gnoPrimitive;
layout(location = 0) out vec4 gnoPositionOut;
layout(location = 1) out vec4 gnoNormalOut;
layout(location = 2) out uint gnoPrimitiveOut;

void main() {
    gnoPositionOut = vec4(gnoPosition, 1.0);
    gnoNormalOut = vec4(gnoTurnedNormal(GNO_LOAD_CASTER(gnoPrimitive), gnoPosition, gnoPush.viewer), 0.0);
    gnoPrimitiveOut = gnoPrimitive;
}
