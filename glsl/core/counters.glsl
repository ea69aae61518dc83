// SPDX-License-Identifier: MIT
// gnomon core/counters.glsl : what one invocation did, counted only where the shader is compiled with GNO_COUNTERS 1.
//
//   GNO_COUNT(member, amount)      adds to gnoCounters.member
//   GNO_COUNT_MAX(member, value)   keeps the largest
//
// Space      none: no positions
// Stages     any; a private global of the invocation, no memory is touched: the entry point stores what it wants of it
// Requires   #version 450, no extension
// Cost       nothing with GNO_COUNTERS 0: the macros are empty and the global does not exist
//
// Macro        required  default  meaning
// GNO_COUNTERS no        0        1: count
#ifndef GNO_CORE_COUNTERS_GLSL
#define GNO_CORE_COUNTERS_GLSL
#include "shared_types.h"
#ifndef GNO_COUNTERS
#define GNO_COUNTERS 0
#endif

#if GNO_COUNTERS
struct GnoCounters {
    uint visitedNodes;    // node loads of a query, second visits included
    uint deepestStack;    // entries on the stack at its fullest
    uint stackOverflows;  // intersection children that found the stack full
    uint exactCalls;      // planes (conservative: volumes) that were left to the last word
    uint buildSteps;      // nodes an insertion went through
    uint intersections;   // steps of an insertion into an intersection child
    uint dropped;         // insertions that ended inside another volume
    uint nodeTests;       // nodes of a cluster hierarchy tested against a volume
    uint planeTests;      // planes looked at for that
    uint leafTests;       // view samples tested against a volume
    uint accepted;        // nodes that lay wholly inside a volume
    uint rays;            // ray queries
    uint candidates;      // casters that a ray query offered, the sample's own included
};
GnoCounters gnoCounters = GnoCounters(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
#define GNO_COUNT(member_, amount_) gnoCounters.member_ += (amount_)
#define GNO_COUNT_MAX(member_, value_) gnoCounters.member_ = max(gnoCounters.member_, (value_))
#else
#define GNO_COUNT(member_, amount_)
#define GNO_COUNT_MAX(member_, value_)
#endif
#endif
