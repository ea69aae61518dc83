// SPDX-License-Identifier: MIT
// gnomon core/debug.glsl : what should not happen, looked for only where the shader is compiled with GNO_DEBUG 1.
//
// Loops over what an earlier pass wrote (queries, insertions, traversal) are bounded then, and indices are held against their array where its
// length is known. What passes a bound is counted in gnoDebugFaults, a private global of the invocation: `endless` loops, indices `outside`. The
// query answers GNO_VISIBILITY_UNKNOWN, the insertion or the job ends.
//
// Space      none: no positions
// Stages     any; no memory is touched: the entry point stores what it wants of gnoDebugFaults
// Requires   #version 450, no extension
// Cost       nothing with GNO_DEBUG 0: no instruction and no register, the global does not exist
//
// Macro                     required  default                    meaning
// GNO_DEBUG                 no        0                          1: look for it
// GNO_DEBUG_LIMIT           no        1048576u                   turns of a loop that are too many
// GNO_DEBUG_REPORT(fault)   no        ++gnoDebugFaults.fault     an expression: fault is `endless` or `outside`
#ifndef GNO_CORE_DEBUG_GLSL
#define GNO_CORE_DEBUG_GLSL
#include "shared_types.h"
#ifndef GNO_DEBUG
#define GNO_DEBUG 0
#endif

#if GNO_DEBUG
struct GnoDebugFaults {
    uint endless;
    uint outside;
};
GnoDebugFaults gnoDebugFaults = GnoDebugFaults(0u, 0u);
#ifndef GNO_DEBUG_LIMIT
#define GNO_DEBUG_LIMIT 1048576u
#endif
#ifndef GNO_DEBUG_REPORT
#define GNO_DEBUG_REPORT(fault_) ++gnoDebugFaults.fault_
#endif
#define GNO_DEBUG_TURNS_ uint debugTurns_ = 0u  // before a loop
#define GNO_DEBUG_TURN_(end_)             \
    if (++debugTurns_ > GNO_DEBUG_LIMIT) { \
        GNO_DEBUG_REPORT(endless);         \
        end_;                              \
    }
#define GNO_DEBUG_INSIDE_(index_, count_, end_) \
    if ((index_) >= (count_)) {                 \
        GNO_DEBUG_REPORT(outside);              \
        end_;                                   \
    }
#else
#define GNO_DEBUG_TURNS_
#define GNO_DEBUG_TURN_(end_)
#define GNO_DEBUG_INSIDE_(index_, count_, end_)
#endif
#endif
