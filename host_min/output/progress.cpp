// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "host_min/output/table.hpp"

namespace gno::host {

namespace {

std::size_t terminalColumns() {
    winsize size{};
    return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1 ? size.ws_col : 80;
}

bool isDumb() {
    const char* term = std::getenv("TERM");
    return term == nullptr || std::string_view(term) == "dumb";
}

}  // namespace

Progress::Progress() : terminal_(::isatty(STDERR_FILENO) != 0 && !isDumb()) {}

Progress::~Progress() { clear(); }

void Progress::show(std::string_view what, double fraction) {
    if (!terminal_) return;
    using namespace std::chrono;
    const long long now = duration_cast<nanoseconds>(steady_clock::now().time_since_epoch()).count();
    if (shown_ && what == lastWhat_ && now - lastNs_ < 100'000'000) return;
    lastNs_ = now;
    lastWhat_ = what;
    shown_ = true;
    std::string line(what);
    if (fraction >= 0) {
        const int percent = static_cast<int>(std::min(fraction, 1.0) * 100);
        const auto done = static_cast<std::size_t>(percent / 5);
        line += fmt::format("  [{}{}] {:3} %", std::string(done, '#'), std::string(20 - done, '.'), percent);
    } else {
        line += " ...";
    }
    line.resize(std::min(line.size(), terminalColumns() - 1));
    std::fputs(("\r\033[K" + line).c_str(), stderr);
    std::fflush(stderr);
}

void Progress::clear() {
    if (!shown_) return;
    shown_ = false;
    std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
}

}  // namespace gno::host
