#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Pass 3: the answer.
#include "../../core/counters.glsl"
#include "../../core/sample.glsl"
#include "../../core/examples/frame.glsl"
#include "../bindings.glsl"
#include "../map_bindings.glsl"
#include "../query.glsl"
#define GNO_EXAMPLE_QUERY(s_) gnoShadowMapAnswer(s_)
#include "../../core/examples/query_comp.glsl"
