// SPDX-License-Identifier: MIT
// gnomon core/constant_ids.h : the numbers of the examples' specialization constants, named once; read by glslang and by C++20. No module reads
// them: a library takes its tuning as macros, and an example gives it a constant's name.
//
// One number has one meaning and one name in all shaders: kPrecision is GNO_ID_PRECISION wherever it stands. A shader has those that it needs, and
// each has a default in the shader, so a pipeline without any is right.
//
//   number               name           used by
//   GNO_ID_PRECISION     kPrecision     what builds and asks structures
//   GNO_ID_STACK_SIZE    kStackSize     queries with a stack, short or long
//   GNO_ID_DEPTH_TEST    kDepthTest     queries of TOP trees
//   GNO_ID_SLAB          kSlab          forest: trees with slabs
//   GNO_ID_STORE_PLANES  kStorePlanes   forest: trees with planes
//   GNO_ID_GROUP_SIZE    kGroupSize     local_size_x of passes whose work group size is tuning, 64 by default (the language gives it no name)
//   GNO_ID_FORM          kForm          clusters: GNO_CLUSTER_IMPLICIT ...
//   GNO_ID_WHAT          kWhat          clusters/examples/tiles.comp, up.comp: masks, bounds or both
//   GNO_ID_PASS          kPass          clusters: 1 expand, 2 finish
//   GNO_ID_GROUPS        kGroups        clusters: work groups of the second pass, at most
//   GNO_ID_VIEW_CULL     kViewCull      forest, light grid: GNO_FOREST_VIEW_CULL
//   GNO_ID_USE_COVER     kUseCover      forest, light grid: GNO_FOREST_USE_COVER
//   GNO_ID_STEP          kStep          forest, light grid: which of the steps that share a shader
//   GNO_ID_NEST          kNest          light grid: GNO_LIGHT_GRID_NEST
//   GNO_ID_FACES         kFaces         shadow map: GNO_SHADOW_MAP_BOTH ...
//
// Space      none: no positions
// Stages     any
// Requires   #version 450, no extension
#ifndef GNO_CORE_CONSTANT_IDS_H
#define GNO_CORE_CONSTANT_IDS_H
#define GNO_ID_PRECISION 0
#define GNO_ID_STACK_SIZE 1
#define GNO_ID_DEPTH_TEST 2
#define GNO_ID_SLAB 3
#define GNO_ID_STORE_PLANES 4
#define GNO_ID_GROUP_SIZE 10
#define GNO_ID_FORM 20
#define GNO_ID_WHAT 21
#define GNO_ID_PASS 22
#define GNO_ID_GROUPS 23
#define GNO_ID_VIEW_CULL 30
#define GNO_ID_USE_COVER 31
#define GNO_ID_STEP 32
#define GNO_ID_NEST 33
#define GNO_ID_FACES 40
#endif
