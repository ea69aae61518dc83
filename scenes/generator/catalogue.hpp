// SPDX-License-Identifier: MIT
// All scenes by name, and how to make one of a wanted size.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scenes/generator/draft.hpp"

namespace gno::scenes {

struct Kind {
    const char* name;
    const char* standsFor;  ///< scene of the papers, or what it shows
    bool closed;            ///< every mesh is a closed, outward-facing manifold: front-face culling is legal
    size_t defaultSize;     ///< triangles; exact for shows, within 3 % otherwise
    size_t low, high;       ///< range of --size; 0 for shows, which have one size
    /// Procedural: `detail` is about proportional to the number of triangles.
    Draft (*build)(double detail, uint64_t seed);
    Draft (*show)(const std::filesystem::path& models, uint64_t seed);
};

const std::vector<Kind>& catalogue();

/// Throws InputError: no such scene.
const Kind& findKind(const std::string& name);

/// `size` is the wanted number of triangles (default: the kind's), met as closely as the scene allows. `models` is the folder of the shipped
/// models, read by shows only. Throws InputError: size out of range, or given for a show.
Draft makeScene(const Kind& kind, std::optional<size_t> size, uint64_t seed, const std::filesystem::path& models);

Draft showGarden(const std::filesystem::path& models, uint64_t seed);
Draft showStairs(const std::filesystem::path& models, uint64_t seed);
Draft showTruck(const std::filesystem::path& models, uint64_t seed);
Draft buildPlayground(double detail, uint64_t seed);
Draft buildCity(double detail, uint64_t seed);
Draft buildRopes(double detail, uint64_t seed);
Draft buildBricks(double detail, uint64_t seed);
Draft buildGate(double detail, uint64_t seed);
Draft buildFuzzy(double detail, uint64_t seed);
Draft buildRoom(double detail, uint64_t seed);
Draft buildGrass(double detail, uint64_t seed);
Draft buildLeaves(double detail, uint64_t seed);

}  // namespace gno::scenes
