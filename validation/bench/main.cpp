// SPDX-License-Identifier: MIT
// gnomon-bench queries|ladder|stacks|growth|routing|own SCENE... : the measurements of the READMEs as Markdown tables. Counters do not depend on the
// machine; times are to be read as ratios within one run.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "host_min/app/result.hpp"
#include "host_min/output/guarded.hpp"
#include "validation/bench/program.hpp"
#include "validation/bench/tables.hpp"

namespace {

int run(int argc, char** argv) {
    using namespace gno;
    CLI::App app("gnomon-bench: measurements as Markdown tables");
    bench::Job base;
    std::string table, size = "1920x1080", cull = "none", precision = "certified", stage = "compute";
    std::vector<std::string> scenes;
    app.add_option("TABLE", table, "queries, ladder, stacks, growth, routing or own")
        ->required()
        ->check(CLI::IsMember({"queries", "ladder", "stacks", "growth", "routing", "own"}));
    app.add_option("SCENE", scenes, ".glb files")->required()->check(CLI::ExistingFile);
    app.add_option("--size", size, "WIDTHxHEIGHT")->capture_default_str();
    app.add_option("--seeds", base.seeds, "insertion orders to average over")->capture_default_str()->check(CLI::Range(1, 100));
    app.add_option("--repeats", base.repeats, "times each time is taken, per insertion order")->capture_default_str()->check(CLI::Range(1, 100));
    app.add_option("--frame", base.frame, "frame of the scene's animation")->capture_default_str();
    app.add_option("--light", base.light, "index of the light; ladder, routing and own take 0 and 1")->capture_default_str();
    app.add_option("--cull", cull, "none, front, hull or all")->capture_default_str()->check(CLI::IsMember({"none", "front", "hull", "all"}));
    app.add_option("--precision", precision, "published, conservative or certified")->capture_default_str();
    if (!bench::parse(app, argc, argv)) return 0;
    bench::readSize(size, base.width, base.height);
    base.precisions = {host::precisionByName(precision)};
    base.cull = host::cullByName(cull);

    const bool bothLights = table == "ladder" || table == "routing" || table == "own";
    const host::Device device(host::DeviceOptions::fromEnvironment());
    host::requireTimestamps(device.facts());
    host::checkSize(device.facts(), base.width, base.height);
    host::PassCache passes(device);
    fmt::print("{}; {}x{}, frame {}, {}, cull {}, precision {}, seeds 1..{} (mean ± standard deviation)\n\n", bench::describe(device), base.width,
               base.height, base.frame, bothLights ? "lights 0 and 1" : fmt::format("light {}", base.light), cull,
               table == "ladder"                      ? "all"
               : table == "routing" || table == "own" ? "certified"
                                                      : precision,
               base.seeds);
    if (table == "queries")
        bench::printQueries(passes, base, scenes);
    else if (table == "ladder")
        bench::printLadder(passes, base, scenes);
    else if (table == "stacks")
        bench::printStacks(passes, base, scenes);
    else if (table == "routing")
        bench::printRouting(passes, base, scenes);
    else if (table == "own")
        bench::printOwn(passes, base, scenes);
    else
        bench::printGrowth(passes, base, scenes);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    return gno::host::guarded("gnomon-bench", "use a smaller --size or scene", [&] { return run(argc, argv); });
}
