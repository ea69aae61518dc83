// SPDX-License-Identifier: MIT
// gnomon-bench-clusters paths|jobs|sizes|against|product SCENE... : the measurements of the cluster hierarchy as Markdown tables. Operations do not
// depend on the machine (a few differ from run to run: who clears a bit first spares others the test); times are to be read as ratios within one run.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "host_min/error.hpp"
#include "validation/bench/cluster_tables.hpp"

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
    app.add_option("--keep", job.keep, "folder to write the view samples to (product)")->check(CLI::ExistingDirectory);
    app.add_option(
           "--given", job.given,
           "folder to take the view samples from instead of rasterising (product): a driver that cannot rasterise at a subgroup width still computes")
        ->check(CLI::ExistingDirectory);
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        std::fputs(app.help().c_str(), stdout);
        return 0;
    } catch (const CLI::ParseError& error) {
        throw host::InputError(error.what());
    }
    if (std::sscanf(size.c_str(), "%ux%u", &job.width, &job.height) != 2) throw host::InputError("--size: write WIDTHxHEIGHT");
    job.precision = host::precisionByName(precision);
    job.cull = cull == "front" ? host::Cull::front : cull == "hull" ? host::Cull::hull : cull == "all" ? host::Cull::all : host::Cull::none;

    const host::Device device(host::DeviceOptions::fromEnvironment());
    host::checkSize(device.facts(), job.width, job.height);
    host::PassCache passes(device);
    fmt::print("{}, {} {}, subgroup width {}; {}, light {}, cull {}, precision {}\n\n", device.facts().deviceName, device.facts().driverName,
               device.facts().driverInfo, device.facts().subgroupSize, table == "sizes" ? "three sizes" : size, job.light, cull, precision);
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
    try {
        return run(argc, argv);
    } catch (const gno::host::InputError& error) {
        std::fprintf(stderr, "gnomon-bench-clusters: %s\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "gnomon-bench-clusters: %s\n", error.what());
        return 1;
    }
}
