// SPDX-License-Identifier: MIT
// gnomon clusters/traverse.glsl : every shadow volume against the hierarchy, one subgroup per volume.
// After Sintorn et al., I3D 2014, section 2 ("Traversal"), 2.2 and algorithm 1; certified decisions are this project's.
//
//   void gnoClusterExpand()       pass 1: takes casters until none is left
//   void gnoClusterFinish()       pass 2, only with frame.split > 0: takes the jobs that pass 1 left; by indirect dispatch, say
//   (examples/finish_size.comp)
//
// A node's 32 children are tested by as many lanes as are active: a child that lies wholly outside one plane of the volume is rejected, one
// that lies wholly inside all
// of them is accepted (its bit is cleared: all its samples are in shadow; other volumes need not look at it again), the rest is pending. The walk is
// depth first, with one word of pending children per level. At a cluster, the lanes test the tile's samples (the paper's way: all of the tile's, not
// only the cluster's) that are not dark yet.
// Load balance: pass 1 goes down to depth frame.split and leaves (caster, node) in a list; pass 2 finishes it. A job that finds the list full is
// finished in place.
// A caster that lets light through accepts no node: what it takes depends on where the light crosses it, sample by sample. It tests the cluster's
// own samples only, so that it meets each sample at most once.
// Persistent threads: a subgroup takes its next job from a counter and waits for nobody; any number of work groups is right, one too.
//
// conservative, certified    a node is rejected or accepted only where the exact planes certainly say so (bounds.glsl, volume.glsl); a sample inside
//                            a plane's band is left
//                            to core/decide.glsl. An accepted sample is strictly behind the caster, so never on it: `own` matters at samples only
// published                  fp32 signs as they are, the capping plane pushed away by GNO_CLUSTER_BIAS unless front faces are culled, own casters
//                            not skipped
//
// Space      positions on the scene grid
// Stages     compute; subgroups of 1 to 128; all invocations of a subgroup that are active call together. These are counted: gl_SubgroupSize tells
//            how
//            many there may be, not how many there are (a driver may run fewer, a work group may not fill its last subgroup). Work groups of any
//            size;
//            32 invocations and a multiple of the subgroup's size waste none
// Requires   #version 450, GL_KHR_shader_subgroup_basic and GL_KHR_shader_subgroup_ballot
// Reads      volumes, info, low, high, pointers, slices, samples, casters (in the band only); masks, shade (atomically)
// Writes     masks, shade, jobs, header
//
// Macro                             required  default                   meaning
// GNO_CLUSTER_BUILDS                no        1                         which functions this shader has: GNO_CLUSTER_PASS_EXPAND, .._FINISH, both
//                                                                       with |, or 1 for both
// GNO_CLUSTER_HEADER                yes       -                         GnoClusterHeader in a storage buffer
// GNO_CLUSTER_SHADE                 yes       -                         array of uint, gnoClusterShadeWords
// GNO_CLUSTER_VOLUMES               yes       -                         array of vec4, 7 per caster
// GNO_CLUSTER_INFO                  yes       -                         array of uvec2, one per caster
// GNO_CLUSTER_JOBS                  yes       -                         array of uvec2, frame.jobCapacity: caster, key
// GNO_CLUSTER_LOAD_SAMPLE(pixel)    yes       -                         GnoViewSample at ivec2 pixel (inside the image only)
// GNO_LIGHT                         yes       -                         vec4, homogeneous (core/light.glsl)
// GNO_LOAD_CASTER(index)            yes       -                         GnoCaster
// GNO_PRECISION                     no        GNO_PRECISION_CERTIFIED   rung of the ladder; the volumes must use the same
// GNO_CLUSTER_BIAS                  no        0.00001525f               published only, grid units
// GNO_CLUSTER_LAYERS                no        0                         1: some casters let light through
// GNO_CLUSTER_IS_OPAQUE(caster)     no        true                      false: light passes caster in places; asked with GNO_CLUSTER_LAYERS 1
// GNO_CLUSTER_LAYER(c, t, pixel, p) no        true                      bool: nothing passes caster c, whose triangle is t, towards sample p at
//                                             uvec2 pixel; else what passes
//                                                                       is noted by this expression (core/transmittance.glsl); asked once per such
//                                                                       pair
// GNO_CLUSTER_ON_LEAF_TEST(pixel)   no        nothing                   a statement that runs for each sample that is tested (to count them)
// GNO_CLUSTER_ON_JOB(job)           no        nothing                   a statement that runs when a job is done; gnoClusterSteps holds its
//                                                                       iterations
// The macros of nodes.glsl
#ifndef GNO_CLUSTERS_TRAVERSE_GLSL
#define GNO_CLUSTERS_TRAVERSE_GLSL
#include "../core/counters.glsl"
#include "../core/debug.glsl"
#include "../core/decide.glsl"
#include "../top/plane.glsl"
#include "bounds.glsl"
#include "nodes.glsl"
#ifndef GNO_CLUSTER_BUILDS
#define GNO_CLUSTER_BUILDS 1
#endif
#if !((GNO_CLUSTER_BUILDS) & (1 | GNO_CLUSTER_PASS_EXPAND | GNO_CLUSTER_PASS_FINISH))
#error "clusters/traverse.glsl: which pass is this? define GNO_CLUSTER_BUILDS before clusters/bindings.glsl, as clusters/cluster.h says"
#endif
#if !defined(GNO_CLUSTER_HEADER) || !defined(GNO_CLUSTER_SHADE) || !defined(GNO_CLUSTER_VOLUMES) || !defined(GNO_CLUSTER_INFO)
#error "clusters/traverse.glsl: define GNO_CLUSTER_HEADER, GNO_CLUSTER_SHADE, GNO_CLUSTER_VOLUMES and GNO_CLUSTER_INFO (or include bindings.glsl)"
#endif
#ifndef GNO_CLUSTER_JOBS
#error "clusters/traverse.glsl: define GNO_CLUSTER_JOBS (or include bindings.glsl)"
#endif
#ifndef GNO_CLUSTER_LOAD_SAMPLE
#error "clusters/traverse.glsl: define GNO_CLUSTER_LOAD_SAMPLE(pixel)"
#endif
#ifndef GNO_LIGHT
#error "clusters/traverse.glsl: define GNO_LIGHT, a homogeneous vec4"
#endif
#ifndef GNO_LOAD_CASTER
#error "clusters/traverse.glsl: define GNO_LOAD_CASTER(index) or include core/bindings.glsl before this file"
#endif
#ifndef GNO_PRECISION
#define GNO_PRECISION GNO_PRECISION_CERTIFIED
#endif
#ifndef GNO_CLUSTER_BIAS
#define GNO_CLUSTER_BIAS 0.00001525f
#endif
#ifndef GNO_CLUSTER_LAYERS
#define GNO_CLUSTER_LAYERS 0
#endif
#ifndef GNO_CLUSTER_IS_OPAQUE
#define GNO_CLUSTER_IS_OPAQUE(caster_) true
#endif
#ifndef GNO_CLUSTER_LAYER
#define GNO_CLUSTER_LAYER(c_, t_, pixel_, p_) true
#endif
#ifndef GNO_CLUSTER_ON_LEAF_TEST
#define GNO_CLUSTER_ON_LEAF_TEST(pixel_)
#endif
#ifndef GNO_CLUSTER_ON_JOB
#define GNO_CLUSTER_ON_JOB(job_)
#endif

struct GnoClusterLanes_ {  // the subgroup's invocations that are active
    uvec4 ids;             // a bit each
    uint count;
    uint rank;  // of this one among them
    bool gaps;  // their ids are not 0, 1, 2, ...
};

struct GnoClusterVolume_ {
    uint caster;
    int facing;
    float reach;
    bool opaque;
    vec4 ab, bc, ca, cap;
    vec4 extraA, extraB, extraC;
};

uint gnoClusterSteps = 0u;  // nodes opened and clusters tested by the job under way

GnoClusterVolume_ gnoClusterLoadVolume_(uint caster_) {
    GnoClusterVolume_ v_;
    uvec2 info_ = GNO_CLUSTER_INFO[caster_];
    uint at_ = 7u * caster_;
    v_.caster = caster_;
    v_.facing = int(info_.x) - 1;
    v_.reach = uintBitsToFloat(info_.y);
#if GNO_CLUSTER_LAYERS
    v_.opaque = GNO_CLUSTER_IS_OPAQUE(caster_);
#else
    v_.opaque = true;
#endif
    v_.ab = GNO_CLUSTER_VOLUMES[at_];
    v_.bc = GNO_CLUSTER_VOLUMES[at_ + 1u];
    v_.ca = GNO_CLUSTER_VOLUMES[at_ + 2u];
    v_.cap = GNO_CLUSTER_VOLUMES[at_ + 3u];
    if (GNO_PRECISION == GNO_PRECISION_PUBLISHED && GNO_CLUSTER_FRAME.frontCulled == 0u) v_.cap.w += GNO_CLUSTER_BIAS;
    bool extra_ = GNO_CLUSTER_FRAME.extraPlanes != 0u;
    v_.extraA = extra_ ? GNO_CLUSTER_VOLUMES[at_ + 4u] : vec4(0.0);
    v_.extraB = extra_ ? GNO_CLUSTER_VOLUMES[at_ + 5u] : vec4(0.0);
    v_.extraC = extra_ ? GNO_CLUSTER_VOLUMES[at_ + 6u] : vec4(0.0);
    return v_;
}

float gnoClusterMargin_(GnoClusterVolume_ v_, GnoClusterBounds bounds_, bool cap_) {
    if (GNO_PRECISION == GNO_PRECISION_PUBLISHED) return 0.0;
    return gnoTopMargin(GNO_LIGHT, cap_, bounds_.scale, v_.reach) + bounds_.uncertain;
}

// 0: no sample of the bounds is in the volume; 2: all of them are; 1: cannot tell.
uint gnoClusterClassify_(GnoClusterVolume_ v_, GnoClusterBounds bounds_) {
    bool inside_ = true;
    uint planes_ = GNO_CLUSTER_FRAME.extraPlanes == 0u ? 4u : 7u;
    for (uint i_ = 0u; i_ < planes_; ++i_) {  // the cap first: it rejects most
        vec4 plane_ = i_ == 0u   ? v_.cap
                      : i_ == 1u ? v_.ab
                      : i_ == 2u ? v_.bc
                      : i_ == 3u ? v_.ca
                      : i_ == 4u ? v_.extraA
                      : i_ == 5u ? v_.extraB
                                 : v_.extraC;
        float margin_ = i_ < 4u ? gnoClusterMargin_(v_, bounds_, i_ == 0u) : 8.0 * GNO_BAND * bounds_.scale + bounds_.uncertain;
        GNO_COUNT(planeTests, 1u);
        vec2 range_ = gnoClusterRange(GNO_CLUSTER_FRAME, GNO_LIGHT, bounds_, plane_);
        if (range_.x > margin_) return 0u;
        inside_ = inside_ && range_.y < -margin_;
        if (inside_ && i_ == 3u) return v_.opaque ? 2u : 1u;
    }
    return 1u;
}

// Bounds of the node at depth 1 .. levels by its key and depths alone.
GnoClusterBounds gnoClusterCellOf_(uint depth_, uint key_, float near_, float far_) {
    uint below_ = 5u * (GNO_CLUSTER_LAYOUT.levels - depth_);  // bits of the key under this node
    uint maskX_ = GNO_CLUSTER_LAYOUT.maskX >> below_;
    uint maskY_ = GNO_CLUSTER_LAYOUT.maskY >> below_;
    uint maskZ_ = GNO_CLUSTER_LAYOUT.maskZ >> below_;
    uint bits_ = (1u << below_) - 1u;
    uvec3 size_ = uvec3(1u) << uvec3(bitCount(GNO_CLUSTER_LAYOUT.maskX & bits_), bitCount(GNO_CLUSTER_LAYOUT.maskY & bits_),
                                     bitCount(GNO_CLUSTER_LAYOUT.maskZ & bits_));
    uvec2 first_ = uvec2(gnoClusterExtract(key_, maskX_), gnoClusterExtract(key_, maskY_)) * uvec2(size_.x, size_.y);
    if (GNO_CLUSTER_FORM != GNO_CLUSTER_FLAT) {
        uint slice_ = gnoClusterExtract(key_, maskZ_) * size_.z;
        near_ = GNO_CLUSTER_SLICES[slice_];
        far_ = GNO_CLUSTER_SLICES[slice_ + size_.z];
    }
    return gnoClusterCell(GNO_CLUSTER_FRAME, GNO_CLUSTER_LAYOUT, GNO_LIGHT, first_, first_ + uvec2(size_.x, size_.y), near_, far_,
                          uintBitsToFloat(GNO_CLUSTER_HEADER.slack));
}

GnoClusterBounds gnoClusterBoundsOf_(uint depth_, uint key_) {
    if (GNO_CLUSTER_FORM == GNO_CLUSTER_IMPLICIT) return gnoClusterCellOf_(depth_, key_, 0.0, 0.0);
    uint box_ = gnoClusterBoxIndex(depth_, key_);
    if (GNO_CLUSTER_FORM == GNO_CLUSTER_FLAT) return gnoClusterCellOf_(depth_, key_, GNO_CLUSTER_LOW[box_], GNO_CLUSTER_HIGH[box_]);
    vec3 low_ = vec3(1.0);
    vec3 high_ = vec3(-1.0);
    if (box_ != GNO_CLUSTER_NONE) {
        low_ = gnoClusterLow_(box_);
        high_ = gnoClusterHigh_(box_);
    }
    if (GNO_CLUSTER_FORM == GNO_CLUSTER_COMPACT && low_.x > high_.x) return gnoClusterCellOf_(depth_, key_, 0.0, 0.0);
    return gnoClusterBox(GNO_LIGHT, low_, high_);
}

// What other subgroups change meanwhile is read by an atomic, once per subgroup.
uint gnoClusterReadMask_(uint word_) {
    uint mask_ = 0u;
    if (subgroupElect()) mask_ = atomicOr(GNO_CLUSTER_MASKS[word_], 0u);
    return subgroupBroadcastFirst(mask_);
}

uint gnoClusterReadShade_(uint word_) {
    uint mask_ = 0u;
    if (subgroupElect()) mask_ = atomicOr(GNO_CLUSTER_SHADE[word_], 0u);
    return subgroupBroadcastFirst(mask_);
}

GnoClusterLanes_ gnoClusterCountLanes_() {
    GnoClusterLanes_ lanes_;
    lanes_.ids = subgroupBallot(true);
    lanes_.count = subgroupBallotBitCount(lanes_.ids);
    lanes_.rank = subgroupBallotExclusiveBitCount(lanes_.ids);
    lanes_.gaps = lanes_.ids.x != (lanes_.count < 32u ? (1u << lanes_.count) - 1u : 0xFFFFFFFFu);
    return lanes_;
}

// Bit r: the invocation of rank r < 32 voted for it. A ballot has it at that invocation's id.
uint gnoClusterByRank_(GnoClusterLanes_ lanes_, uvec4 ballot_) {
    if (!lanes_.gaps) return ballot_.x;
    uint result_ = 0u;
    uint rank_ = 0u;
    for (uint word_ = 0u; word_ < 4u; ++word_) {
        for (uint rest_ = lanes_.ids[word_]; rest_ != 0u && rank_ < 32u; rest_ &= rest_ - 1u) {
            uint lowest_ = rest_ & (~rest_ + 1u);
            if ((ballot_[word_] & lowest_) != 0u) result_ |= 1u << rank_;
            ++rank_;
        }
    }
    return result_;
}

// Opens the inner node at depth 0 .. levels - 1: children to go into.
uint gnoClusterOpen_(GnoClusterLanes_ lanes_, GnoClusterVolume_ v_, uint depth_, uint key_) {
    uint word_ = gnoClusterWord(GNO_CLUSTER_LAYOUT, depth_, key_);
    uint alive_ = gnoClusterReadMask_(word_);
    uint pending_ = 0u;
    uint accepted_ = 0u;
    for (uint base_ = 0u; base_ < 32u; base_ += lanes_.count) {
        uint child_ = base_ + lanes_.rank;
        uint class_ = 0u;
        if (child_ < 32u && (alive_ & (1u << child_)) != 0u) {
            GNO_COUNT(nodeTests, 1u);
            class_ = gnoClusterClassify_(v_, gnoClusterBoundsOf_(depth_ + 1u, (key_ << 5u) | child_));
        }
        pending_ |= gnoClusterByRank_(lanes_, subgroupBallot(class_ == 1u)) << base_;
        accepted_ |= gnoClusterByRank_(lanes_, subgroupBallot(class_ == 2u)) << base_;
    }
    if (accepted_ != 0u && subgroupElect()) {
        atomicAnd(GNO_CLUSTER_MASKS[word_], ~accepted_);
        GNO_COUNT(accepted, uint(bitCount(accepted_)));
    }
    return pending_;
}

bool gnoClusterHolds_(GnoClusterVolume_ v_, vec3 p_) {
    vec3 q_ = gnoFromLight(GNO_LIGHT, p_);
    float cap_ = gnoTopSide(v_.cap, q_);
    vec3 lateral_ = vec3(gnoTopSide(v_.ab, q_), gnoTopSide(v_.bc, q_), gnoTopSide(v_.ca, q_));
    float most_ = max(lateral_.x, max(lateral_.y, lateral_.z));
    if (GNO_PRECISION == GNO_PRECISION_PUBLISHED) return cap_ < 0.0 && most_ <= 0.0;
    float scale_ = gnoLightScale(GNO_LIGHT, q_);
    float capBand_ = gnoTopBand(GNO_LIGHT, true, scale_, v_.reach);
    float band_ = gnoTopBand(GNO_LIGHT, false, scale_, v_.reach);
    if (cap_ > capBand_ || most_ > band_) return false;
    if (cap_ < -capBand_ && most_ < -band_) return true;
    GNO_COUNT(exactCalls, 1u);
    GnoCaster t_ = GNO_LOAD_CASTER(v_.caster);
    if (GNO_PRECISION == GNO_PRECISION_CERTIFIED) return gnoInShadowOfFacing(GNO_LIGHT, t_, p_, v_.facing);
    return gnoDecideInShadow(GNO_LIGHT, t_, p_, GNO_PRECISION);
}

// All samples of the cluster's tile that are not dark yet.
void gnoClusterTest_(GnoClusterLanes_ lanes_, GnoClusterVolume_ v_, uint key_) {
    uvec2 tile_ = uvec2(gnoClusterExtract(key_, GNO_CLUSTER_LAYOUT.maskX), gnoClusterExtract(key_, GNO_CLUSTER_LAYOUT.maskY));
    uint words_ = gnoClusterTileHeight(GNO_CLUSTER_LAYOUT) / 4u;
    uint word_ = (tile_.y * GNO_CLUSTER_LAYOUT.tiles.x + tile_.x) * words_;
    for (uint half_ = 0u; half_ < words_; ++half_) {
        uint dark_ = gnoClusterReadShade_(word_ + half_);
        uint found_ = 0u;
        for (uint base_ = 0u; base_ < 32u; base_ += lanes_.count) {
            uint bit_ = base_ + lanes_.rank;
            uvec2 pixel_ = gnoClusterTilePixel(GNO_CLUSTER_FORM, tile_, 32u * half_ + bit_);
            bool inside_ = false;
            if (bit_ < 32u && (dark_ & (1u << bit_)) == 0u && all(lessThan(pixel_, GNO_CLUSTER_FRAME.size))) {
                GnoViewSample s_ = GNO_CLUSTER_LOAD_SAMPLE(ivec2(pixel_));
                bool skip_ = GNO_PRECISION != GNO_PRECISION_PUBLISHED && s_.own == v_.caster;
#if GNO_CLUSTER_LAYERS
                // what passes is added up: not again from the tile's other clusters
                if (!v_.opaque && s_.own <= GNO_NO_CASTER && GNO_CLUSTER_FORM != GNO_CLUSTER_FLAT)
                    skip_ = skip_ || gnoClusterLeafKey(tile_, gnoClusterDepth(GNO_CLUSTER_FRAME, s_.position)) != key_;
#endif
                if (s_.own <= GNO_NO_CASTER && !skip_) {
                    GNO_COUNT(leafTests, 1u);
                    GNO_CLUSTER_ON_LEAF_TEST(pixel_);
                    inside_ = gnoClusterHolds_(v_, s_.position);
#if GNO_CLUSTER_LAYERS
                    if (inside_ && !v_.opaque) inside_ = GNO_CLUSTER_LAYER(v_.caster, GNO_LOAD_CASTER(v_.caster), pixel_, s_.position);
#endif
                }
            }
            found_ |= gnoClusterByRank_(lanes_, subgroupBallot(inside_)) << base_;
        }
        if (found_ != 0u && subgroupElect()) atomicOr(GNO_CLUSTER_SHADE[word_ + half_], found_);
    }
}

// True: the job stands in the list.
bool gnoClusterLeave_(uint caster_, uint key_) {
#if (GNO_CLUSTER_BUILDS) & (1 | GNO_CLUSTER_PASS_EXPAND)
    uint slot_ = 0u;
    if (subgroupElect()) {
        slot_ = atomicAdd(GNO_CLUSTER_HEADER.jobCount, 1u);
        if (slot_ < GNO_CLUSTER_FRAME.jobCapacity) GNO_CLUSTER_JOBS[slot_] = uvec2(caster_, key_);
    }
    return subgroupBroadcastFirst(slot_) < GNO_CLUSTER_FRAME.jobCapacity;
#else
    return false;
#endif
}

// From the node at depth `start` on; jobs are left at depth `split`, 0: nowhere. Each turn opens one node, tests one cluster, or goes back up.
void gnoClusterTraverse_(uint caster_, uint start_, uint key_, uint split_) {
    GnoClusterVolume_ v_ = gnoClusterLoadVolume_(caster_);
    GnoClusterLanes_ lanes_ = gnoClusterCountLanes_();
    gnoClusterSteps = 0u;
    if (v_.facing == 0) return;
    uint levels_ = GNO_CLUSTER_LAYOUT.levels;
    uint pending_[GNO_CLUSTER_MOST_LEVELS + 1u];
    uint depth_ = start_;
    bool fresh_ = true;  // the node at depth_ was not looked at yet
    GNO_DEBUG_TURNS_;
    while (true) {
        GNO_DEBUG_TURN_(break);
        if (fresh_) {
            ++gnoClusterSteps;
            pending_[depth_] = 0u;
            if (depth_ == levels_) gnoClusterTest_(lanes_, v_, key_);
            else pending_[depth_] = gnoClusterOpen_(lanes_, v_, depth_, key_);
        }
        fresh_ = pending_[depth_] != 0u;
        if (fresh_) {
            uint child_ = uint(findMSB(pending_[depth_]));
            pending_[depth_] ^= 1u << child_;
            uint childKey_ = (key_ << 5u) | child_;
            if (depth_ + 1u == split_ && gnoClusterLeave_(caster_, childKey_)) {
                fresh_ = false;
            } else {
                ++depth_;
                key_ = childKey_;
            }
        } else {
            if (depth_ == start_) break;
            --depth_;
            key_ >>= 5u;
        }
    }
}

#if (GNO_CLUSTER_BUILDS) & (1 | GNO_CLUSTER_PASS_EXPAND)
void gnoClusterExpand() {
    // Nothing of this is written meanwhile. Without it no caster is taken, and the merge knows.
    if (GNO_CLUSTER_HEADER.volumes != gnoState(GNO_PRECISION)) return;
    if (!gnoClusterIsBuilt(GNO_CLUSTER_HEADER.state, GNO_CLUSTER_HEADER.tiles, GNO_CLUSTER_HEADER.levels, GNO_CLUSTER_HEADER.boxCount,
                           GNO_CLUSTER_LAYOUT))
        return;
    uint split_ = min(GNO_CLUSTER_FRAME.split, GNO_CLUSTER_LAYOUT.levels);
    while (true) {
        uint job_ = 0u;
        if (subgroupElect()) job_ = atomicAdd(GNO_CLUSTER_HEADER.nextCaster, 1u);
        job_ = subgroupBroadcastFirst(job_);
        if (job_ >= GNO_CLUSTER_FRAME.casterCount) break;
        gnoClusterTraverse_(job_, 0u, 0u, split_);
        GNO_CLUSTER_ON_JOB(job_);
    }
}
#endif

#if (GNO_CLUSTER_BUILDS) & (1 | GNO_CLUSTER_PASS_FINISH)
void gnoClusterFinish() {
    uint jobs_ = min(GNO_CLUSTER_HEADER.jobCount, GNO_CLUSTER_FRAME.jobCapacity);
    uint split_ = min(GNO_CLUSTER_FRAME.split, GNO_CLUSTER_LAYOUT.levels);
    while (true) {
        uint job_ = 0u;
        if (subgroupElect()) job_ = atomicAdd(GNO_CLUSTER_HEADER.nextJob, 1u);
        job_ = subgroupBroadcastFirst(job_);
        if (job_ >= jobs_) break;
        uvec2 what_ = GNO_CLUSTER_JOBS[job_];
        gnoClusterTraverse_(what_.x, split_, what_.y, 0u);
        GNO_CLUSTER_ON_JOB(job_);
    }
}
#endif
#endif
