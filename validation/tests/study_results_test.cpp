// SPDX-License-Identifier: MIT
// The results file: what a broken one keeps, what a full disk leaves, what merge takes.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>
#include <sstream>

#include "host_min/error.hpp"
#include "validation/study/merge.hpp"
#include "validation/study/results_file.hpp"
#include "validation/tests/scene_builder.hpp"

namespace gno::study {
namespace {

namespace fs = std::filesystem;

Row row(const std::string& job, const Row& more = Row::object()) {
    Row made = {{"schema", 1}, {"kind", "gnomon-study"}, {"job", job}};
    made.update(more);
    return made;
}

std::string text(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::stringstream stream;
    stream << file.rdbuf();
    return stream.str();
}

std::vector<std::string> jobs(const fs::path& path) {
    std::vector<std::string> names;
    for (const Row& one : readResults(path).rows) names.push_back(one["job"]);
    return names;
}

class Results : public testing::Test {
protected:
    const host::test::TemporaryFolder folder;
    const fs::path file = folder.path() / "results.jsonl";
};

TEST_F(Results, AppendedRowsAreThereForTheNextRun) {
    {
        ResultsFile results(file);
        results.append(std::vector{row("a"), row("b")});
        EXPECT_TRUE(results.has("a"));
    }
    ResultsFile again(file);
    EXPECT_TRUE(again.has("a") && again.has("b"));
    EXPECT_FALSE(again.has("c"));
    EXPECT_TRUE(again.notes().empty());
}

TEST_F(Results, ABrokenLastLineIsMovedAsideAndNothingIsGluedToIt) {
    const std::string half = lineOf(row("c")).substr(0, 40);
    folder.write("results.jsonl", lineOf(row("a")) + lineOf(row("b")) + half);
    {
        ResultsFile results(file);
        ASSERT_EQ(results.notes().size(), 1u);
        EXPECT_NE(results.notes()[0].find("line 3: broken off"), std::string::npos) << results.notes()[0];
        EXPECT_FALSE(results.has("c"));
        results.append(std::vector{row("c")});
    }
    EXPECT_EQ(jobs(file), (std::vector<std::string>{"a", "b", "c"}));
    EXPECT_TRUE(readResults(file).problems.empty());
    EXPECT_EQ(text(folder.path() / "results.jsonl.broken"), half + "\n");
}

TEST_F(Results, AWholeRowWithoutItsLineEndIsKept) {
    const std::string whole = lineOf(row("a"));
    folder.write("results.jsonl", whole.substr(0, whole.size() - 1));
    ResultsFile(file).append(std::vector{row("b")});
    EXPECT_EQ(jobs(file), (std::vector<std::string>{"a", "b"}));
}

TEST_F(Results, ABrokenLineInTheMiddleStaysAndIsReported) {
    const std::string before = lineOf(row("a")) + "{\"schema\":1,\n" + lineOf(row("b"));
    folder.write("results.jsonl", before);
    {
        ResultsFile results(file);
        ASSERT_EQ(results.notes().size(), 1u);
        EXPECT_NE(results.notes()[0].find("line 2: not JSON"), std::string::npos);
        EXPECT_TRUE(results.has("a") && results.has("b"));
    }
    EXPECT_EQ(text(file), before);
}

TEST_F(Results, AFileOfAnotherKindIsRefusedAndNotTouched) {
    for (const std::string& other : {std::string("a picture\n\0of something", 23), std::string("one line"), std::string("{\"schema\":1}\n")}) {
        folder.write("results.jsonl", other);
        EXPECT_THROW(ResultsFile results(file), host::InputError);
        EXPECT_EQ(text(file), other);
    }
}

TEST_F(Results, TwoRunsCannotWriteOneFile) {
    ResultsFile first(file);
    EXPECT_THROW(ResultsFile second(file), host::InputError);
}

TEST_F(Results, AFullDiskIsOneErrorAndNoRow) {
    ResultsFile full("/dev/full");
    try {
        full.append(std::vector{row("a")});
        FAIL() << "a full disk took a row";
    } catch (const host::WorkError& error) {
        EXPECT_NE(std::string(error.what()).find("No space left on device"), std::string::npos) << error.what();
    }
    EXPECT_FALSE(full.has("a"));
}

TEST_F(Results, ADiskThatFillsUpInsideARowLeavesNothingOfIt) {
    folder.write("results.jsonl", lineOf(row("a")));
    const std::string before = text(file);
    ResultsFile results(file);
    rlimit limit{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &limit), 0);
    const rlimit tight{before.size() + 30, limit.rlim_max};
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &tight), 0);
    EXPECT_THROW(results.append(std::vector{row("b"), row("c")}), host::WorkError);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(text(file), before);
    results.append(std::vector{row("b")});
    EXPECT_EQ(jobs(file), (std::vector<std::string>{"a", "b"}));
}

class Merging : public Results {
protected:
    fs::path put(const std::string& where, const std::string& content) {
        fs::create_directories((folder.path() / where).parent_path());
        return folder.write(where, content);
    }
};

TEST_F(Merging, EachJobOnceAndPicturesAlong) {
    const Row pictures = {{"pictures", {{"wrong", "pictures/x-wrong.png"}}}};
    const std::vector files{put("one/a.jsonl", lineOf(row("a", pictures)) + lineOf(row("b", {{"casters", 1}}))),
                            put("two/b.jsonl", lineOf(row("b", {{"casters", 2}})) + lineOf(row("c")))};
    put("one/pictures/x-wrong.png", "the picture");
    const fs::path into = folder.path() / "all" / "all.jsonl";
    fs::create_directory(into.parent_path());
    for (int time = 0; time < 2; ++time) {  // once more changes nothing
        const Merged merged = mergeResults(files, into);
        EXPECT_EQ(merged.rows, 3u);
        EXPECT_EQ(merged.twice, time == 0 ? 1u : 4u);
        EXPECT_EQ(merged.pictures, 1u);
        EXPECT_TRUE(merged.notes.empty());
        EXPECT_EQ(jobs(into), (std::vector<std::string>{"a", "b", "c"}));
        EXPECT_EQ(readResults(into).rows[1]["casters"], 1);
        EXPECT_EQ(text(into.parent_path() / "pictures" / "x-wrong.png"), "the picture");
    }
}

TEST_F(Merging, AMeasuredRowTakesThePlaceOfAnUnavailableOne) {
    const std::vector files{put("a.jsonl", lineOf(row("a", {{"unavailable", "no memory left"}}))),
                            put("b.jsonl", lineOf(row("a", {{"casters", 7}}))),
                            put("c.jsonl", lineOf(row("a", {{"unavailable", "no memory left"}})))};
    mergeResults(files, file);
    ASSERT_EQ(readResults(file).rows.size(), 1u);
    EXPECT_EQ(readResults(file).rows[0].value("casters", 0), 7);
}

TEST_F(Merging, BrokenLinesAndMissingPicturesAreReported) {
    const std::string half = lineOf(row("b")).substr(0, 30);
    const std::vector files{put("a.jsonl", lineOf(row("a", {{"pictures", {{"wrong", "pictures/gone.png"}, {"truth", "../a.jsonl"}}}})) + half)};
    const Merged merged = mergeResults(files, file);
    EXPECT_EQ(merged.notes.size(), 3u);
    EXPECT_EQ(merged.pictures, 0u);
    EXPECT_EQ(jobs(file), (std::vector<std::string>{"a"}));
    EXPECT_TRUE(readResults(file).rows[0]["pictures"].empty());
    EXPECT_EQ(text(folder.path() / "a.jsonl").substr(lineOf(readResults(files[0]).rows[0]).size()), half) << "the file that is read stays as it is";
}

TEST_F(Merging, AFileThatIsNotThereLeavesTheTargetAlone) {
    put("results.jsonl", lineOf(row("a")));
    EXPECT_THROW(mergeResults(std::vector{folder.path() / "none.jsonl"}, file), host::InputError);
    EXPECT_EQ(jobs(file), (std::vector<std::string>{"a"}));
}

}  // namespace
}  // namespace gno::study
