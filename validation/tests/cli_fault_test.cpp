// SPDX-License-Identifier: MIT
// Faults of the machine, made by a Vulkan layer of the tests (validation/support/fault_layer.cpp): no memory, a lost device, a device that says
// less. The documented exit code, one line, nothing half-written, and what was done before stays.
#include <nlohmann/json.hpp>

#include "validation/tests/cli_child.hpp"

namespace gno::test {
namespace {

namespace fs = std::filesystem;

class Faults : public testing::Test {
protected:
    const Stage stage;
    const std::string scene = stage.write("scene.glb", smallScene().glb());
    const std::string record = (stage.path() / "record.jsonl").string();

    [[nodiscard]] std::vector<std::string> words(const std::string& techniques) const {
        return {"shade", scene, "--size", "16x16", "--technique", techniques, "--json", record, "--out", stage.out().string()};
    }
    [[nodiscard]] static ChildOptions with(const std::string& fault) {
        ChildOptions options;
        options.environment = {{"VK_INSTANCE_LAYERS", "VK_LAYER_GNOMON_faults"}, {"VK_LAYER_PATH", GNOMON_FAULT_LAYER}, {"GNOMON_FAULT", fault}};
        return options;
    }
    [[nodiscard]] Outcome run(const std::string& techniques, const std::string& fault) const {
        fs::remove(record);
        fs::remove_all(stage.out());
        fs::create_directory(stage.out());
        return stage.run(words(techniques), with(fault));
    }
    /// Calls of a run without faults.
    [[nodiscard]] std::map<std::string, uint32_t> countsOf(const std::string& techniques) const {
        ChildOptions options = with("");
        const std::string file = (stage.path() / "counts").string();
        options.environment["GNOMON_FAULT_COUNTS"] = file;
        const Outcome outcome = stage.run(words(techniques), options);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        std::map<std::string, uint32_t> counts;
        std::ifstream stream(file);
        uint32_t count = 0;
        for (std::string name; stream >> name >> count;) counts[name] = count;
        return counts;
    }
    /// Techniques of the record's lines, in their order.
    [[nodiscard]] std::vector<std::string> recorded() const {
        std::vector<std::string> names;
        for (const std::string& line : linesOf(readFile(record))) names.push_back(nlohmann::json::parse(line)["technique"]);
        return names;
    }
    void expectNothingHalfWritten() const {
        for (const auto& entry : fs::recursive_directory_iterator(stage.path())) {
            const std::string name = entry.path().filename().string();
            EXPECT_FALSE(name.ends_with(".part")) << name;
            EXPECT_TRUE(!name.ends_with(".png") || readFile(entry.path()).ends_with("IEND\xAE\x42\x60\x82")) << name;
        }
    }
    /// This exit code, one line with `part`; rows, pictures and records of `techniques` and of no others.
    void expectStopped(const Outcome& outcome, int code, const std::string& part, const std::vector<std::string>& techniques) const {
        EXPECT_EQ(outcome.code, code) << outcome.err;
        EXPECT_EQ(linesOf(outcome.err).size(), 1u) << outcome.err;
        EXPECT_TRUE(outcome.err.starts_with("gnomon: ")) << outcome.err;
        EXPECT_NE(outcome.err.find(part), std::string::npos) << "not said: " << part << "\nsaid: " << outcome.err;
        EXPECT_EQ(recorded(), techniques);
        for (const std::string& name : techniques) {
            EXPECT_NE(outcome.out.find("\n" + name + " "), std::string::npos) << outcome.out;
            EXPECT_TRUE(fs::exists(stage.out() / ("scene-l0-f000-" + name + ".certified-mask.png")));
        }
        EXPECT_EQ(stage.left().empty(), techniques.empty());
        expectNothingHalfWritten();
    }
};

TEST_F(Faults, NoMemoryAndALostDevice) {
    const auto counts = countsOf("psv,d-stackless");
    ASSERT_GT(counts.at("vkAllocateMemory"), 20u);
    const auto fault = [&](const std::string& call, uint32_t number, const char* result) {
        return run("psv,d-stackless", call + ":" + std::to_string(number) + ":" + result);
    };
    const uint32_t last = counts.at("vkAllocateMemory"), lastCompile = counts.at("vkCreateComputePipelines");
    const std::string technique = "technique d-stackless: ";
    expectStopped(fault("vkAllocateMemory", 1, "-2"), 2, "no memory left", {});
    expectStopped(fault("vkAllocateMemory", last, "-2"), 2, technique + "the device has no memory left", {"psv"});
    expectStopped(fault("vkCreateComputePipelines", lastCompile, "-1"), 2, technique + "the driver has no memory left", {"psv"});
    expectStopped(fault("vkQueueSubmit2", 1, "-4"), 1, "the device is lost", {});
    expectStopped(fault("vkQueueSubmit2", counts.at("vkQueueSubmit2"), "-4"), 1, technique + "the device is lost", {"psv"});
    expectStopped(fault("vkWaitForFences", counts.at("vkWaitForFences"), "-4"), 1, technique + "the device is lost", {"psv"});
}

// The first technique refuses, the second one answers.
TEST_F(Faults, TheOthersGoOn) {
    const auto counts = countsOf("psv");
    const std::string last = "vkAllocateMemory:" + std::to_string(counts.at("vkAllocateMemory")) + ":-2";
    expectStopped(run("psv,d-hybrid", last), 2, "technique psv: the device has no memory left", {"d-hybrid"});
}

TEST_F(Faults, ADeviceWithoutTimeStamps) {
    const Outcome outcome = run("psv", "timestampValidBits");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("no time stamps"), std::string::npos) << outcome.out;
    const auto json = nlohmann::json::parse(readFile(record));
    EXPECT_TRUE(json["total_ms"].is_null() && json["floor_ms"].is_null());
    ASSERT_FALSE(json["passes"].empty());
    for (const auto& pass : json["passes"]) EXPECT_TRUE(pass["ms"].is_null());
    EXPECT_EQ(outcome.out.find("nan"), std::string::npos) << outcome.out;
}

// A limit of the device that one of several passes: of the scene it is no fault, of a technique that was named it is.
TEST_F(Faults, AKnownLimit) {
    const auto published = [&](const std::string& techniques) {
        std::vector<std::string> all = words(techniques);
        all.insert(all.end(), {"--precision", "published", "--no-pictures"});
        fs::remove(record);
        return stage.run(all, with("maxImageDimension2D:1024"));
    };
    const Outcome named = published("shadow-map,psv");
    EXPECT_EQ(named.code, 2);
    EXPECT_EQ(linesOf(named.err).size(), 1u) << named.err;
    EXPECT_NE(named.err.find("technique shadow-map: --set map=2048: over the device's maxImageDimension2D (1024)"), std::string::npos) << named.err;
    EXPECT_EQ(recorded(), std::vector<std::string>{"psv"});
    const Outcome all = published("all");
    expectDone(all);
    EXPECT_NE(all.out.find("left out shadow-map: --set map=2048: over the device's maxImageDimension2D (1024)"), std::string::npos) << all.out;
    EXPECT_GE(recorded().size(), 6u);
    EXPECT_EQ(published("shadow-map").code, 2);
    EXPECT_FALSE(fs::exists(record));
}

// Settings that do not hold the scene: known in mid-run, and a fault, also among all.
TEST_F(Faults, APoolThatIsTooSmall) {
    const std::vector<std::string> pool{"--set", "pool=2", "--no-pictures"};
    std::vector<std::string> all = words("forest,psv");
    all.insert(all.end(), pool.begin(), pool.end());
    const Outcome outcome = stage.run(all);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(linesOf(outcome.err).size(), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find("technique forest: --set pool=2"), std::string::npos) << outcome.err;
    EXPECT_EQ(recorded(), std::vector<std::string>{"psv"});
}

// A driver may compile for minutes.
TEST_F(Faults, ASignalWhileAPipelineCompiles) {
    ChildOptions options = with("vkCreateComputePipelines:1:sleep");
    const std::string counts = (stage.path() / "counts").string();
    options.environment["GNOMON_FAULT_COUNTS"] = counts;
    Child child(stage.path(), words("psv"), options);
    for (int i = 0; i < 1000 && !fs::exists(counts); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ASSERT_TRUE(fs::exists(counts)) << "no pipeline is compiled";
    const auto start = std::chrono::steady_clock::now();
    child.signal(SIGTERM);
    expectRefusal(stage, child.wait(), 1, "interrupted");
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
    EXPECT_FALSE(fs::exists(record));
}

}  // namespace
}  // namespace gno::test
