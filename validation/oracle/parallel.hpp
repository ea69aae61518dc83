// SPDX-License-Identifier: MIT
// Work on a range with all threads, while the calling thread reports progress.
#pragma once
#include <cstddef>
#include <functional>

namespace gno::host::oracle {

/// Calls work(begin, end) for chunks that cover [0, count) once, each on one of the machine's threads. `progress` (may be empty) is called on
/// the calling thread, about ten times a second and once at the end, with the part that is done. What `progress` or `work` throws is thrown
/// again here, after all threads have stopped.
void forEachChunk(size_t count, const std::function<void(size_t begin, size_t end)>& work, const std::function<void(double)>& progress);

}  // namespace gno::host::oracle
