// SPDX-License-Identifier: MIT
// gnomon clusters/bindings.glsl : our buffers of a cluster hierarchy; leave it out and define the macros yourself where your storage differs.
//
// Defines    GNO_CLUSTER_FRAME, GNO_CLUSTER_LAYOUT, GNO_CLUSTER_HEADER, GNO_CLUSTER_STATE, GNO_CLUSTER_SLICES, GNO_CLUSTER_MASKS, GNO_CLUSTER_SHADE,
//            GNO_CLUSTER_LOW, GNO_CLUSTER_HIGH, GNO_CLUSTER_POINTERS, GNO_CLUSTER_VOLUMES, GNO_CLUSTER_INFO, GNO_CLUSTER_JOBS
// Space      as cluster.h
// Stages     any with storage buffers; merging needs no device feature, the other passes write (fragment stage: fragmentStoresAndAtomics)
// Requires   #version 450, no extension
//
// Macro                          required  default  meaning
// GNO_CLUSTER_SET                no        1        descriptor set
// GNO_CLUSTER_BINDING_FRAME      no        0        uniform buffer: GnoClusterFrame, GnoClusterLayout
// GNO_CLUSTER_BINDING_HEADER     no        1        GnoClusterHeader
// GNO_CLUSTER_BINDING_SLICES     no        2        float[slices + 1]
// GNO_CLUSTER_BINDING_MASKS      no        3        uint[words]
// GNO_CLUSTER_BINDING_SHADE      no        4        uint[gnoClusterShadeWords]
// GNO_CLUSTER_BINDING_LOW        no        5        float[3 boxes], flat: float[nodes]
// GNO_CLUSTER_BINDING_HIGH       no        6        the same
// GNO_CLUSTER_BINDING_POINTERS   no        7        uvec2[words], compact only (any small buffer otherwise)
// GNO_CLUSTER_BINDING_VOLUMES    no        8        vec4[7 n]
// GNO_CLUSTER_BINDING_INFO       no        9        uvec2[n]
// GNO_CLUSTER_BINDING_JOBS       no        10       uvec2[frame.jobCapacity]
// GNO_CLUSTER_BUILDS             no        0        0: all are readonly; a shader that builds or traverses says here which pass it is (cluster.h),
//                                                   and what this pass writes is writable
#ifdef GNO_CLUSTERS_BINDINGS_GLSL
#error "clusters/bindings.glsl: a second inclusion changes nothing: GNO_CLUSTER_SET and the other numbers are read once"
#endif
#ifndef GNO_CLUSTERS_BINDINGS_GLSL
#define GNO_CLUSTERS_BINDINGS_GLSL
#include "cluster.h"
#ifndef GNO_CLUSTER_SET
#define GNO_CLUSTER_SET 1
#endif
#ifndef GNO_CLUSTER_BINDING_FRAME
#define GNO_CLUSTER_BINDING_FRAME 0
#endif
#ifndef GNO_CLUSTER_BINDING_HEADER
#define GNO_CLUSTER_BINDING_HEADER 1
#endif
#ifndef GNO_CLUSTER_BINDING_SLICES
#define GNO_CLUSTER_BINDING_SLICES 2
#endif
#ifndef GNO_CLUSTER_BINDING_MASKS
#define GNO_CLUSTER_BINDING_MASKS 3
#endif
#ifndef GNO_CLUSTER_BINDING_SHADE
#define GNO_CLUSTER_BINDING_SHADE 4
#endif
#ifndef GNO_CLUSTER_BINDING_LOW
#define GNO_CLUSTER_BINDING_LOW 5
#endif
#ifndef GNO_CLUSTER_BINDING_HIGH
#define GNO_CLUSTER_BINDING_HIGH 6
#endif
#ifndef GNO_CLUSTER_BINDING_POINTERS
#define GNO_CLUSTER_BINDING_POINTERS 7
#endif
#ifndef GNO_CLUSTER_BINDING_VOLUMES
#define GNO_CLUSTER_BINDING_VOLUMES 8
#endif
#ifndef GNO_CLUSTER_BINDING_INFO
#define GNO_CLUSTER_BINDING_INFO 9
#endif
#ifndef GNO_CLUSTER_BINDING_JOBS
#define GNO_CLUSTER_BINDING_JOBS 10
#endif
#ifndef GNO_CLUSTER_BUILDS
#define GNO_CLUSTER_BUILDS 0
#endif
#if GNO_CLUSTER_BUILDS  // every pass notes there that it is done
#define GNO_CLUSTER_HEADER_ACCESS_
#else
#define GNO_CLUSTER_HEADER_ACCESS_ readonly
#endif
#if (GNO_CLUSTER_BUILDS) & (1 | GNO_CLUSTER_PASS_SLICES)
#define GNO_CLUSTER_SLICES_ACCESS_
#else
#define GNO_CLUSTER_SLICES_ACCESS_ readonly
#endif
#if (GNO_CLUSTER_BUILDS) & (1 | GNO_CLUSTER_PASS_RESET | GNO_CLUSTER_PASS_TILES | GNO_CLUSTER_PASS_UP | GNO_CLUSTER_PASS_EXPAND | \
    GNO_CLUSTER_PASS_FINISH)
#define GNO_CLUSTER_MASKS_ACCESS_
#else
#define GNO_CLUSTER_MASKS_ACCESS_ readonly
#endif
#if (GNO_CLUSTER_BUILDS) & (1 | GNO_CLUSTER_PASS_RESET | GNO_CLUSTER_PASS_EXPAND | GNO_CLUSTER_PASS_FINISH)
#define GNO_CLUSTER_SHADE_ACCESS_
#else
#define GNO_CLUSTER_SHADE_ACCESS_ readonly
#endif
#if (GNO_CLUSTER_BUILDS) & (1 | GNO_CLUSTER_PASS_TILES | GNO_CLUSTER_PASS_UP)
#define GNO_CLUSTER_LOW_ACCESS_
#else
#define GNO_CLUSTER_LOW_ACCESS_ readonly
#endif
#if (GNO_CLUSTER_BUILDS) & (1 | GNO_CLUSTER_PASS_ALLOCATE)
#define GNO_CLUSTER_POINTERS_ACCESS_
#else
#define GNO_CLUSTER_POINTERS_ACCESS_ readonly
#endif
#if (GNO_CLUSTER_BUILDS) & (1 | GNO_CLUSTER_PASS_VOLUMES)
#define GNO_CLUSTER_VOLUMES_ACCESS_
#else
#define GNO_CLUSTER_VOLUMES_ACCESS_ readonly
#endif
#if (GNO_CLUSTER_BUILDS) & (1 | GNO_CLUSTER_PASS_EXPAND)
#define GNO_CLUSTER_JOBS_ACCESS_
#else
#define GNO_CLUSTER_JOBS_ACCESS_ readonly
#endif

layout(set = GNO_CLUSTER_SET, binding = GNO_CLUSTER_BINDING_FRAME, std140) uniform GnoClusterFrameBuffer {
    GnoClusterFrame v;
    GnoClusterLayout l;
}
gnoClusterFrame;
layout(set = GNO_CLUSTER_SET, binding = GNO_CLUSTER_BINDING_HEADER, std430) GNO_CLUSTER_HEADER_ACCESS_ buffer GnoClusterHeaderBuffer {
    GnoClusterHeader v;
}
gnoClusterHeader;
layout(set = GNO_CLUSTER_SET, binding = GNO_CLUSTER_BINDING_SLICES, std430) GNO_CLUSTER_SLICES_ACCESS_ buffer GnoClusterSliceBuffer { float v[]; }
gnoClusterSliceTable;
layout(set = GNO_CLUSTER_SET, binding = GNO_CLUSTER_BINDING_MASKS, std430) GNO_CLUSTER_MASKS_ACCESS_ buffer GnoClusterMaskBuffer { uint v[]; }
gnoClusterMasks;
layout(set = GNO_CLUSTER_SET, binding = GNO_CLUSTER_BINDING_SHADE, std430) GNO_CLUSTER_SHADE_ACCESS_ buffer GnoClusterShadeBuffer { uint v[]; }
gnoClusterShade;
layout(set = GNO_CLUSTER_SET, binding = GNO_CLUSTER_BINDING_LOW, std430) GNO_CLUSTER_LOW_ACCESS_ buffer GnoClusterLowBuffer { float v[]; }
gnoClusterLow;
layout(set = GNO_CLUSTER_SET, binding = GNO_CLUSTER_BINDING_HIGH, std430) GNO_CLUSTER_LOW_ACCESS_ buffer GnoClusterHighBuffer { float v[]; }
gnoClusterHigh;
layout(set = GNO_CLUSTER_SET, binding = GNO_CLUSTER_BINDING_POINTERS, std430) GNO_CLUSTER_POINTERS_ACCESS_ buffer GnoClusterPointerBuffer {
    uvec2 v[];
}
gnoClusterPointers;
layout(set = GNO_CLUSTER_SET, binding = GNO_CLUSTER_BINDING_VOLUMES, std430) GNO_CLUSTER_VOLUMES_ACCESS_ buffer GnoClusterVolumeBuffer { vec4 v[]; }
gnoClusterVolumes;
layout(set = GNO_CLUSTER_SET, binding = GNO_CLUSTER_BINDING_INFO, std430) GNO_CLUSTER_VOLUMES_ACCESS_ buffer GnoClusterInfoBuffer { uvec2 v[]; }
gnoClusterInfo;
layout(set = GNO_CLUSTER_SET, binding = GNO_CLUSTER_BINDING_JOBS, std430) GNO_CLUSTER_JOBS_ACCESS_ buffer GnoClusterJobBuffer { uvec2 v[]; }
gnoClusterJobs;

#define GNO_CLUSTER_FRAME gnoClusterFrame.v
#define GNO_CLUSTER_LAYOUT gnoClusterFrame.l
#define GNO_CLUSTER_HEADER gnoClusterHeader.v
#define GNO_CLUSTER_STATE gnoClusterState(gnoClusterHeader.v, gnoClusterFrame.v, gnoClusterFrame.l)
#define GNO_CLUSTER_SLICES gnoClusterSliceTable.v
#define GNO_CLUSTER_MASKS gnoClusterMasks.v
#define GNO_CLUSTER_SHADE gnoClusterShade.v
#define GNO_CLUSTER_LOW gnoClusterLow.v
#define GNO_CLUSTER_HIGH gnoClusterHigh.v
#define GNO_CLUSTER_POINTERS gnoClusterPointers.v
#define GNO_CLUSTER_VOLUMES gnoClusterVolumes.v
#define GNO_CLUSTER_INFO gnoClusterInfo.v
#define GNO_CLUSTER_JOBS gnoClusterJobs.v
#endif
