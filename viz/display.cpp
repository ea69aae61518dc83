// SPDX-License-Identifier: MIT
#include "viz/display.hpp"

#include <X11/Xlib.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <string>

#include "host_min/error.hpp"

namespace gno::viz {
namespace {

constexpr const char* kNoDisplay = "no display: DISPLAY names none that answers, and Xvfb";
constexpr int kStartSeconds = 30;

/// What Xvfb says on its -displayfd once it takes connections: its number. Empty: it ended, or said nothing for kStartSeconds.
std::string readNumber(int fd) {
    std::string text;
    std::array<char, 16> bytes;
    pollfd wait{fd, POLLIN, 0};
    while (text.find('\n') == std::string::npos) {
        const int ready = ::poll(&wait, 1, kStartSeconds * 1000);
        if (ready < 0 && errno == EINTR) continue;
        const ssize_t count = ready > 0 ? ::read(fd, bytes.data(), bytes.size()) : 0;
        if (count <= 0) return {};
        text.append(bytes.data(), size_t(count));
    }
    return text.substr(0, text.find('\n'));
}

}  // namespace

Display::Display() {
    if (!connect()) startServer();
}

bool Display::connect() {
    connection_ = XOpenDisplay(nullptr);
    return connection_ != nullptr;
}

void Display::startServer() {
    std::array<int, 2> ends;
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw host::WorkError("cannot make a pipe to Xvfb");
    const pid_t parent = ::getpid();
    server_ = ::fork();
    if (server_ == 0) {
        ::prctl(PR_SET_PDEATHSIG, SIGTERM);
        if (::getppid() != parent) _exit(1);
        ::setpgid(0, 0);  // Ctrl-C is for us, and ends it through our destructor
        const int null = ::open("/dev/null", O_RDWR);
        ::dup2(null, STDIN_FILENO);
        ::dup2(null, STDOUT_FILENO);
        ::dup2(null, STDERR_FILENO);
        const int fd = ::dup(ends[1]);  // without close-on-exec
        // -noreset: else the server starts anew, and refuses connections meanwhile, whenever its last client leaves
        ::execlp("Xvfb", "Xvfb", "-noreset", "-displayfd", std::to_string(fd).c_str(), "-screen", "0", "1280x1024x24", static_cast<char*>(nullptr));
        _exit(errno == ENOENT ? 127 : 126);
    }
    ::close(ends[1]);
    const std::string number = server_ > 0 ? readNumber(ends[0]) : std::string();
    ::close(ends[0]);
    if (!number.empty()) {
        ::setenv("DISPLAY", (":" + number).c_str(), 1);
        if (connect()) return;
    }
    int status = 0;
    if (server_ > 0) {
        ::kill(server_, SIGTERM);
        ::waitpid(server_, &status, 0);
    }
    server_ = -1;
    const bool isMissing = WIFEXITED(status) && WEXITSTATUS(status) == 127;
    throw host::InputError(std::string(kNoDisplay) + (isMissing ? " is not installed (Debian: apt install xvfb)" : " does not start"));
}

Display::~Display() {
    if (connection_ != nullptr) XCloseDisplay(static_cast<::Display*>(connection_));
    if (server_ < 0) return;
    ::kill(server_, SIGTERM);
    ::waitpid(server_, nullptr, 0);
}

}  // namespace gno::viz
