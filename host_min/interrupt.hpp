// SPDX-License-Identifier: MIT
// Ctrl-C as an exception, so that destructors remove what is half-written; and a way out when no check is reached, since a driver may compile a
// pipeline for minutes.
#pragma once

namespace gno::host {

/// SIGINT and SIGTERM set a flag; a second one, or kMostSeconds without a check, calls `removeFiles` (async-signal-safe, from any thread), says
/// "PROGRAM: interrupted ..." and ends the process with exit code 1. SIGXFSZ and SIGPIPE are ignored, writes fail instead. Uses alarm().
void catchInterrupts(const char* program, void (*removeFiles)() noexcept);

inline constexpr unsigned kMostSeconds = 2;

void throwIfInterrupted();  ///< the check: Interrupted

}  // namespace gno::host
