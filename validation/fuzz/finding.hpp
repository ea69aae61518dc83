// SPDX-License-Identifier: MIT
// What both fuzzers (libFuzzer and fuzz/main.cpp) ask of one string of bytes.
#pragma once
#include <cstdint>
#include <span>
#include <string>

#include "validation/support/top_on_cpu_check.hpp"

namespace gno::fuzz {

struct Input {
    cpu::TinyScene scene;
    uint floatMode = 0;
    uint seed = 0;  ///< of the insertion order
};

/// Any bytes make a scene of at most 24 casters and 32 samples: coordinates from coarse and fine lattices, vertices shared, pushed away from the
/// light or laid on planes, samples on rays through vertices and edges. Missing bytes read as zero.
Input sceneFromBytes(std::span<const uint8_t> bytes);

struct Finding {
    std::string what;        ///< empty: nothing wrong. Else one line, then the scene in hexadecimal floats
    uint64_t signature = 0;  ///< equal for inputs that did about the same (dark samples, visited nodes, overflows)
};

/// Builds the tree by two insertion orders, with long and with short stacks, and asks all four queries: the certified answers have to be those of
/// the definition. On the other rungs no query may leave its arrays or go on forever. `variant` empty: all variants that the program is linked with.
Finding examine(std::span<const uint8_t> bytes, const std::string& variant = {});

}  // namespace gno::fuzz
