#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
#include "../../core/constant_ids.h"
layout(constant_id = GNO_ID_PRECISION) const uint kPrecision = 2u;
layout(constant_id = GNO_ID_DEPTH_TEST) const uint kDepthTest = 1u;
#define GNO_PRECISION kPrecision
#define GNO_TOP_DEPTH_TEST kDepthTest
layout(constant_id = GNO_ID_STACK_SIZE) const uint kStackSize = 32u;
#define GNO_TOP_STACK_SIZE kStackSize
#include "../../core/bindings.glsl"
#include "../../core/sample.glsl"
#include "../../core/examples/frame.glsl"
#include "../bindings.glsl"
#include "../query_stack.glsl"
#define GNO_EXAMPLE_QUERY(s_) gnoTopStackAnswer(s_)
#include "../../core/examples/query_comp.glsl"
