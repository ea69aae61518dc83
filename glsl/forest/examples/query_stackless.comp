#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
layout(constant_id = 0) const uint kPrecision = 2u;
layout(constant_id = 2) const uint kDepthTest = 1u;
layout(constant_id = 3) const uint kSlab = 0u;
layout(constant_id = 4) const uint kStorePlanes = 1u;
#define GNO_PRECISION kPrecision
#define GNO_TOP_BIND_SLABS 1
#define GNO_TOP_SLAB kSlab
#define GNO_TOP_STORE_PLANES kStorePlanes
#define GNO_TOP_DEPTH_TEST kDepthTest
#define GNO_TOP_READ_ONLY 1
#include "../../core/bindings.glsl"
#include "../../core/sample.glsl"
#include "../../core/examples/frame.glsl"
#define GNO_FOREST_TREES 1
#include "../bindings.glsl"
#include "../../top/bindings.glsl"
#include "../../top/query_stackless.glsl"
#define GNO_EXAMPLE_QUERY(s_) gnoTopQueryStackless(s_)
#include "../../core/examples/query_comp.glsl"
