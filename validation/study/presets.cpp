// SPDX-License-Identifier: MIT
#include "validation/study/presets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <set>
#include <span>

#include "host_min/techniques/technique.hpp"
#include "validation/study/expand.hpp"
#include "validation/study/sweep.hpp"

namespace gno::study {
namespace {

// clang-format off
/// One sweep a line, in the words of `gnomon-study sweep`. No two lines share a group: ratios of times hold inside a group.
constexpr const char* kShort[] = {
    // error against time, map sizes with their best bias, stack sizes
    "scenes/spiral_staircase/spiral_staircase.glb scenes/fence/fence.glb room:6000 --size 320x180"
    " --vary map=512,1024,2048,4096 --best bias --vary stack=4,8 --repeat 3",
    // a directional light; casters that are not opaque
    "scenes/spiral_staircase/spiral_staircase.glb --light 1 --size 320x180 --vary map=1024 --best bias --repeat 3",
    "leaves:8000 --size 320x180 --repeat 3",
    // resolution
    "scenes/spiral_staircase/spiral_staircase.glb --size 160x90,640x360 --vary map=1024 --best bias --repeat 2",
    // a path
    "room:6000 --frame 0..56..8 --size 160x90 --repeat 2",
    // number of casters
    "--vary-scene fuzzy=4000,8000,16000,32000 --size 160x90 --repeat 2",
};
constexpr const char* kTiny[] = {
    "room:12 --size 96x54 --vary map=512 --best bias --vary stack=4 --repeat 2",
    "--vary-scene fuzzy=4000,8000 --size 48x27 --repeat 2",
    "room:12 --size 48x27 --frame 0..20..20 --repeat 2",
};
constexpr const char* kFull[] = {
    // error against time, every kind of light, map sizes with their best bias
    "scenes/show_stairs.glb scenes/spiral_staircase/spiral_staircase.glb scenes/table_fan/table_fan.glb scenes/crib/crib.glb scenes/show_truck.glb"
    " room:6000 scenes/plant_decorative/plant_decorative.glb scenes/show_garden.glb --size 480x270 --light all"
    " --vary map=512,1024,2048,4096 --best bias --vary stack=4,8 --repeat 3",
    // a path
    "scenes/show_garden.glb room:6000 --frame 4..56..4 --size 320x180 --repeat 3",
    // number of casters
    "--vary-scene fuzzy=4000,16000,64000,256000 --vary-scene playground=40000,160000 --size 320x180 --frame 15 --repeat 3",
    // resolution
    "scenes/show_stairs.glb scenes/show_garden.glb --size 320x180,960x540,1280x720,1920x1080 --vary map=2048 --repeat 3",
    // parameters of the structures
    "scenes/show_garden.glb gate:100000 --frame 30 --size 480x270 --vary stack=1,2,16,32 --vary bounds=implicit,explicit"
    " --vary split=off,1,3,4,5,6 --vary planes=own --vary fit=uniform,focused:map=1024,2048,8192 --repeat 3",
    // the other scenes
    "scenes/cooktop/cooktop.glb scenes/fence/fence.glb scenes/flower_box/flower_box.glb scenes/table_football/table_football.glb"
    " scenes/truck_peterbilt/truck_peterbilt.glb gate:100000 leaves:8000 playground city ropes bricks fuzzy grass"
    " --size 480x270 --light all --vary map=1024,4096 --best bias --repeat 3",
    // culling
    "playground:131000 gate:100000 --frame 44 --size 480x270 --cull none,front,hull,all --repeat 3",
    // many casters
    "--vary-scene fuzzy=1000000 --vary-scene bricks=20000,80000,320000,1280000 --vary-scene playground=640000 --size 480x270 --frame 15 --repeat 3",
};
// clang-format on

bool isKnown(const std::string& key) {
    for (const auto& technique : host::techniques())
        for (const host::SettingInfo& info : technique->info().settings)
            if (info.key == key) return true;
    return false;
}

void addPreset(CLI::App* command, Action& chosen, const std::function<Preset()>& preset, const Finish& finish) {
    const auto results = std::make_shared<std::string>("out/study/results.jsonl");
    command->add_option("--results", *results, "JSON Lines; rows that are there are not measured again")->capture_default_str();
    command->footer("The page of `gnomon-study report` is written beside the results, into report/.");
    command->callback([=, &chosen] {
        chosen = [=] {
            std::vector<std::string> leftOut;
            const std::vector<SweepOptions> sweeps = presetSweeps(preset(), leftOut);
            for (const std::string& line : leftOut) fmt::print("{}\n", line);
            const std::filesystem::path path = *results;
            SceneShelf shelf(sceneFolder(path));
            std::vector<GroupJobs> groups;
            for (const SweepOptions& sweep : sweeps)
                for (GroupJobs& jobs : expand(sweep, shelf)) groups.push_back(std::move(jobs));
            runSweep(groups, shelf, path);
            finish(path, path.parent_path() / "report");
            return 0;
        };
    });
}

}  // namespace

std::vector<SweepOptions> presetSweeps(Preset preset, std::vector<std::string>& leftOut) {
    const std::span<const char* const> lines = preset == Preset::full   ? std::span<const char* const>(kFull)
                                               : preset == Preset::tiny ? std::span<const char* const>(kTiny)
                                                                        : std::span<const char* const>(kShort);
    std::vector<SweepOptions> sweeps;
    std::set<std::string> missing;
    for (const char* line : lines) {
        SweepOptions sweep = parseSweepLine(line);
        std::erase_if(sweep.vary, [&](const std::string& entry) {
            for (const std::string& part : splitAt(entry, ':')) {
                const std::string key = part.substr(0, part.find('='));
                if (isKnown(key)) continue;
                missing.insert(key);
                return true;
            }
            return false;
        });
        std::erase_if(sweep.best, [&](const std::string& key) { return !isKnown(key) && (missing.insert(key), true); });
        sweeps.push_back(std::move(sweep));
    }
    for (const std::string& key : missing) leftOut.push_back(fmt::format("left out {}: no technique of this build knows it", key));
    return sweeps;
}

void addShort(CLI::App& program, Action& chosen, const Finish& finish) {
    CLI::App* command = program.add_subcommand("short", "a study of some minutes: small scenes, every technique and precision");
    const auto tiny = std::make_shared<bool>(false);
    command->add_flag("--tiny", *tiny, "smaller still: to see that it works");
    addPreset(
        command, chosen, [tiny] { return *tiny ? Preset::tiny : Preset::shortStudy; }, finish);
}

void addFull(CLI::App& program, Action& chosen, const Finish& finish) {
    addPreset(
        program.add_subcommand("full", "the full study: all scenes; hours"), chosen, [] { return Preset::full; }, finish);
}

}  // namespace gno::study
