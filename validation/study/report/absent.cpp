// SPDX-License-Identifier: MIT
// In a build without VTK.
#include <fmt/format.h>

#include "host_min/error.hpp"
#include "validation/study/report/command.hpp"

namespace gno::study {

void addReport(CLI::App& program, Action& chosen) {
    CLI::App* command = program.add_subcommand("report", "not in this build: it was configured with GNOMON_VIZ=OFF");
    command->allow_extras();
    command->callback(
        [&chosen] { chosen = []() -> int { throw host::InputError("report: this build draws no charts; configure with GNOMON_VIZ=ON"); }; });
}

void finishStudy(const std::filesystem::path& results, const std::filesystem::path&) {
    fmt::print("measured: {}; this build draws no charts, one with GNOMON_VIZ=ON does: gnomon-study report {}\n", results.string(),
               results.string());
}

}  // namespace gno::study
