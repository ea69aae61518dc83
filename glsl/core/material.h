// SPDX-License-Identifier: MIT
// gnomon core/material.h : what a caster that is not opaque lets through; read by glslang and by C++20 (namespace gno).
//
// Space      none: no positions
// Stages     any
// Requires   #version 450, no extension
//
// Texel coordinates are fixed point, in 1/256 texel: 256 * (u * width, v * height), u to the right and v downwards in the image, rounded to integers
// and below 2^30 in size. Whoever makes them moves a triangle of a repeating (mirrored) texture by whole repeats (pairs of repeats) until it is
// small. Texels are 8 bits a channel, red in the lowest byte; colour is linear, alpha is as in the file. A material without a texture has width 0;
// each of its texels is 255, 255, 255, 255.
#ifndef GNO_CORE_MATERIAL_H
#define GNO_CORE_MATERIAL_H
#include "shared_types.h"
#ifdef __cplusplus
namespace gno {
using glm::ivec2;
}
#endif
GNO_NAMESPACE_BEGIN

GNO_CONST uint GNO_OPAQUE_CASTER = 0xFFFFFFFFu;         // GNO_LOAD_MATERIAL_OF of a caster that lets nothing through anywhere
GNO_CONST uint GNO_TRANSMITTANCE_OPAQUE = 0x00100000u;  // 16 * 2^16: a channel that nothing passes, and where sums of contributions stop

// GnoMaterial::kind: one of the first three, and bits
GNO_CONST uint GNO_MATERIAL_SOLID = 0u;                 // coverage 255 everywhere (with a transmission; without one it would be opaque)
GNO_CONST uint GNO_MATERIAL_MASK = 1u;                  // coverage 255 where alpha reaches the cutoff, 0 elsewhere
GNO_CONST uint GNO_MATERIAL_BLEND = 2u;                 // coverage alpha
GNO_CONST uint GNO_MATERIAL_LINEAR = 4u;                // bilinear filter; without it the nearest texel
GNO_CONST uint GNO_MATERIAL_WRAP_U = 4u;                // position of two bits: GNO_WRAP_*
GNO_CONST uint GNO_MATERIAL_WRAP_V = 6u;                // the same
GNO_CONST uint GNO_WRAP_REPEAT = 0u;
GNO_CONST uint GNO_WRAP_MIRRORED = 1u;
GNO_CONST uint GNO_WRAP_CLAMP = 2u;

struct GnoMaterial {    // std430, 48 bytes
    uint kind;          //  0  see above
    uint width;         //  4  of the texture; 0: none
    uint height;        //  8
    uint firstTexel;    // 12  number of the texture's first texel; rows follow each other, the top one first
    uint red;           // 16  base colour factor, 65535 is 1
    uint green;         // 20
    uint blue;          // 24
    uint alpha;         // 28
    uint cutoff;        // 32  mask: round(cutoff * 255 * 65535), compared with texel alpha * alpha
    uint transmission;  // 36  255 is 1
    uint unused0;       // 40
    uint unused1;       // 44
};
GNO_STRUCT_SIZE(GnoMaterial, 48)
GNO_STRUCT_OFFSET(GnoMaterial, firstTexel, 12)
GNO_STRUCT_OFFSET(GnoMaterial, alpha, 28)
GNO_STRUCT_OFFSET(GnoMaterial, transmission, 36)

struct GnoSurface {     // std430, 32 bytes: one caster that is not opaque
    ivec2 a;            //  0  texel coordinates of its vertices
    ivec2 b;            //  8
    ivec2 c;            // 16
    uint material;      // 24  number of its GnoMaterial
    uint unused;        // 28
};
GNO_STRUCT_SIZE(GnoSurface, 32)
GNO_STRUCT_OFFSET(GnoSurface, b, 8)
GNO_STRUCT_OFFSET(GnoSurface, material, 24)

GNO_NAMESPACE_END
#endif
