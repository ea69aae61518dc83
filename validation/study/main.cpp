// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <cstdio>

#include "host_min/error.hpp"
#include "host_min/interrupt.hpp"
#include "validation/study/report/report.hpp"

int main(int argc, char** argv) {
    gno::host::catchInterrupts();
    gno::report::ReportOptions options;
    CLI::App app("gnomon-study");
    CLI::App* report = app.add_subcommand("report", "");
    report->add_option("RESULTS", options.results)->required();
    report->add_option("--out", options.out);
    app.require_subcommand(1);
    CLI11_PARSE(app, argc, argv);
    try {
        gno::report::report(options);
    } catch (const gno::host::InputError& error) {
        std::fprintf(stderr, "gnomon-study: %s\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "gnomon-study: %s\n", error.what());
        return 1;
    }
    return 0;
}
