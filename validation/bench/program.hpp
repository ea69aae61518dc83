// SPDX-License-Identifier: MIT
// What the programs of this folder share around their tables.
#pragma once
#include <string>

#include "host_min/vulkan/device.hpp"

namespace CLI {
class App;
}

namespace gno::bench {

/// Parses; prints the help and returns false when it was asked for. Throws InputError.
bool parse(CLI::App& app, int argc, char** argv);

void readSize(const std::string& text, uint32_t& width, uint32_t& height);  ///< "WIDTHxHEIGHT"; throws InputError
std::string describe(const host::Device& device);                           ///< name, driver and subgroup width

}  // namespace gno::bench
