// SPDX-License-Identifier: MIT
// The command line: what was asked for, checked as far as it can be without a scene or a device.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host_min/techniques/technique.hpp"

namespace gno::host {

struct ShadeOptions {
    std::filesystem::path scene;
    std::vector<std::string> techniques;  ///< names; empty: auto
    bool allTechniques = false;
    Precision precision = Precision::certified;
    uint32_t width = 1024, height = 1024;
    uint32_t camera = 0;
    std::optional<uint32_t> light = 0;  ///< nullopt: all
    std::string animation;              ///< number, name or all; empty: the first one
    uint32_t firstFrame = 0, lastFrame = 0;
    std::vector<std::string> settings;  ///< KEY=VALUE each
    bool check = false, dump = false, pictures = true;
    bool quiet = false;               ///< no notices
    std::optional<glm::uvec2> trace;  ///< pixel whose query is logged; with dump only
    uint32_t repeat = 1;
    std::filesystem::path out = "out";
    std::filesystem::path json;  ///< empty: no record
};

struct Command {
    enum class Kind { none, shade, effects, techniques, device } kind = Kind::none;  ///< none: help or version was printed
    ShadeOptions shade;
    std::filesystem::path scene;  ///< of effects, and all below
    uint32_t frame = 0, camera = 0;
    std::string animation;
    bool quiet = false;
};

/// Prints help or version itself. Throws InputError, one line.
Command parseCommandLine(int argc, const char* const* argv);

/// Techniques to run: named ones (each must have the rung: InputError), all of the rung (at least one: InputError), or none yet (auto). `leftOut`
/// tells what `all` cannot run.
std::vector<Technique*> chooseTechniques(const ShadeOptions& options, std::string& leftOut,
                                         const std::vector<std::unique_ptr<Technique>>& available = techniques());

}  // namespace gno::host
