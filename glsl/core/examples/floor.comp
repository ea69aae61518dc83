#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// The floor of all times: reads every view sample, writes a mask, decides nothing.
#include "../shared_types.h"
#include "../counters.glsl"
#include "../sample.glsl"
#include "frame.glsl"
#define GNO_EXAMPLE_QUERY(s_) (s_.own == 0u ? GNO_VISIBILITY_SHADOW : GNO_VISIBILITY_LIT)
#include "query_comp.glsl"
