#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// After sort.comp, and again after allocate.comp: how many work groups the next passes need. One invocation.
layout(local_size_x = 1) in;
#include "../../core/examples/frame.glsl"
#define GNO_FOREST_BUILDS GNO_FOREST_PASS_SIZES
#include "../bindings.glsl"
#include "../assign.glsl"

void main() { gnoForestSizes(); }
