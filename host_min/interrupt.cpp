// SPDX-License-Identifier: MIT
#include "host_min/interrupt.hpp"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string>

#include "host_min/error.hpp"

namespace gno::host {
namespace {

constexpr const char* kText = "interrupted; nothing half-written is left";

// What a handler may reach: set before the handlers are, or free of locks.
std::atomic<int> interrupted{0};
static_assert(std::atomic<int>::is_always_lock_free);
void (*removeFilesAtEnd)() noexcept = nullptr;
char lastLine[256];

void endAtOnce() {
    removeFilesAtEnd();
    [[maybe_unused]] const ssize_t ignored = ::write(STDERR_FILENO, lastLine, std::strlen(lastLine));
    ::_exit(1);
}

void onInterrupt(int) {
    const int before = errno;
    if (interrupted.exchange(1) != 0) endAtOnce();
    ::alarm(kMostSeconds);
    errno = before;
}

void onAlarm(int) { endAtOnce(); }

}  // namespace

void catchInterrupts(const char* program, void (*removeFiles)() noexcept) {
    removeFilesAtEnd = removeFiles;
    const std::string wipe = ::isatty(STDERR_FILENO) ? "\r\033[K" : "";  // a progress line may stand there
    const std::string line = (wipe + program + ": " + kText).substr(0, sizeof lastLine - 2) + "\n";
    std::memcpy(lastLine, line.c_str(), line.size() + 1);
    std::signal(SIGALRM, onAlarm);
    std::signal(SIGINT, onInterrupt);
    std::signal(SIGTERM, onInterrupt);
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
}

void throwIfInterrupted() {
    if (interrupted == 0) return;
    ::alarm(0);  // destructors do the rest
    throw Interrupted(kText);
}

}  // namespace gno::host
