// SPDX-License-Identifier: MIT
// What stops a sweep: a kill, Ctrl-C, a full disk. The rows that are there stay, and the same command goes on.
#include <gtest/gtest.h>

#include "validation/tests/study_child.hpp"

namespace gno::test {
namespace {

namespace fs = std::filesystem;
using study::Row;

const char* const kSweep = "room:12 --size 24x14 --technique psv,d-stackless --frame 0..7 --repeat 2";
constexpr size_t kRows = 6 * 8;

class Stopping : public Study {
protected:
    [[nodiscard]] std::vector<std::string> line() const { return words(std::string("sweep ") + kSweep + " --results " + results.string()); }
    /// Until the first rows are there.
    void waitForRows() const {
        for (int i = 0; i < 6000; ++i) {
            if (fs::exists(results) && fs::file_size(results) > 0) return;
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        FAIL() << "no row in 30 s";
    }
    /// Each job of the sweep once.
    void expectComplete() const {
        std::set<std::string> jobs;
        for (const Row& row : rows()) EXPECT_TRUE(jobs.insert(row["job"]).second) << "twice: " << row["job"];
        EXPECT_EQ(jobs.size(), kRows);
    }
};

TEST_F(Stopping, AKilledSweepGoesOn) {
    {
        Child child(stage.path(), line(), kOneThread);
        waitForRows();
        child.signal(SIGKILL);
        EXPECT_EQ(child.wait().code, 128 + SIGKILL);
    }
    const std::string before = readFile(results);
    const size_t there = rows().size();
    ASSERT_GT(there, 0u);
    ASSERT_LT(there, kRows) << "it was through before it was killed";
    const Outcome again = sweep(kSweep);
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_NE(again.out.find(std::to_string(there) + " of " + std::to_string(kRows) + " rows are there already"), std::string::npos) << again.out;
    EXPECT_TRUE(readFile(results).starts_with(before));
    expectComplete();
    const Outcome third = sweep(kSweep);
    EXPECT_EQ(third.code, 0);
    EXPECT_NE(third.out.find("0 rows of 0 groups added"), std::string::npos) << third.out;
}

TEST_F(Stopping, AKillInsideALineGoesOn) {
    ASSERT_EQ(sweep("room:12 --size 24x14 --technique psv,d-stackless --frame 0..1 --repeat 2").code, 0);
    const std::string whole = readFile(results);
    std::ofstream(results, std::ios::binary) << whole.substr(0, whole.size() - 300);
    const Outcome again = sweep(kSweep);
    EXPECT_EQ(again.code, 0);
    EXPECT_EQ(linesOf(again.err).size(), 1u) << again.err;
    EXPECT_NE(again.err.find("line 12: broken off in the middle, as an interrupt leaves it; moved to"), std::string::npos) << again.err;
    EXPECT_TRUE(study::readResults(results).problems.empty());
    expectComplete();
}

TEST_F(Stopping, CtrlCLeavesWholeRows) {
    Child child(stage.path(), line(), kOneThread);
    waitForRows();
    child.signal(SIGINT);
    const Outcome outcome = child.wait();
    EXPECT_EQ(outcome.code, 1);
    EXPECT_EQ(linesOf(outcome.err).size(), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find("interrupted"), std::string::npos);
    EXPECT_TRUE(study::readResults(results).problems.empty());
    EXPECT_EQ(rows().size() % 6, 0u) << "a group's rows come together";
    EXPECT_EQ(sweep(kSweep).code, 0);
    expectComplete();
}

TEST_F(Stopping, AFullDiskIsOneLine) {
    const std::string scene = stage.write("scene.glb", smallScene().glb());
    const Outcome outcome =
        stage.run(words("sweep " + scene + " --size 16x9 --technique psv --precision certified --repeat 1 --results /dev/full"), kOneThread);
    EXPECT_EQ(outcome.code, 1);
    EXPECT_EQ(linesOf(outcome.err).size(), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find("cannot write '/dev/full': No space left on device"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace gno::test
