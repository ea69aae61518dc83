// SPDX-License-Identifier: MIT
#include "scenes/generator/catalogue.hpp"

#include <cmath>

#include "host_min/error.hpp"

namespace gno::scenes {

const std::vector<Kind>& catalogue() {
    static const std::vector<Kind> kinds = {
        {"show_garden", "the default picture: fine foliage, bars and petals", false, 160619, 0, 0, nullptr, showGarden},
        {"show_stairs", "long thin balusters, many small objects", false, 114898, 0, 0, nullptr, showStairs},
        {"show_truck", "a long object under a low sun, few large receivers", false, 154622, 0, 0, nullptr, showTruck},
        {"playground", "PLAYGROUND (2016): shadows of all complexities", true, 131000, 40000, 2000000, buildPlayground, nullptr},
        {"city", "CLOSED CITY (2016): large and open, thousands of objects", true, 620000, 30000, 4000000, buildCity, nullptr},
        {"ropes", "SHIP (2016): rigging of long thin triangles", false, 300000, 40000, 1500000, buildRopes, nullptr},
        {"bricks", "EXCAVATOR (2016): a million small casters", true, 1150000, 20000, 3000000, buildBricks, nullptr},
        {"room", "a closed room lit from inside; --size 12 is its bare shell", true, 6000, 12, 60000, buildRoom, nullptr},
        {"gate", "VILLA (2014): bars near the camera, trees far behind", true, 100000, 20000, 1000000, buildGate, nullptr},
        {"fuzzy", "FUZZY (2014): very dense casters", false, 400000, 4000, 2000000, buildFuzzy, nullptr},
        {"grass", "blades through a ground that is the first caster", false, 200000, 2000, 2000000, buildGrass, nullptr},
        {"leaves", "alpha-masked leaf cards, lattices, coloured and veiled panes", false, 8000, 600, 400000, buildLeaves, nullptr},
    };
    return kinds;
}

const Kind& findKind(const std::string& name) {
    std::string known;
    for (const Kind& kind : catalogue()) {
        if (name == kind.name) return kind;
        known += std::string(" ") + kind.name;
    }
    throw host::InputError("no scene is called " + name + ": use all or one of" + known);
}

namespace {

/// Searches the detail that gives `size` triangles; builds about five times.
Draft fit(const Kind& kind, size_t size, uint64_t seed) {
    const auto wanted = static_cast<double>(size);
    double low = 0;
    double high = 0;
    double detail = wanted / static_cast<double>(kind.defaultSize);
    Draft best;
    double bestError = HUGE_VAL;
    for (int step = 0; step < 24; ++step) {
        Draft draft = kind.build(detail, seed);
        const auto got = static_cast<double>(draft.triangleCount());
        if (std::abs(got - wanted) < bestError) {
            bestError = std::abs(got - wanted);
            best = std::move(draft);
        }
        if (bestError <= 0.01 * wanted) break;
        (got < wanted ? low : high) = detail;
        const double guess = detail * wanted / got;
        if (low == 0 || high == 0)
            detail = guess;
        else
            detail = step < 5 && guess > low && guess < high ? guess : (low + high) / 2;
    }
    return best;
}

}  // namespace

Draft makeScene(const Kind& kind, std::optional<size_t> size, uint64_t seed, const std::filesystem::path& models) {
    if (kind.show != nullptr) {
        if (size) throw host::InputError(std::string(kind.name) + " has one size: leave out --size");
        return kind.show(models, seed);
    }
    const size_t wanted = size.value_or(kind.defaultSize);
    if (wanted < kind.low || wanted > kind.high)
        throw host::InputError("--size of " + std::string(kind.name) + " must lie in " + std::to_string(kind.low) + " to " +
                               std::to_string(kind.high));
    return fit(kind, wanted, seed);
}

}  // namespace gno::scenes
