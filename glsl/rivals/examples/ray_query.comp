#version 460
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
#extension GL_EXT_ray_query : require
#include "../../core/sample.glsl"
#include "../../core/examples/frame.glsl"
#include "../ray_query_bindings.glsl"
#include "../ray_query.glsl"
#define GNO_EXAMPLE_QUERY(s_) gnoRayQueryAnswer(s_)
#define GNO_EXAMPLE_COUNTS uvec4(gnoCounters.rays, gnoCounters.candidates, 0u, 0u)
#include "../../core/examples/query_comp.glsl"
