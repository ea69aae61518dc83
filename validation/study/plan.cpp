// SPDX-License-Identifier: MIT
#include "validation/study/plan.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "validation/study/expand.hpp"
#include "validation/study/presets.hpp"
#include "validation/study/sweep.hpp"

namespace gno::study {
namespace {

int printPlan(const std::vector<SweepOptions>& sweeps, const std::filesystem::path& folder, const std::string& self) {
    SceneShelf shelf(folder / "scenes");
    for (const SweepOptions& sweep : sweeps) {
        for (const GroupJobs& jobs : expand(sweep, shelf)) {
            const std::string words = commandWords(narrowed(sweep, jobs.group));
            const std::string file = fmt::format("{}-{}.jsonl", sceneName(jobs.group.scene), stableHash(words));
            fmt::print("{} sweep {} --results {}\n", quoted(self), words, quoted((folder / file).string()));
        }
    }
    return 0;
}

}  // namespace

void addPlan(CLI::App& program, Action& chosen, const std::string& self) {
    CLI::App* plan = program.add_subcommand("plan", "print a sweep as independent jobs, one command line each");
    plan->require_subcommand(1);
    const auto folder = std::make_shared<std::string>();
    const auto add = [&](const char* name, const char* what) {
        CLI::App* command = plan->add_subcommand(name, what);
        command->add_option("--into", *folder, "folder of the jobs' results files")->required();
        return command;
    };
    const auto options = std::make_shared<SweepOptions>();
    CLI::App* sweep = add("sweep", "a sweep of your own; its options");
    addSweepOptions(*sweep, *options);
    sweep->callback([=, &chosen] { chosen = [=] { return printPlan({*options}, *folder, self); }; });
    const auto tiny = std::make_shared<bool>(false);
    CLI::App* shortStudy = add("short", "the jobs of `gnomon-study short`");
    shortStudy->add_flag("--tiny", *tiny, "those of `short --tiny`");
    const auto preset = [=, &chosen](const std::function<Preset()>& which) {
        return [=, &chosen] {
            chosen = [=] {
                std::vector<std::string> leftOut;
                const std::vector<SweepOptions> sweeps = presetSweeps(which(), leftOut);
                for (const std::string& line : leftOut) fmt::print(stderr, "gnomon-study: {}\n", line);
                return printPlan(sweeps, *folder, self);
            };
        };
    };
    shortStudy->callback(preset([tiny] { return *tiny ? Preset::tiny : Preset::shortStudy; }));
    add("full", "the jobs of `gnomon-study full`")->callback(preset([] { return Preset::full; }));
}

}  // namespace gno::study
