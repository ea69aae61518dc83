#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// G-buffer where some casters are alpha-tested or coloured: what the camera sees of a caster.
#define GNO_EXAMPLE_MATERIALS 1
#include "gbuffer_frag.glsl"
