#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Must fail with the #error of core/transmittance_sum.glsl that names GNO_TRANSMITTANCE_SUMS.
#include "gnomon/core/transmittance_sum.glsl"
layout(local_size_x = 64) in;
void main() {}
