// SPDX-License-Identifier: MIT
#include "validation/study/report/command.hpp"

#include <memory>

#include "validation/study/report/report.hpp"

namespace gno::study {

void addReport(CLI::App& program, Action& chosen) {
    const auto options = std::make_shared<report::ReportOptions>();
    CLI::App* command = program.add_subcommand("report", "one HTML page and PNG charts from a results file");
    command->add_option("RESULTS", options->results, "file that sweep wrote")->required();
    command->add_option("--out", options->out, "folder for index.html and the charts")->capture_default_str();
    command->callback([options, &chosen] {
        chosen = [options] {
            report::report(*options);
            return 0;
        };
    });
}

void finishStudy(const std::filesystem::path& results, const std::filesystem::path& out) { report::report({results, out}); }

}  // namespace gno::study
