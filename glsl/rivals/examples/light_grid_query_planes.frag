#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
layout(constant_id = 0) const uint kPrecision = 2u;
#define GNO_PRECISION kPrecision
#include "../../core/bindings.glsl"
#include "../../core/sample.glsl"
#include "../../core/examples/frame.glsl"
#include "../../forest/bindings.glsl"
#define GNO_LIGHT_GRID_READ_ONLY 1
#define GNO_LIGHT_GRID_PLANES 1
#include "../light_grid_bindings.glsl"
#include "../light_grid_query.glsl"
#define GNO_EXAMPLE_QUERY(s_) gnoLightGridQuery(s_)
#include "../../core/examples/query_frag.glsl"
