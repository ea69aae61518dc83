// SPDX-License-Identifier: MIT
// gnomon core/material_bindings.glsl : our buffers of materials; leave it out and define the macros yourself where your storage differs.
//
//   GNO_LOAD_MATERIAL_OF(caster), GNO_LOAD_SURFACE(index), GNO_LOAD_MATERIAL(index), GNO_LOAD_TEXEL(index)   for core/transmittance.glsl
//   GNO_TRANSMITTANCE_SUMS                                                                                   for core/transmittance_sum.glsl
//
// The host writes the first four once per scene or frame; passes only read them. The sums are zeroed before the first pass that adds to them.
//
// Space      none: no positions
// Stages     any with storage buffers; adding writes (fragment stage: fragmentStoresAndAtomics)
// Requires   #version 450, no extension. Include before transmittance.glsl and transmittance_sum.glsl; layouts in material.h
//
// Macro                         required  default  meaning
// GNO_MATERIAL_SET              no        0        descriptor set of all
// GNO_MATERIAL_BINDING_OF       no        1        std430 uint[casters]: GNO_OPAQUE_CASTER or the number of a surface
// GNO_MATERIAL_BINDING_SURFACES no        2        std430 GnoSurface[surfaces]
// GNO_MATERIAL_BINDING_LIST     no        3        std430 GnoMaterial[materials]
// GNO_MATERIAL_BINDING_TEXELS   no        4        std430 uint[texels]
// GNO_MATERIAL_BINDING_SUMS     no        5        std430 uint[4 * pixels], see transmittance_sum.glsl
// GNO_MATERIAL_SUMS             no        1        0: no sums, for a shader that only looks materials up
// GNO_TRANSMITTANCE_ADDS        no        0        1: this shader clears the sums or adds to them; 0: they are readonly
#ifdef GNO_CORE_MATERIAL_BINDINGS_GLSL
#error "core/material_bindings.glsl: a second inclusion changes nothing: GNO_MATERIAL_SET and the other numbers are read once"
#endif
#ifndef GNO_CORE_MATERIAL_BINDINGS_GLSL
#define GNO_CORE_MATERIAL_BINDINGS_GLSL
#include "material.h"
#ifndef GNO_MATERIAL_SET
#define GNO_MATERIAL_SET 0
#endif
#ifndef GNO_MATERIAL_BINDING_OF
#define GNO_MATERIAL_BINDING_OF 1
#endif
#ifndef GNO_MATERIAL_BINDING_SURFACES
#define GNO_MATERIAL_BINDING_SURFACES 2
#endif
#ifndef GNO_MATERIAL_BINDING_LIST
#define GNO_MATERIAL_BINDING_LIST 3
#endif
#ifndef GNO_MATERIAL_BINDING_TEXELS
#define GNO_MATERIAL_BINDING_TEXELS 4
#endif
#ifndef GNO_MATERIAL_BINDING_SUMS
#define GNO_MATERIAL_BINDING_SUMS 5
#endif
#ifndef GNO_MATERIAL_SUMS
#define GNO_MATERIAL_SUMS 1
#endif
#ifndef GNO_TRANSMITTANCE_ADDS
#define GNO_TRANSMITTANCE_ADDS 0
#endif
#if GNO_TRANSMITTANCE_ADDS
#define GNO_TRANSMITTANCE_ACCESS_
#else
#define GNO_TRANSMITTANCE_ACCESS_ readonly
#endif

layout(set = GNO_MATERIAL_SET, binding = GNO_MATERIAL_BINDING_OF, std430) readonly buffer GnoMaterialOfBuffer { uint v[]; } gnoMaterialOf;
layout(set = GNO_MATERIAL_SET, binding = GNO_MATERIAL_BINDING_SURFACES, std430) readonly buffer GnoSurfaceBuffer { GnoSurface v[]; } gnoSurfaces;
layout(set = GNO_MATERIAL_SET, binding = GNO_MATERIAL_BINDING_LIST, std430) readonly buffer GnoMaterialBuffer { GnoMaterial v[]; } gnoMaterials;
layout(set = GNO_MATERIAL_SET, binding = GNO_MATERIAL_BINDING_TEXELS, std430) readonly buffer GnoTexelBuffer { uint v[]; } gnoTexels;
#if GNO_MATERIAL_SUMS
layout(set = GNO_MATERIAL_SET, binding = GNO_MATERIAL_BINDING_SUMS, std430) GNO_TRANSMITTANCE_ACCESS_ buffer GnoTransmittanceBuffer { uint v[]; }
gnoTransmittances;
#define GNO_TRANSMITTANCE_SUMS gnoTransmittances.v
#endif

#define GNO_LOAD_MATERIAL_OF(caster_) gnoMaterialOf.v[caster_]
#define GNO_LOAD_SURFACE(index_) gnoSurfaces.v[index_]
#define GNO_LOAD_MATERIAL(index_) gnoMaterials.v[index_]
#define GNO_LOAD_TEXEL(index_) gnoTexels.v[index_]
#endif
