#version 460
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
#extension GL_EXT_ray_query : require
#include "../../core/sample.glsl"
#include "../../core/examples/frame.glsl"
#include "../ray_query_bindings.glsl"
#include "../ray_query.glsl"
#define GNO_EXAMPLE_QUERY(s_) gnoRayQueryAnswer(s_)
#include "../../core/examples/query_frag.glsl"
