#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// G-buffer of opaque casters: corners of all casters.
#define GNO_EXAMPLE_MATERIALS 0
#include "gbuffer_vert.glsl"
