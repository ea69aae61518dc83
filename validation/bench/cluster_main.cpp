// SPDX-License-Identifier: MIT
// gnomon-bench-clusters paths|jobs|sizes|against|product SCENE... : the measurements of the cluster hierarchy as Markdown tables. Operations do not
// depend on the machine (a few differ from run to run: who clears a bit first spares others the test); times are to be read as ratios within one
// run.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "host_min/app/result.hpp"
#include "host_min/output/guarded.hpp"
#include "validation/bench/cluster_tables.hpp"
#include "validation/bench/program.hpp"

namespace {

int run(int argc, char** argv) {
    using namespace gno;
    CLI::App app("gnomon-bench-clusters: measurements of the cluster hierarchy as Markdown tables");
    bench::ClusterJob job;
    std::string table, size = "1024x1024", cull = "front", precision = "certified";
    app.add_option("TABLE", table, "paths, jobs, sizes, against or product")
        ->required()
        ->check(CLI::IsMember({"paths", "jobs", "sizes", "against", "product"}));
    app.add_option("SCENE", job.scenes, ".glb files")->required()->check(CLI::ExistingFile);
    app.add_option("--size", size, "WIDTHxHEIGHT")->capture_default_str();
    app.add_option("--light", job.light, "index of the light")->capture_default_str();
    app.add_option("--last-frame", job.lastFrame, "of the path")->capture_default_str();
    app.add_option("--step", job.frameStep, "frames between two that are measured")->capture_default_str()->check(CLI::Range(1, 1000));
    app.add_option("--cull", cull, "none, front, hull or all")->capture_default_str()->check(CLI::IsMember({"none", "front", "hull", "all"}));
    app.add_option("--precision", precision, "published, conservative or certified")->capture_default_str();
    app.add_option("--csv", job.csv, "file for the numbers of every frame (paths)");
    app.add_flag("--defaults", job.defaults, "default settings only (product)");
    app.add_option("--keep", job.keep, "folder to write the view samples to (product)")->check(CLI::ExistingDirectory);
    app.add_option("--given", job.given,
                   "folder to take the view samples from instead of rasterising (product): a driver that cannot rasterise at a subgroup width still "
                   "computes")
        ->check(CLI::ExistingDirectory);
    if (!bench::parse(app, argc, argv)) return 0;
    bench::readSize(size, job.width, job.height);
    job.precision = host::precisionByName(precision);
    job.cull = host::cullByName(cull);

    const host::Device device(host::DeviceOptions::fromEnvironment());
    host::requireTimestamps(device.facts());
    host::checkSize(device.facts(), job.width, job.height);
    host::PassCache passes(device);
    fmt::print("{}; {}, light {}, cull {}, precision {}\n\n", bench::describe(device), table == "sizes" ? "three sizes" : size, job.light, cull,
               precision);
    if (table == "product") return bench::printProduct(passes, job) == 0 ? 0 : 1;
    if (table == "paths")
        bench::printPaths(passes, job);
    else if (table == "jobs")
        bench::printJobs(passes, job);
    else if (table == "sizes")
        bench::printSizes(passes, job);
    else
        bench::printAgainst(passes, job);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    return gno::host::guarded("gnomon-bench-clusters", "use a smaller --size or scene", [&] { return run(argc, argv); });
}
