// SPDX-License-Identifier: MIT
#include "validation/study/sweep.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>

#include "host_min/error.hpp"
#include "host_min/interrupt.hpp"
#include "host_min/output/atomic_file.hpp"
#include "host_min/output/table.hpp"
#include "validation/study/expand.hpp"
#include "validation/study/measure_group.hpp"
#include "validation/study/results_file.hpp"

namespace gno::study {
namespace {

using Clock = std::chrono::steady_clock;

/// Tells two runs apart, of one machine or of many.
std::string runName() { return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}-{}", fmt::gmtime(std::time(nullptr)), ::getpid()); }

std::string timeLeft(double seconds) {
    if (seconds < 90) return fmt::format("{:.0f} s left", seconds);
    if (seconds < 90 * 60) return fmt::format("{:.0f} min left", seconds / 60);
    return fmt::format("{:.1f} h left", seconds / 3600);
}

/// The bar: work is counted in runs times pixels.
class Bar {
public:
    explicit Bar(double work) : work_(work) {}
    void beginGroup(const std::string& name, const GroupJobs& jobs) {
        group_ = name;
        perRun_ = double(jobs.group.width) * jobs.group.height;
        inGroup_ = 0;
        ofGroup_ = perRun_ * double(runsOf(jobs));
    }
    void endGroup() { done_ += ofGroup_; }
    void show(const std::string& what) {
        const double done = done_ + std::min(inGroup_, ofGroup_), elapsed = std::chrono::duration<double>(Clock::now() - begin_).count();
        bar_.show(fmt::format("{} {}{}", group_, what, done > 0 ? ", " + timeLeft(elapsed * (work_ - done) / done) : ""), done / work_);
    }
    void count(uint32_t runs) { inGroup_ += perRun_ * runs; }
    void clear() { bar_.clear(); }

private:
    host::Progress bar_;
    Clock::time_point begin_ = Clock::now();
    std::string group_;
    double work_, done_ = 0, perRun_ = 0, inGroup_ = 0, ofGroup_ = 0;
};

}  // namespace

std::filesystem::path sceneFolder(const std::filesystem::path& results) { return results.parent_path() / "scenes"; }

void runSweep(const std::vector<GroupJobs>& groups, SceneShelf& shelf, const std::filesystem::path& path) {
    if (path.has_parent_path()) host::makeFolder(path.parent_path());
    ResultsFile results(path);
    for (const std::string& note : results.notes()) fmt::print(stderr, "gnomon-study: {}\n", note);
    std::vector<GroupJobs> left;
    size_t all = 0, wanted = 0;
    double work = 0;
    for (const GroupJobs& jobs : groups) {
        GroupJobs rest = jobs;
        std::erase_if(rest.variants, [&](const Variant& variant) { return results.has(jobKey(jobs.group, variant)); });
        all += jobs.variants.size();
        wanted += rest.variants.size();
        work += double(runsOf(rest)) * rest.group.width * rest.group.height;
        if (!rest.variants.empty()) left.push_back(std::move(rest));
    }
    if (wanted < all) fmt::print("{}: {} of {} rows are there already\n", path.string(), all - wanted, all);
    std::fflush(stdout);
    const host::Device device(host::DeviceOptions::fromEnvironment());
    host::requireTimestamps(device.facts());
    host::PassCache passes(device);
    const std::string run = runName();
    Worst worst(results.rows());
    size_t measured = 0, unavailable = 0;
    Bar bar(work);
    for (const GroupJobs& jobs : left) {
        host::throwIfInterrupted();
        bar.beginGroup(
            fmt::format("{} f{} l{} {}x{}:", sceneName(jobs.group.scene), jobs.group.frame, jobs.group.light, jobs.group.width, jobs.group.height),
            jobs);
        const std::vector<Row> rows =
            measureGroup(passes, shelf.load(jobs.group.scene), jobs, run, worst, results.folder(), [&](const std::string& what, uint32_t runs) {
                host::throwIfInterrupted();
                bar.show(what);
                bar.count(runs);
            });
        host::throwIfInterrupted();
        results.append(rows);
        bar.endGroup();
        measured += rows.size();
        unavailable += size_t(std::count_if(rows.begin(), rows.end(), [](const Row& row) { return row.contains("unavailable"); }));
    }
    bar.clear();
    fmt::print("{}: {} rows of {} groups added{}\n", path.string(), measured, left.size(),
               unavailable ? fmt::format(", {} of them unavailable", unavailable) : "");
    if (device.validationMessages() != 0) throw host::WorkError("the validation layer had something to say (see above)");
}

void addSweep(CLI::App& program, Action& chosen) {
    CLI::App* command =
        program.add_subcommand("sweep", "measure and check every variant on every group of scene, frame, light and size; append to a results file");
    const auto options = std::make_shared<SweepOptions>();
    const auto results = std::make_shared<std::string>();
    const auto list = std::make_shared<bool>(false);
    addSweepOptions(*command, *options);
    CLI::Option* file = command->add_option("--results", *results, "JSON Lines; rows that are there are not measured again");
    command->add_flag("--list", *list, "print the keys of the jobs instead of doing them");
    command->callback([=, &chosen] {
        chosen = [=] {
            if (file->count() == 0 && !*list) throw host::InputError("--results FILE: where do the rows go?");
            SceneShelf shelf(sceneFolder(*results));
            const std::vector<GroupJobs> groups = expand(*options, shelf);
            if (*list) {
                for (const GroupJobs& jobs : groups)
                    for (const Variant& variant : jobs.variants) fmt::print("{}\n", jobKey(jobs.group, variant));
                return 0;
            }
            runSweep(groups, shelf, *results);
            return 0;
        };
    });
}

}  // namespace gno::study
