// SPDX-License-Identifier: MIT
// What the example entry points share: one push block, the frame's images. Your engine has its own; the modules never see these.
#ifndef GNO_EXAMPLE_FRAME_GLSL
#define GNO_EXAMPLE_FRAME_GLSL

layout(push_constant) uniform GnoExamplePush {
    vec4 light;    // homogeneous, on the grid
    vec4 viewer;   // homogeneous, on the grid
    uvec2 size;    // pixels
    uint count;    // casters
    uint seed;     // insertion order
    uint cull;     // GNO_CULL_*
    uint planes;   // planes of the culling hull
    uint number;   // what this pass is told besides: a row, a level, a digit (Pass::number of core/pass.hpp)
} gnoPush;
#define GNO_LIGHT gnoPush.light
#endif
