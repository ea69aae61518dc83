// SPDX-License-Identifier: MIT
// The progress line is for terminals only, and leaves nothing behind.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "host_min/output/table.hpp"

using namespace gno::host;

namespace {

/// Standard error goes to `fd` while this lives.
class ErrorTo {
public:
    explicit ErrorTo(int fd) : before_(::dup(STDERR_FILENO)) { ::dup2(fd, STDERR_FILENO); }
    ~ErrorTo() {
        std::fflush(stderr);
        ::dup2(before_, STDERR_FILENO);
        ::close(before_);
    }

private:
    int before_;
};

std::string readAll(int fd) {
    ::fcntl(fd, F_SETFL, O_NONBLOCK);
    std::string text;
    char bytes[4096];
    for (ssize_t count = 0; (count = ::read(fd, bytes, sizeof(bytes))) > 0;) text.append(bytes, static_cast<std::size_t>(count));
    return text;
}

void work() {
    Progress progress;
    for (int i = 0; i <= 1000; ++i) progress.show("asking the oracle", i / 1000.0);
    progress.show("loading");
}

}  // namespace

TEST(OutputProgress, APipeSeesNothing) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    {
        const ErrorTo there(ends[1]);
        work();
        EXPECT_FALSE(wantsColor(STDERR_FILENO));
    }
    EXPECT_EQ(readAll(ends[0]), "");
    ::close(ends[0]);
    ::close(ends[1]);
}

TEST(OutputProgress, ATerminalSeesFewLinesAndAWipedOneAtTheEnd) {
    ::setenv("TERM", "xterm", 1);
    ::unsetenv("NO_COLOR");
    const int controller = ::posix_openpt(O_RDWR | O_NOCTTY);
    ASSERT_GE(controller, 0);
    ASSERT_EQ(::grantpt(controller), 0);
    ASSERT_EQ(::unlockpt(controller), 0);
    const int terminal = ::open(::ptsname(controller), O_RDWR | O_NOCTTY);
    ASSERT_GE(terminal, 0);
    {
        const ErrorTo there(terminal);
        work();
        EXPECT_TRUE(wantsColor(STDERR_FILENO));
        ::setenv("NO_COLOR", "1", 1);
        EXPECT_FALSE(wantsColor(STDERR_FILENO));
    }
    const std::string text = readAll(controller);
    EXPECT_NE(text.find("asking the oracle"), std::string::npos);
    EXPECT_NE(text.find("loading ..."), std::string::npos);
    EXPECT_EQ(text.find('\n'), std::string::npos);
    EXPECT_TRUE(text.ends_with("\r\033[K"));
    EXPECT_LT(text.size(), 1000u);  // 1000 calls within a moment
    ::close(terminal);
    ::close(controller);
}
