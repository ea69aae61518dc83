// SPDX-License-Identifier: MIT
// `--set KEY=VALUE` and the command line: defaults, and one line for every wrong word.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "host_min/app/options.hpp"
#include "host_min/error.hpp"

namespace gno::host {
namespace {

const std::vector<SettingInfo> kKnown{{"stack", "entries", 1, 64, {}, "12"},
                                      {"seed", "of the order", 0, 4294967295u, {}, "1"},
                                      {"stage", "shader stage", 0, 0, {"compute", "fragment"}, "compute"},
                                      {"bias", "in texels", 0, 64, {}, "1.5", true}};

/// The InputError's text, which must be one line; empty: none was thrown.
template <class Work>
std::string complaint(const Work& work) {
    try {
        work();
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        return error.what();
    }
    return {};
}

std::string complaintOf(const std::vector<std::string>& given) {
    return complaint([&] { Settings(kKnown, given); });
}

Command parse(std::vector<const char*> words) {
    words.insert(words.begin(), "gnomon");
    return parseCommandLine(int(words.size()), words.data());
}

std::string shadeComplaint(const std::vector<const char*>& words) {
    std::vector<const char*> all{"shade", "scene.glb"};
    all.insert(all.end(), words.begin(), words.end());
    return complaint([&] { parse(all); });
}

ShadeOptions shadeOptions(const std::vector<const char*>& words) {
    std::vector<const char*> all{"shade", "scene.glb"};
    all.insert(all.end(), words.begin(), words.end());
    const Command command = parse(all);
    EXPECT_EQ(command.kind, Command::Kind::shade);
    return command.shade;
}

std::string choiceComplaint(const std::vector<const char*>& words) {
    return complaint([&] {
        std::string leftOut;
        chooseTechniques(shadeOptions(words), leftOut);
    });
}

std::vector<std::string> chosenNames(const std::vector<const char*>& words) {
    std::string leftOut;
    std::vector<std::string> names;
    for (const Technique* technique : chooseTechniques(shadeOptions(words), leftOut)) names.push_back(technique->info().name);
    return names;
}

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Settings, Defaults) {
    const Settings settings(kKnown, {});
    EXPECT_EQ(settings.number("stack"), 12u);
    EXPECT_EQ(settings.number("seed"), 1u);
    EXPECT_EQ(settings.word("stage"), "compute");
    EXPECT_EQ(settings.real("bias"), 1.5);
    EXPECT_EQ(settings.json().dump(), R"({"stack":12,"seed":1,"stage":"compute","bias":1.5})");
}

TEST(Settings, GivenValues) {
    const std::vector<std::string> given{"stage=fragment", "seed=4294967295", "stack=64", "elsewhere=7", "bias=0.25"};
    const Settings settings(kKnown, given);
    EXPECT_EQ(settings.json().dump(), R"({"stack":64,"seed":4294967295,"stage":"fragment","bias":0.25})");
    for (const auto& [text, value] : std::map<std::string, double>{{"0", 0}, {"64", 64}, {"64.0", 64}, {".5", 0.5}, {"3.", 3}})
        EXPECT_EQ(Settings(kKnown, std::vector<std::string>{"bias=" + text}).real("bias"), value) << text;
    EXPECT_EQ(complaintOf({"stack=1"}), "");
}

TEST(Settings, WrongValuesTellTheRange) {
    for (const char* wrong : {"stack=0", "stack=65", "stack=many", "stack=", "stack=-1", "stack=+5", "stack=1.5", "stack=12 ", "stack= 12",
                              "stack=0x10", "stack=99999999999999999999", "stack=12=12"}) {
        const std::string text = complaintOf({wrong});
        EXPECT_TRUE(says(text, wrong) && says(text, "1..64")) << wrong << ": " << text;
    }
    for (const char* wrong :
         {"bias=-0.5", "bias=64.1", "bias=", "bias=nan", "bias=inf", "bias=1e1", "bias=0x1", "bias=1,5", "bias=1.5 ", "bias=+1", "bias=."})
        EXPECT_TRUE(says(complaintOf({wrong}), std::string(wrong) + ": must be 0.0..64.0")) << wrong;
    for (const char* wrong : {"seed=4294967296", "seed=-1", "seed="}) EXPECT_TRUE(says(complaintOf({wrong}), "0..4294967295")) << wrong;
    for (const char* wrong : {"stage=vertex", "stage=", "stage=Compute", "stage=compute,fragment"})
        EXPECT_TRUE(says(complaintOf({wrong}), "compute|fragment")) << wrong;
}

TEST(Settings, NoKeyOrNoValueSign) {
    for (const char* wrong : {"stack", "", "=", "=12"}) EXPECT_TRUE(says(complaintOf({wrong}), "KEY=VALUE")) << wrong;
}

TEST(Settings, GivenTwice) {
    EXPECT_TRUE(says(complaintOf({"stack=3", "stack=4"}), "stack is given twice"));
    EXPECT_TRUE(says(complaintOf({"stack=3", "stack=3"}), "stack is given twice"));
}

TEST(Settings, UnknownKeysListTheKnownOnes) {
    const std::vector<std::span<const SettingInfo>> known{kKnown, frameSettings()};
    const auto check = [&](std::vector<std::string> given) { return complaint([&] { checkSettings(known, given); }); };
    EXPECT_EQ(check({"stack=3", "cull=hull", "stage=compute", "seed=4"}), "");
    const std::string text = check({"stack=3", "stakc=12"});
    for (const char* part : {"stakc", "known here", "cull", "seed", "stack", "stage"}) EXPECT_TRUE(says(text, part)) << part << ": " << text;
    EXPECT_TRUE(says(check({"Stack=3"}), "none of the chosen techniques"));
}

TEST(Settings, EveryTechniquesDefaultsAreInRange) {
    for (const auto& technique : techniques()) {
        EXPECT_EQ(complaint([&] { Settings(technique->info().settings, {}); }), "") << technique->info().name;
        for (const SettingInfo& info : technique->info().settings) EXPECT_FALSE(info.meaning.empty()) << info.key;
    }
    EXPECT_EQ(Settings(frameSettings(), {}).word("cull"), "none");
}

TEST(CommandLine, Defaults) {
    const ShadeOptions options = shadeOptions({});
    EXPECT_EQ(options.scene, "scene.glb");
    EXPECT_TRUE(options.techniques.empty());
    EXPECT_FALSE(options.allTechniques);
    EXPECT_EQ(options.precision, Precision::certified);
    EXPECT_EQ(options.width, 1024u);
    EXPECT_EQ(options.height, 1024u);
    EXPECT_EQ(options.camera, 0u);
    EXPECT_EQ(options.light, 0u);
    EXPECT_EQ(options.firstFrame, 0u);
    EXPECT_EQ(options.lastFrame, 0u);
    EXPECT_EQ(options.out, "out");
    EXPECT_TRUE(options.json.empty());
    EXPECT_TRUE(options.settings.empty());
    EXPECT_EQ(options.repeat, 1u);
    EXPECT_FALSE(options.check);
    EXPECT_FALSE(options.dump);
    EXPECT_TRUE(options.pictures);
    EXPECT_FALSE(options.quiet);
    EXPECT_EQ(options.animation, "");
}

TEST(CommandLine, EverythingGiven) {
    const ShadeOptions options =
        shadeOptions({"--technique", "psv,d-hybrid", "--precision",   "published", "--size",  "333x217", "--camera",          "2",       "--light",
                      "all",         "--frame",      "3..7",          "--set",     "stack=3", "--set",   "cull=hull",         "--check", "--repeat",
                      "5",           "--dump",       "--no-pictures", "--out",     "there",   "--json",  "there/record.jsonl"});
    EXPECT_EQ(options.techniques, (std::vector<std::string>{"psv", "d-hybrid"}));
    EXPECT_EQ(options.precision, Precision::published);
    EXPECT_EQ(options.width, 333u);
    EXPECT_EQ(options.height, 217u);
    EXPECT_EQ(options.camera, 2u);
    EXPECT_EQ(options.light, std::nullopt);
    EXPECT_EQ(options.firstFrame, 3u);
    EXPECT_EQ(options.lastFrame, 7u);
    EXPECT_EQ(options.settings, (std::vector<std::string>{"stack=3", "cull=hull"}));
    EXPECT_TRUE(options.check && options.dump && !options.pictures);
    EXPECT_EQ(options.repeat, 5u);
    EXPECT_EQ(options.out, "there");
    EXPECT_EQ(options.json, "there/record.jsonl");
}

TEST(CommandLine, SetTakesOneWordSoThatTheSceneMayFollow) {
    const Command command = parse({"shade", "--set", "stack=3", "scene.glb"});
    EXPECT_EQ(command.shade.scene, "scene.glb");
    EXPECT_EQ(command.shade.settings, std::vector<std::string>{"stack=3"});
}

TEST(CommandLine, Size) {
    EXPECT_EQ(shadeOptions({"--size", "1x1"}).width, 1u);
    EXPECT_EQ(shadeOptions({"--size", "8192x8192"}).height, 8192u);
    for (const char* wrong : {"big", "512", "512x", "x512", "x", "512X512", "512x512x512", "5 x5", "5x 5", "-4x4", "4x-4", "1e3x4", "4.0x4",
                              "512x512 ", "99999999999x4", "4294967296x4"}) {
        const std::string text = shadeComplaint({"--size", wrong});
        EXPECT_TRUE(says(text, "--size") && says(text, "WIDTHxHEIGHT")) << wrong << ": " << text;
    }
    for (const char* wrong : {"0x0", "0x5", "5x0"}) EXPECT_TRUE(says(shadeComplaint({"--size", wrong}), "at least 1")) << wrong;
    for (const char* wrong : {"8193x1", "1x8193", "100000x100000"})
        EXPECT_TRUE(says(shadeComplaint({"--size", wrong}), "over the limit of 8192x8192")) << wrong;
    EXPECT_NE(shadeComplaint({"--size", ""}), "");
}

TEST(CommandLine, Frame) {
    EXPECT_EQ(shadeOptions({"--frame", "0..2"}).lastFrame, 2u);
    EXPECT_EQ(shadeOptions({"--frame", "7..7"}).firstFrame, 7u);
    EXPECT_EQ(shadeOptions({"--frame", "1000000"}).lastFrame, 1000000u);
    for (const char* wrong : {"", "x", "-1", "1..", "..1", "..", "1...3", "1..2..3", "1-3", "1000001", "0..1000001", "99999999999", "1.5"})
        EXPECT_TRUE(says(shadeComplaint({"--frame", wrong}), "--frame")) << wrong;
    EXPECT_TRUE(says(shadeComplaint({"--frame", "3..2"}), "the last frame is before the first"));
}

TEST(CommandLine, LightCameraRepeat) {
    EXPECT_EQ(shadeOptions({"--light", "4"}).light, 4u);
    for (const char* wrong : {"", "ALL", "-1", "0,1", "1.0", "99999999999"})
        EXPECT_TRUE(says(shadeComplaint({"--light", wrong}), "--light")) << wrong;
    for (const char* wrong : {"", "main", "-1", "99999999999"}) EXPECT_TRUE(says(shadeComplaint({"--camera", wrong}), "--camera")) << wrong;
    for (const char* wrong : {"", "0", "-1", "1001", "often"}) EXPECT_TRUE(says(shadeComplaint({"--repeat", wrong}), "--repeat")) << wrong;
}

TEST(CommandLine, Precision) {
    EXPECT_EQ(shadeOptions({"--precision", "conservative"}).precision, Precision::conservative);
    for (const char* wrong : {"exact-ish", "", "Certified", "certified,published"})
        EXPECT_TRUE(says(shadeComplaint({"--precision", wrong}), "published, conservative or certified")) << wrong;
}

TEST(CommandLine, UnknownWords) {
    EXPECT_TRUE(says(shadeComplaint({"--frobnicate"}), "--frobnicate"));
    EXPECT_NE(shadeComplaint({"second.glb"}), "");
    EXPECT_NE(shadeComplaint({"--size"}), "");
    for (const std::vector<const char*>& words : std::vector<std::vector<const char*>>{
             {}, {"shade"}, {"effects"}, {"shadow", "scene.glb"}, {"device", "0"}, {"techniques", "psv"}, {"--size", "4x4"}}) {
        const std::string text = complaint([&] { parse(words); });
        EXPECT_TRUE(says(text, "gnomon --help")) << text;
    }
}

TEST(CommandLine, OtherCommands) {
    const Command effects = parse({"effects", "a.gltf", "--frame", "12", "--animation", "Walk", "--quiet"});
    EXPECT_EQ(effects.animation, "Walk");
    EXPECT_TRUE(effects.quiet);
    const ShadeOptions quiet = shadeOptions({"--quiet", "--animation", "1"});
    EXPECT_EQ(quiet.animation, "1");
    EXPECT_TRUE(quiet.quiet);
    EXPECT_EQ(effects.kind, Command::Kind::effects);
    EXPECT_EQ(effects.scene, "a.gltf");
    EXPECT_EQ(effects.frame, 12u);
    EXPECT_EQ(parse({"device"}).kind, Command::Kind::device);
    EXPECT_EQ(parse({"techniques"}).kind, Command::Kind::techniques);
    EXPECT_TRUE(says(complaint([] { parse({"effects", "a.gltf", "--frame", "x"}); }), "--frame x"));
}

TEST(TechniqueChoice, Lists) {
    EXPECT_EQ(chosenNames({"--technique", "d-hybrid,psv"}), (std::vector<std::string>{"d-hybrid", "psv"}));
    EXPECT_EQ(chosenNames({"--technique", "psv,psv"}), std::vector<std::string>{"psv"});
    EXPECT_TRUE(chosenNames({}).empty());
    EXPECT_TRUE(chosenNames({"--technique", "auto"}).empty());
    const auto with = [](Precision rung) {
        return size_t(std::count_if(techniques().begin(), techniques().end(), [rung](const auto& technique) {
            const auto& rungs = technique->info().precisions;
            return std::find(rungs.begin(), rungs.end(), rung) != rungs.end();
        }));
    };
    EXPECT_LT(with(Precision::published), techniques().size());
    EXPECT_EQ(chosenNames({"--technique", "all", "--precision", "published"}).size(), with(Precision::published));
    EXPECT_EQ(chosenNames({"--technique", "all"}).size(), with(Precision::certified));
    for (const char* none : {"", ",", ",,"}) EXPECT_TRUE(says(choiceComplaint({"--technique", none}), "--technique")) << none;
}

TEST(TechniqueChoice, UnknownAndPlannedOnes) {
    const std::string unknown = choiceComplaint({"--technique", "psvv"});
    EXPECT_TRUE(says(unknown, "no technique is called psvv")) << unknown;
    for (const auto& technique : techniques()) EXPECT_TRUE(says(unknown, technique->info().name)) << unknown;
    for (const auto& [planned, what] : plannedTechniques()) {
        const std::string text = choiceComplaint({"--technique", planned.c_str()});
        EXPECT_TRUE(says(text, "technique " + planned) && says(text, "not in this build yet")) << text;
    }
    EXPECT_TRUE(says(choiceComplaint({"--technique", "psv,psvv"}), "psvv"));
}

TEST(TechniqueChoice, KeysOfTheChosenOnesOnly) {
    EXPECT_EQ(choiceComplaint({"--technique", "psv", "--set", "stack=8", "--set", "cull=front"}), "");
    EXPECT_EQ(choiceComplaint({"--technique", "psv,d-stackless", "--set", "stack=8"}), "");
    const std::string text = choiceComplaint({"--technique", "d-stackless", "--set", "stack=8"});
    EXPECT_TRUE(says(text, "stack") && says(text, "known here") && says(text, "seed") && says(text, "cull")) << text;
    EXPECT_TRUE(says(choiceComplaint({"--technique", "psv", "--set", "map=2048"}), "map"));
    EXPECT_EQ(choiceComplaint({"--technique", "psv,shadow-map", "--precision", "published", "--set", "map=512", "--set", "stack=8"}), "");
    for (const char* technique : {"psv", "all", "auto"}) {
        EXPECT_TRUE(says(choiceComplaint({"--technique", technique, "--set", "stakc=12"}), "stakc")) << technique;
        EXPECT_TRUE(says(choiceComplaint({"--technique", technique, "--set", "stack=many"}), "stack=many")) << technique;
        EXPECT_TRUE(says(choiceComplaint({"--technique", technique, "--set", "cull=back"}), "none|front|hull|all")) << technique;
        EXPECT_TRUE(says(choiceComplaint({"--technique", technique, "--set", "seed=1", "--set", "seed=2"}), "twice")) << technique;
        EXPECT_TRUE(says(choiceComplaint({"--technique", technique, "--set", "seed"}), "KEY=VALUE")) << technique;
    }
}

/// A technique that answers nothing, to see what is said of a rung that it lacks.
class PublishedOnly final : public Technique {
public:
    const TechniqueInfo& info() const override { return info_; }
    std::string structureKey(const FrameInputs&, const Settings&, const RunOptions&) const override { return "nothing"; }
    std::unique_ptr<Structure> makeStructure(const FrameInputs&, const Settings&, const RunOptions&) const override { return nullptr; }
    Query query(const Structure&, const FrameInputs&, const Settings&, const RunOptions&) const override { return {}; }
    void read(const Structure&, const FrameInputs&, const Settings&, const RunOptions&, TechniqueResult&) const override {}

private:
    TechniqueInfo info_{"published-only", "none", {Precision::published}, {}, {}, {}};
};

TEST(TechniqueChoice, ARungThatATechniqueLacks) {
    std::vector<std::unique_ptr<Technique>> list;
    list.push_back(std::make_unique<PublishedOnly>());
    ShadeOptions options;
    std::string leftOut;
    options.allTechniques = true;
    for (const Technique* technique : chooseTechniques(options, leftOut)) {
        EXPECT_NE(technique->info().name, "shadow-map");
        EXPECT_NE(technique->info().name, "ray-query");
    }
    EXPECT_EQ(leftOut, "left out, no precision certified: shadow-map, ray-query");
    options.allTechniques = false;
    leftOut.clear();
    options.techniques = {"published-only"};
    EXPECT_TRUE(says(complaint([&] { chooseTechniques(options, leftOut, list); }), "published-only has no precision certified"));
    options.precision = Precision::published;
    EXPECT_EQ(chooseTechniques(options, leftOut, list).size(), 1u);
    EXPECT_EQ(leftOut, "");

    options.techniques.clear();
    options.allTechniques = true;
    EXPECT_EQ(chooseTechniques(options, leftOut, list).size(), 1u);
    EXPECT_EQ(leftOut, "");
    options.precision = Precision::conservative;
    EXPECT_TRUE(says(complaint([&] { chooseTechniques(options, leftOut, list); }), "no technique has precision conservative"));
}

}  // namespace
}  // namespace gno::host
