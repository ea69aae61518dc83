#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_ballot : require
// The traversal where some casters let light through.
#define GNO_CLUSTER_LAYERS 1
#include "traverse_comp.glsl"
