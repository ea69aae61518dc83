// SPDX-License-Identifier: MIT
// What a scene calls for. An effect that it does not call for costs nothing: no pass, no buffer, no instruction.
#pragma once
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "host_min/scene/scene.hpp"
#include "host_min/techniques/technique.hpp"

namespace gno::host {

struct Effect {
    std::string name;        ///< of the record: point_light, open_casters, …
    std::string because;     ///< what in the scene calls for it
    std::string switchesOn;  ///< what is built for it
};

/// Effects of one frame; `light` < 0: of all its lights.
std::vector<Effect> effectsOf(const SceneFile& file, const Frame& frame, int light);

/// What `auto` runs, and why.
struct Choice {
    Technique* technique;  ///< null: no technique holds the scene, and `why` says so
    std::string why;
};

/// What a run knows besides the scene. The default: the least device that will do.
struct ChoiceFacts {
    DeviceFacts device{};
    uint32_t width = 1024, height = 1024;
    std::vector<std::string> settings{};   ///< KEY=VALUE each
    std::set<const Technique*> refused{};  ///< by these already, in this run
};

/// The best for the scene; where the device does not hold it, the next that does, and `why` tells both.
Choice chooseAutomatically(const Frame& frame, Precision precision, const ChoiceFacts& facts = {});

/// One line "note: ..." each, but none whose subject is in `told`, which gets it.
void printNotices(const std::vector<std::string>& notices, std::set<std::string, std::less<>>& told);

/// `gnomon effects`; `quiet`: without notices.
void printEffects(const SceneFile& file, const Frame& frame, bool quiet);

}  // namespace gno::host
