// SPDX-License-Identifier: MIT
// Holds a TOP tree on the CPU against the definition (support/exact_reference.hpp), in every rounding mode that a device may have.
#pragma once
#include <string>
#include <vector>

#include "validation/support/top_on_cpu.hpp"

namespace gno::cpu {

/// A scene small enough to be asked a million times. All positions lie on the grid; a sample with an own caster lies strictly on the light's side of
/// it, as gnoMakeViewSample promises.
struct TinyScene {
    vec4 light{0, 0, 0, 1};
    std::vector<GnoCaster> casters;
    std::vector<GnoViewSample> samples;
};

/// The definition: per sample 1 for in shadow, 0 for lit.
std::vector<uint8_t> exactAnswers(const TinyScene& scene);

/// Does p lie strictly on the light's side of the caster's plane? False for an edge-on caster.
bool strictlyInFront(const GnoCaster& caster, vec4 light, vec3 p);

/// How fp32 works while this lives: mode % 4 is the rounding (nearest, up, down, to zero), from 4 on denormals are flushed where the processor can.
inline constexpr uint kFloatModes = 5;
class FloatMode {
public:
    explicit FloatMode(uint mode);
    ~FloatMode();
    FloatMode(const FloatMode&) = delete;
    FloatMode& operator=(const FloatMode&) = delete;

private:
    int rounding_ = 0;
    unsigned control_ = 0;
};

/// Empty when all four queries agree with `expected` for every sample; else one line that says which does not. Never throws: a tree that leaves its
/// arrays or does not end is a finding, too.
std::string firstWrong(TopTree& tree, const TinyScene& scene, const std::vector<uint8_t>& expected, uint precision, std::span<const uint> order,
                       uint floatMode);

/// Light, casters and sample `only` (all when it is negative) in hexadecimal floats, a line each.
std::string show(const TinyScene& scene, int only = -1);

}  // namespace gno::cpu
