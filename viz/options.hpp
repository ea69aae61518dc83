// SPDX-License-Identifier: MIT
// The command line of gnomon-viz, checked as far as it can be without a dump or a display.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "viz/picture.hpp"

namespace gno::viz {

struct Options {
    std::vector<std::filesystem::path> dumps;  ///< at least one index
    std::filesystem::path out = "out";
    std::string color;  ///< one of the command's
    View view = View::overview;
    uint32_t limit = 0;            ///< most primitives that are drawn
    std::optional<uint32_t> cell;  ///< forest: whose tree is drawn; none: the one with most casters
    PictureSize size;
    bool interactive = false;
    double closeAfter = 0;  ///< seconds; 0: the user closes the window
};

struct Command {
    enum class Kind { none, tree, clusters, samples, forest } kind = Kind::none;  ///< none: help or version was printed
    Options options;
};

/// Prints help or version itself. Throws InputError, one line.
Command parseCommandLine(int argc, const char* const* argv);

}  // namespace gno::viz
