// SPDX-License-Identifier: MIT
// gnomon-bench-rivals SCENE... : techniques with settings, and Embree, side by side as Markdown tables. Visits do not depend on the machine; times
// are to be read as ratios within one run: the columns build, query and both are medians over the rounds of the ratio to the first contestant in the
// same round.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "host_min/app/result.hpp"
#include "host_min/output/guarded.hpp"
#include "validation/bench/program.hpp"
#include "validation/bench/rivals.hpp"

namespace {

int run(int argc, char** argv) {
    using namespace gno;
    CLI::App app("gnomon-bench-rivals: techniques with settings, and Embree, side by side as Markdown tables");
    bench::RivalJob job;
    std::string cull = "none", precision = "certified";
    std::vector<std::string> contestants{"d-hybrid", "psv", "forest", "light-bvh", "light-grid", "ray-query", "embree:fp32"}, sizes{"1920x1080"};
    app.add_option("SCENE", job.scenes, ".gltf or .glb files")->required()->check(CLI::ExistingFile);
    app.add_option("--of", contestants,
                   "NAME or NAME:KEY=VALUE:..., separated by commas; embree:fp32, embree:robust; the first is what ratios are to")
        ->delimiter(',')
        ->capture_default_str();
    app.add_option("--size", sizes, "WIDTHxHEIGHT, separated by commas")->delimiter(',')->capture_default_str();
    app.add_option("--seeds", job.base.seeds, "insertion orders to average over, where the order is random")
        ->capture_default_str()
        ->check(CLI::Range(1, 100));
    app.add_option("--repeats", job.base.repeats, "rounds per insertion order")->capture_default_str()->check(CLI::Range(1, 100));
    app.add_option("--frame", job.base.frame, "frame of the scene's animation")->capture_default_str();
    app.add_option("--light", job.base.light, "index of the light")->capture_default_str();
    app.add_option("--cull", cull, "none, front, hull or all")->capture_default_str()->check(CLI::IsMember({"none", "front", "hull", "all"}));
    app.add_option("--precision", precision, "of the techniques that have it")->capture_default_str();
    app.add_flag("--check", job.base.check, "compare with the exact oracle; wrong samples make the program fail");
    if (!bench::parse(app, argc, argv)) return 0;
    for (const std::string& text : contestants) job.contestants.push_back(bench::contestant(text));
    for (const std::string& text : sizes) {
        auto& [width, height] = job.sizes.emplace_back();
        bench::readSize(text, width, height);
    }
    job.base.precisions = {host::precisionByName(precision)};
    job.base.cull = host::cullByName(cull);

    const host::Device device(host::DeviceOptions::fromEnvironment());
    host::requireTimestamps(device.facts());
    for (const auto& [width, height] : job.sizes) host::checkSize(device.facts(), width, height);
    host::PassCache passes(device);
    fmt::print("{}; frame {}, light {}, cull {}, precision {}, seeds 1..{} (mean ± standard deviation), {} rounds each; ratios are to `{}`\n",
               bench::describe(device), job.base.frame, job.base.light, cull, precision, job.base.seeds, job.base.repeats,
               job.contestants.front().label);
    const uint64_t wrong = bench::printRivals(passes, job);
    if (job.base.check) fmt::print("\n{} samples wrong in all\n", wrong);
    return wrong == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    return gno::host::guarded("gnomon-bench-rivals", "use a smaller --size or scene", [&] { return run(argc, argv); });
}
