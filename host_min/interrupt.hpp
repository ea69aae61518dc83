// SPDX-License-Identifier: MIT
// Ctrl-C as an exception, so that destructors remove what is half-written.
#pragma once

namespace gno::host {

void catchInterrupts();     ///< SIGINT and SIGTERM set a flag; SIGXFSZ and SIGPIPE are ignored, writes fail instead
void throwIfInterrupted();  ///< WorkError "interrupted"

}  // namespace gno::host
