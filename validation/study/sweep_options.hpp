// SPDX-License-Identifier: MIT
// What a sweep is told on the command line; the same words make up the presets and the lines of a plan.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CLI {
class App;
}

namespace gno::study {

struct SweepOptions {
    std::vector<std::string> scenes;  ///< files, or NAME[:TRIANGLES] of generated ones
    std::vector<std::string> techniques{"all"}, precisions{"all"};
    std::vector<std::string> sizes{"640x360"}, culls{"none"};
    std::vector<std::string> set;     ///< KEY=VALUE
    std::vector<std::string> vary;    ///< KEY=V1,V2[:KEY=V1,V2]: all combinations of one entry
    std::vector<std::string> best;    ///< keys
    std::vector<std::string> series;  ///< NAME=TRIANGLES,TRIANGLES,...
    std::string light = "0", frame = "0";
    uint32_t camera = 0, repeat = 3;
};

/// Adds all of it to a command.
void addSweepOptions(CLI::App& command, SweepOptions& options);

/// From one line of words, as in the presets. Throws InputError.
SweepOptions parseSweepLine(const std::string& line);

/// The words of the command line that give these options again, fit for a shell.
std::string commandWords(const SweepOptions& options);

/// Frames of A, A..B or A..B..STEP. Throws InputError.
std::vector<uint32_t> framesOf(const std::string& text);
/// Width and height of WIDTHxHEIGHT. Throws InputError.
std::pair<uint32_t, uint32_t> sizeOf(const std::string& text);
/// nullopt: all. Throws InputError.
std::optional<uint32_t> lightOf(const std::string& text);

/// A word for the shell: in single quotes where the shell would read more than a word into it.
std::string quoted(const std::string& word);

/// 16 hexadecimal digits, the same on every machine (FNV-1a, 64 bits).
std::string stableHash(const std::string& text);

/// Parts between `separator`, empty ones left out.
std::vector<std::string> splitAt(const std::string& text, char separator);

}  // namespace gno::study
