#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// After steps 2 and 4: how many work groups the next passes need. One invocation.
layout(local_size_x = 1) in;
#include "../../core/examples/frame.glsl"
#include "../bindings.glsl"
#include "../assign.glsl"

void main() { gnoForestSizes(); }
