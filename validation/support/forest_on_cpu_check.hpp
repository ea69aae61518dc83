// SPDX-License-Identifier: MIT
// Holds the forest on the CPU against exact arithmetic: cells against the claims of glsl/forest/cells.glsl, whole forests against the definition.
// Integers of 128 bits where the light is a point, GMP's rationals where it is not.
#pragma once
#include "validation/support/forest_on_cpu.hpp"
#include "validation/support/top_on_cpu_check.hpp"

namespace gno::cpu {

/// A caster, points where its cells are in question, and cells to ask about beside those of the points. All positions lie on the grid.
struct CellQuestion {
    vec4 light{0, 0, 0, 1};
    GnoForestGrid grid{};
    GnoCaster t{};
    std::vector<vec3> points;
    std::vector<uint> cells{};
};

/// How often a check had something to look at: one that never has proves nothing.
struct CellTally {
    uint64_t points = 0;    ///< whose cell was held against its bounds
    uint64_t shadowed = 0;  ///< points in the caster's shadow, exactly
    uint64_t alone = 0;     ///< of these: the rectangle of their face is one cell
    uint64_t missed = 0;    ///< cells that no point of the volume may lie in
    uint64_t covered = 0;   ///< cells that are all behind the caster
    CellTally& operator+=(const CellTally& other);
};

/// Empty when all claims hold, in this float mode (FloatMode); else one line. The claims:
/// - a point's cell has it, exactly, within 2 GNO_BAND (directional: times the scene's radius) of its bounds;
/// - a point that is exactly in the caster's shadow lies in a cell of the rectangle that is not missed, and no nearer than `least`;
/// - a point in the caster's cone that is not behind it lies no farther than `most`;
/// - of a covered cell, every direction within that slack passes through the inside of the caster, exactly.
std::string wrongCells(const Forest& forest, const CellQuestion& question, uint floatMode, CellTally& tally);

/// Empty when the forest, built for the scene's samples, is whole and all four queries agree with `expected`; else one line. Never throws. Whole:
/// each pair that was counted is in the pool once, as a caster that counts in a cell.
std::string wrongForest(Forest& forest, const TinyScene& scene, const GnoForestGrid& grid, const std::vector<uint8_t>& expected,
                        const ForestChoice& choice, uint floatMode);

std::string show(const CellQuestion& question);

}  // namespace gno::cpu
