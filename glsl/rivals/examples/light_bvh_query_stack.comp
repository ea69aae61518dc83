#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
#include "../../core/constant_ids.h"
layout(constant_id = GNO_ID_PRECISION) const uint kPrecision = 2u;
#define GNO_PRECISION kPrecision
layout(constant_id = GNO_ID_STACK_SIZE) const uint kStackSize = 32u;
#define GNO_LIGHT_BVH_STACK_SIZE kStackSize
#include "../../core/bindings.glsl"
#include "../../core/sample.glsl"
#include "../../core/examples/frame.glsl"
#include "../light_bvh_bindings.glsl"
#include "../light_bvh_query.glsl"
#define GNO_EXAMPLE_QUERY(s_) gnoLightBvhAnswer(s_)
#include "../../core/examples/query_comp.glsl"
