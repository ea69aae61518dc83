// SPDX-License-Identifier: MIT
#include "validation/bench/program.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "host_min/error.hpp"

namespace gno::bench {

bool parse(CLI::App& app, int argc, char** argv) {
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        std::fputs(app.help().c_str(), stdout);
        return false;
    } catch (const CLI::ParseError& error) {
        throw host::InputError(error.what());
    }
    return true;
}

void readSize(const std::string& text, uint32_t& width, uint32_t& height) {
    if (std::sscanf(text.c_str(), "%ux%u", &width, &height) != 2) throw host::InputError("--size: write WIDTHxHEIGHT");
}

std::string describe(const host::Device& device) {
    const host::DeviceFacts& f = device.facts();
    return fmt::format("{}, {} {}, subgroup width {}", f.deviceName, f.driverName, f.driverInfo, f.subgroupSize);
}

}  // namespace gno::bench
