// SPDX-License-Identifier: MIT
// What goes wrong around the program: folders that are none, a full disk, Ctrl-C, no device. The documented exit code, one line, nothing
// half-written.
#include "validation/tests/cli_child.hpp"

namespace gno::test {
namespace {

namespace fs = std::filesystem;

const std::map<std::string, std::string> kNoDriver{
    {"VK_DRIVER_FILES", "/nonexistent/driver.json"}, {"VK_ICD_FILENAMES", "/nonexistent/driver.json"}, {"VK_ADD_DRIVER_FILES", ""}};

/// No temporary of an AtomicFile, and every picture that is there is whole.
void expectNothingHalfWritten(const Stage& stage) {
    for (const auto& entry : fs::recursive_directory_iterator(stage.path())) {
        const std::string name = entry.path().filename().string();
        EXPECT_FALSE(name.ends_with(".part")) << name;
        const bool whole = !name.ends_with(".png") || readFile(entry.path()).ends_with("IEND\xAE\x42\x60\x82");
        EXPECT_TRUE(whole) << name;
    }
}

class Writing : public testing::Test {
protected:
    const Stage stage;
    const std::string scene = stage.write("scene.glb", smallScene().glb());
    const std::string file = stage.write("a_file", "what was here before");
    const std::vector<std::string> quick{scene, "--size", "16x16", "--technique", "psv"};

    [[nodiscard]] std::vector<std::string> with(const std::vector<std::string>& more) const {
        std::vector<std::string> all = quick;
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    [[nodiscard]] std::vector<std::string> shadeInto(const std::string& folder) const {
        std::vector<std::string> all = with({"--out", folder});
        all.insert(all.begin(), "shade");
        return all;
    }
};

TEST_F(Writing, OutUnderAFile) {
    expectRefusal(stage, stage.run(shadeInto(file + "/deeper")), 2, "a_file");
    EXPECT_EQ(readFile(file), "what was here before");
}

TEST_F(Writing, OutIsAFile) {
    expectRefusal(stage, stage.run(shadeInto(file)), 2, "a_file");
    EXPECT_EQ(readFile(file), "what was here before");
}

TEST_F(Writing, RecordUnderAMissingFolder) {
    expectRefusal(stage, stage.shade(with({"--json", (stage.path() / "absent" / "r.jsonl").string()})), 2, "absent");
}
TEST_F(Writing, RecordUnderAFile) { expectRefusal(stage, stage.shade(with({"--json", file + "/r.jsonl"})), 2, "a_file"); }
TEST_F(Writing, RecordIsAFolder) { expectRefusal(stage, stage.shade(with({"--json", stage.path().string()})), 2, "folder"); }

TEST_F(Writing, FullDiskOfTheRecord) {
    if (!fs::exists("/dev/full")) FAIL() << "this system has no /dev/full";
    const Outcome outcome = stage.shade(with({"--no-pictures", "--json", "/dev/full"}));
    expectRefusal(stage, outcome, 2, "/dev/full");
}

TEST_F(Writing, FullDiskOfStandardOutput) {
    ChildOptions options;
    options.standardOutput = "/dev/full";
    for (const char* command : {"device", "techniques"}) expectRefusal(stage, stage.run({command}, options), 2, "standard output");
}

TEST_F(Writing, FullDiskOfTheLayers) {
    fs::create_symlink("/dev/full", stage.out() / "scene-l0-f000.exr");
    const Outcome outcome = stage.shade(quick);
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_EQ(linesOf(outcome.err).size(), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find("cannot write"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.out.find("psv"), std::string::npos) << "the table is told before: " << outcome.out;
    expectNothingHalfWritten(stage);
}

// One dumped buffer goes through a pipe that is smaller than it, so that the program waits there until the disk is full for all that follows.
TEST_F(Writing, DiskThatFillsUp) {
    const std::string stem = "scene-l0-f000-psv.certified-";
    const fs::path pipe = stage.out() / (stem + "samples.bin");
    constexpr size_t kBytes = 128 * 128 * 16;
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    Child child(stage.path(), {"shade", scene, "--size", "128x128", "--technique", "psv", "--dump", "--out", stage.out().string()});
    {
        std::ifstream reader(pipe, std::ios::binary);  // returns when the program writes
        std::string bytes(1, 0);
        reader.read(bytes.data(), 1);
        child.limitFileSize(512);
        std::stringstream rest;
        rest << reader.rdbuf();
        EXPECT_EQ(rest.str().size(), kBytes - 1);
    }
    const Outcome outcome = child.wait();
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_EQ(linesOf(outcome.err).size(), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find(stem + "visibility.bin"), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(stage.out() / (stem + "visibility.bin")));
    EXPECT_FALSE(fs::exists(stage.out() / (stem + "dump.json")));
    EXPECT_TRUE(fs::exists(stage.out() / (stem + "planes.bin")));
    fs::remove(pipe);
    expectNothingHalfWritten(stage);
}

/// Returns once the program has its signal handlers.
void awaitHandlers(const Child& child) {
    for (int i = 0; i < 1000; ++i) {
        std::ifstream status("/proc/" + std::to_string(child.id()) + "/status");
        for (std::string line; std::getline(status, line);)
            if (line.starts_with("SigCgt:") && (std::stoull(line.substr(7), nullptr, 16) & (1u << (SIGINT - 1))) != 0) return;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    throw std::runtime_error("the program catches no SIGINT");
}

void interruptAfter(int milliseconds, int signal) {
    const Stage stage;
    const std::string record = (stage.path() / "record.jsonl").string();
    Child child(stage.path(), {"shade", sceneFile("table_fan"), "--size", "128x128", "--technique", "all", "--light", "all", "--frame", "0..50",
                               "--repeat", "1000", "--check", "--out", stage.out().string(), "--json", record});
    awaitHandlers(child);
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    child.signal(signal);
    const auto start = std::chrono::steady_clock::now();
    expectRefusal(stage, child.wait(), 1, "interrupted");
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    EXPECT_LT(seconds, 60);  // some 50 000 timed runs would take longer
    EXPECT_FALSE(fs::exists(record));
    expectNothingHalfWritten(stage);
}

TEST(Interrupt, AtOnce) { interruptAfter(0, SIGINT); }
TEST(Interrupt, WhileItWorks) { interruptAfter(4000, SIGINT); }
TEST(Interrupt, Terminate) { interruptAfter(1000, SIGTERM); }

TEST(NoDevice, OneLine) {
    const Stage stage;
    const std::string scene = stage.write("scene.glb", smallScene().glb());
    ChildOptions options;
    options.environment = kNoDriver;
    expectRefusal(stage, stage.shade({scene, "--size", "16x16"}, options), 2, "VK_DRIVER_FILES");
    expectRefusal(stage, stage.run({"device"}, options), 2, "VK_DRIVER_FILES");
    expectRefusal(stage, stage.run({"techniques"}, options), 2, "VK_DRIVER_FILES");
    expectDone(stage.run({"effects", scene}, options));  // needs none
    expectDone(stage.run({"shade", "--help"}, options));
}

TEST(NoDevice, NoneOfThatName) {
    const Stage stage;
    const std::string scene = stage.write("scene.glb", smallScene().glb());
    ChildOptions options;
    options.environment = {{"GNOMON_DEVICE", "voodoo"}};
    expectRefusal(stage, stage.shade({scene, "--size", "16x16"}, options), 2, "voodoo");
    expectRefusal(stage, stage.run({"device"}, options), 2, "voodoo");
    options.environment = {{"GNOMON_DEVICE", "77"}};
    expectRefusal(stage, stage.run({"techniques"}, options), 2, "77");
}

}  // namespace
}  // namespace gno::test
