// SPDX-License-Identifier: MIT
// gnomon shadow_map/map_bindings.glsl : our shadow map for shaders that read it; leave it out and define GNO_SHADOW_MAP_LOAD_DEPTH yourself where
// your storage differs.
//
// Defines    GNO_SHADOW_MAP_LOAD_DEPTH
// Space      none: depths
// Stages     any
// Requires   #version 450, no extension
//
// Macro                         required  default  meaning
// GNO_SHADOW_MAP_SET            no        1        descriptor set, the same as in bindings.glsl
// GNO_SHADOW_MAP_BINDING_MAP    no        2        sampled depth image (D32), one layer per view; the sampler does not matter: texels are fetched
#ifdef GNO_SHADOW_MAP_MAP_BINDINGS_GLSL
#error "shadow_map/map_bindings.glsl: a second inclusion changes nothing: GNO_SHADOW_MAP_SET and the other number are read once"
#endif
#ifndef GNO_SHADOW_MAP_MAP_BINDINGS_GLSL
#define GNO_SHADOW_MAP_MAP_BINDINGS_GLSL
#ifndef GNO_SHADOW_MAP_SET
#define GNO_SHADOW_MAP_SET 1
#endif
#ifndef GNO_SHADOW_MAP_BINDING_MAP
#define GNO_SHADOW_MAP_BINDING_MAP 2
#endif

layout(set = GNO_SHADOW_MAP_SET, binding = GNO_SHADOW_MAP_BINDING_MAP) uniform sampler2DArray gnoShadowMap;
#define GNO_SHADOW_MAP_LOAD_DEPTH(index_, texel_) texelFetch(gnoShadowMap, ivec3(ivec2(texel_), int(index_)), 0).x
#endif
