// SPDX-License-Identifier: MIT
// A hard case: a made-up scene that is named after what makes it hard. One .cpp per family adds to the list; hard_cases_test and gnomon-hard-cases
// run it.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "validation/support/device_test.hpp"

namespace gno::hard {

inline constexpr uint32_t kAnyFirst = 0xFFFFFFFFu;

struct HardCase {
    std::string name;                                ///< what makes it hard; unique
    std::string why;                                 ///< one line: what goes wrong there in fp32, or in the algorithm as published
    std::function<test::Scene(uint32_t seed)> make;  ///< the same seed makes the same scene, everything on the grid

    uint32_t scenes = 1;                  ///< seeds 1 .. scenes are run, and counted together
    uint32_t first = kAnyFirst;           ///< a triangle whose early insertion makes it hard: every second insertion seed is one that puts it first
    bool expectsPublishedErrors = false;  ///< `published` must be seen to fail: this is what shows that the suite can catch errors
    double conservativeLimit = 0;         ///< largest share of samples that `conservative` may get wrong (ties: the sign itself is fp32 noise)
    std::vector<std::string> settings{};  ///< KEY=VALUE, for the techniques that have them
    std::vector<std::string> choices{};   ///< the same, one after the other, at the first insertion seed of a scene; later seeds take turns
};

/// All families, in the order of the table in validation/measured/hard_cases.md.
const std::vector<HardCase>& hardCases();

// One per file.
std::vector<HardCase> lights();
std::vector<HardCase> rooms();
std::vector<HardCase> slivers();
std::vector<HardCase> ties();
std::vector<HardCase> interpenetration();
std::vector<HardCase> bigAndSmall();
std::vector<HardCase> scale();
std::vector<HardCase> emptiness();
std::vector<HardCase> clusters();
std::vector<HardCase> cells();

}  // namespace gno::hard
