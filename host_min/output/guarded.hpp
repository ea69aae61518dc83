// SPDX-License-Identifier: MIT
// What stands around the work of every program here.
#pragma once
#include <functional>

namespace gno::host {

/// Runs `run` and returns its exit code; an exception becomes one line on standard error, "PROGRAM: TEXT", and 2 (InputError, RoomError, no
/// memory) or 1 (all else). Standard output that did not go out is an error as well, 2 on a full disk and 1 when its reader is gone. `lessMemory`:
/// what to do when memory ran out, "use a smaller --size".
int guarded(const char* program, const char* lessMemory, const std::function<int()>& run);

}  // namespace gno::host
