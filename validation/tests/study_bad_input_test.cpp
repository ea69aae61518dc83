// SPDX-License-Identifier: MIT
// Bad command lines of gnomon-study: exit code 2, one line that names what is wrong, no results file.
#include <gtest/gtest.h>

#include "validation/tests/study_child.hpp"

namespace gno::test {
namespace {

namespace fs = std::filesystem;

struct Bad {
    const char* arguments;
    const char* says;
};

class BadLine : public Study, public testing::WithParamInterface<Bad> {};

TEST_P(BadLine, IsOneLineAndExitCode2) {
    const Outcome outcome = sweep(GetParam().arguments);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(linesOf(outcome.err).size(), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find(GetParam().says), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(results));
}

INSTANTIATE_TEST_SUITE_P(Sweep, BadLine,
                         testing::Values(Bad{"nowhere.glb", "no such file"}, Bad{"room:11", "12 to 60000"}, Bad{"", "which scenes"},
                                         Bad{"room:12 --technique nothing", "there are psv"}, Bad{"room:12 --precision half", "there are published"},
                                         Bad{"room:12 --vary nothing=1", "known here"}, Bad{"room:12 --vary stack=9999", "1..64"},
                                         Bad{"room:12 --best nothing", "known here"}, Bad{"room:12 --set nothing=1", "known here"},
                                         Bad{"room:12 --size 12", "WIDTHxHEIGHT"}, Bad{"room:12 --size 0x9", "0"},
                                         Bad{"room:12 --camera 7", "--camera 7"}, Bad{"room:12 --light 70", "--light 70"},
                                         Bad{"room:12 --frame 3..1", "--frame 3..1"}, Bad{"room:12 --cull some", "none|front|hull|all"},
                                         Bad{"--vary-scene nothing=12", "--vary-scene"}, Bad{"--vary-scene room=1", "12 to 60000"},
                                         Bad{"room:12 --repeat 0", "repeat"}, Bad{"room:12 --unknown", "--unknown"}));

TEST_F(Study, AResultsFileThatIsSomethingElseStaysAsItIs) {
    const std::string other = "a letter\nof two lines\n";
    std::ofstream(results) << other;
    const Outcome outcome = sweep("room:12 --size 16x9");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(linesOf(outcome.err).size(), 1u) << outcome.err;
    EXPECT_EQ(readFile(results), other);
}

TEST_F(Study, CommandsThatLackSomething) {
    for (const char* line :
         {"", "sweep", "sweep room:12", "plan", "plan sweep room:12", "merge", "merge nowhere.jsonl --into all.jsonl", "nothing"}) {
        const Outcome outcome = stage.run(words(line));
        EXPECT_EQ(outcome.code, 2) << line;
        EXPECT_EQ(linesOf(outcome.err).size(), 1u) << line << ": " << outcome.err;
    }
    EXPECT_FALSE(fs::exists(stage.path() / "all.jsonl"));
}

}  // namespace
}  // namespace gno::test
