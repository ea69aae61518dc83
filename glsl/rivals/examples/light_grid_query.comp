#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
#include "../../core/constant_ids.h"
layout(constant_id = GNO_ID_PRECISION) const uint kPrecision = 2u;
#define GNO_PRECISION kPrecision
#include "../../core/bindings.glsl"
#include "../../core/sample.glsl"
#include "../../core/examples/frame.glsl"
#include "../../forest/bindings.glsl"
#include "../light_grid_bindings.glsl"
#include "../light_grid_query.glsl"
#define GNO_EXAMPLE_QUERY(s_) gnoLightGridAnswer(s_)
#include "../../core/examples/query_comp.glsl"
