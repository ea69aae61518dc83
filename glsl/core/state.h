// SPDX-License-Identifier: MIT
// gnomon core/state.h : the word that tells a query whether it may ask a structure; read by glslang and by C++20 (namespace gno).
//
//   uint gnoState(uint precision)               the structure is built, all of it, on this rung and by this version of the modules
//   uint gnoIncompleteState(uint precision)     the same, but a pool was too small: grow it and build again
//
// Each structure has such a word in its header. Passes that begin a build take it away, the pass that knows that all is done gives it back, and the
// boundary between dispatches publishes it. A query compares it with gnoState(its own GNO_PRECISION) before it follows anything, and answers
// GNO_VISIBILITY_UNKNOWN where they differ. No memory that was merely cleared or filled looks built.
//
//   bits 31..16  0x474E        bits 3..2  2: complete, 1: incomplete
//   bits 15..4   the version: 64 * major + minor, which is what may change a layout        bits 1..0  precision, or GNO_STATE_ANY
//
// A module's GNO_..._STATE macro is this word. Where your storage has none, say so: #define GNO_TOP_STATE gnoState(GNO_PRECISION) is always as
// expected, and nothing is checked.
//
// Space      none: no positions
// Stages     any; pure
// Requires   #version 450, no extension
#ifndef GNO_CORE_STATE_H
#define GNO_CORE_STATE_H
#include "shared_types.h"
#include "version.h"
GNO_NAMESPACE_BEGIN

GNO_CONST uint GNO_STATE_ANY = 3u;  // in place of a precision: the structure is the same on every rung

GNO_INLINE uint gnoStateWord_(uint stage_, uint precision_) {
    return 0x474E0000u | (uint(GNO_VERSION_MAJOR) << 10) | (uint(GNO_VERSION_MINOR) << 4) | (stage_ << 2) | precision_;
}

GNO_INLINE uint gnoState(uint precision_) { return gnoStateWord_(2u, precision_); }

GNO_INLINE uint gnoIncompleteState(uint precision_) { return gnoStateWord_(1u, precision_); }

GNO_NAMESPACE_END
#endif
