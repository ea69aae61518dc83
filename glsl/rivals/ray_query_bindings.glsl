// SPDX-License-Identifier: MIT
// gnomon rivals/ray_query_bindings.glsl : our acceleration structure; leave it out and define GNO_RAY_QUERY_STRUCTURE where yours lies elsewhere.
//
// Defines    GNO_RAY_QUERY_STRUCTURE
// Space      casters on the scene grid
// Stages     any with ray queries
// Requires   #version 460, #extension GL_EXT_ray_query. Include before ray_query.glsl
//
// Macro                            required  default  meaning
// GNO_RAY_QUERY_SET                no        1        descriptor set
// GNO_RAY_QUERY_BINDING_STRUCTURE  no        0        the top-level structure
#ifdef GNO_RIVALS_RAY_QUERY_BINDINGS_GLSL
#error "rivals/ray_query_bindings.glsl: a second inclusion changes nothing: GNO_RAY_QUERY_SET and the other number are read once"
#endif
#ifndef GNO_RIVALS_RAY_QUERY_BINDINGS_GLSL
#define GNO_RIVALS_RAY_QUERY_BINDINGS_GLSL
#ifndef GNO_RAY_QUERY_SET
#define GNO_RAY_QUERY_SET 1
#endif
#ifndef GNO_RAY_QUERY_BINDING_STRUCTURE
#define GNO_RAY_QUERY_BINDING_STRUCTURE 0
#endif

layout(set = GNO_RAY_QUERY_SET, binding = GNO_RAY_QUERY_BINDING_STRUCTURE) uniform accelerationStructureEXT gnoRayStructure;
#define GNO_RAY_QUERY_STRUCTURE gnoRayStructure
#endif
