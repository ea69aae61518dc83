#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// G-buffer of opaque casters: what the camera sees of a caster.
#define GNO_EXAMPLE_MATERIALS 0
#include "gbuffer_frag.glsl"
