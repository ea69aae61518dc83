// SPDX-License-Identifier: MIT
#include "host_min/interrupt.hpp"

#include <csignal>

#include "host_min/error.hpp"

namespace gno::host {
namespace {
volatile std::sig_atomic_t interrupted = 0;  // a signal handler can reach nothing else
}

void catchInterrupts() {
    std::signal(SIGINT, [](int) { interrupted = 1; });
    std::signal(SIGTERM, [](int) { interrupted = 1; });
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
}

void throwIfInterrupted() {
    if (interrupted != 0) throw WorkError("interrupted; nothing half-written is left");
}

}  // namespace gno::host
