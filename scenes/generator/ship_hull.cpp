// SPDX-License-Identifier: MIT
#include "scenes/generator/ship_hull.hpp"

#include <algorithm>
#include <cmath>

#include "scenes/generator/shapes.hpp"

namespace gno::scenes {

double deckHalfWidth(double x) {
    const double t = std::clamp(x / 17, -1.0, 1.0);
    return t > 0 ? 3.6 * std::sqrt(std::max(0.0, 1 - t * t * t)) + 0.05 : 3.6 - 1.1 * t * t;
}

double deckHeight(double x) { return 4.0 + 0.006 * x * x; }

namespace {

// Sections from the one side's rail over the keel to the other's; closed by the deck and by fans at both ends.
void addHullShell(Mesh& mesh, double inset, double top, double bottom) {
    constexpr int kSections = 48;
    constexpr uint32_t kRing = 25;
    const auto base = static_cast<uint32_t>(mesh.positions.size());
    for (int s = 0; s <= kSections; ++s) {
        const double x = -17 + 34.0 * s / kSections;
        const double half = deckHalfWidth(x) - inset;
        const double high = deckHeight(x) + top;
        const double t = x * x / (17 * 17);
        const double keel = bottom + 2.4 * t * t;
        for (uint32_t i = 0; i < kRing; ++i) {
            const double angle = kPi * i / (kRing - 1);
            const double belly = 0.75 + 0.25 * sine(angle);
            mesh.vertex({x, high - (high - keel) * sine(angle), -half * cosine(angle) * belly / 0.75});
        }
    }
    for (uint32_t s = 0; s < kSections; ++s)
        for (uint32_t i = 0; i < kRing; ++i) {
            const uint32_t a = base + s * kRing;
            const uint32_t j = (i + 1) % kRing;
            mesh.quad(a + i, a + j, a + kRing + j, a + kRing + i);
        }
    const uint32_t end = base + kSections * kRing;
    for (uint32_t i = 1; i + 1 < kRing; ++i) {
        mesh.triangle(base, base + i + 1, base + i);
        mesh.triangle(end, end + i, end + i + 1);
    }
}

}  // namespace

void addShipHull(Draft& draft) {
    const uint32_t dark = draft.material("hull", {0.22, 0.13, 0.08});
    const uint32_t planks = draft.material("planks", {0.56, 0.42, 0.26});
    const uint32_t stripe = draft.material("stripe", {0.74, 0.56, 0.22});
    const uint32_t iron = draft.material("iron", {0.10, 0.10, 0.11});
    Model hull;
    hull.name = "hull";
    addHullShell(hull.of(dark), 0.0, 0.0, 0.2);
    for (int i = 0; i < 60; ++i) {
        const double x = -16.6 + 0.55 * i;
        const double half = std::min(deckHalfWidth(x), deckHalfWidth(x + 0.53)) - 0.06;
        if (half < 0.2) continue;
        addBox(hull.of(planks), {x, deckHeight(x) - 0.2, -half}, {x + 0.53, deckHeight(x) + 0.05, half});
    }
    addBox(hull.of(planks), {-16.8, 4.5, -2.4}, {-10.5, 7.1, 2.4});
    addBox(hull.of(stripe), {-17.0, 7.0, -2.6}, {-10.2, 7.25, 2.6});
    addBox(hull.of(planks), {10.2, 4.3, -1.9}, {13.6, 5.9, 1.9});
    addBox(hull.of(planks), {-1.8, 4.0, -1.0}, {1.2, 4.45, 1.0});
    for (int i = 0; i < 5; ++i) addBox(hull.of(dark), {-16.98, 5.1, -2.0 + 0.85 * i}, {-16.7, 6.3, -1.4 + 0.85 * i});
    for (const double side : {-1.0, 1.0}) {
        Path rail;
        Path wale;
        for (int i = 0; i <= 56; ++i) {
            const double x = -10.0 + 0.47 * i;
            rail.push_back({x, deckHeight(x) + 0.95, side * (deckHalfWidth(x) + 0.02)});
            wale.push_back({x, deckHeight(x) - 0.3, side * (deckHalfWidth(x) + 0.06)});
            addCylinder(hull.of(planks), {x, deckHeight(x) - 0.1, side * (deckHalfWidth(x) - 0.02)}, rail.back(), 0.05, 0.05, 5);
        }
        addTube(hull.of(stripe), rail, 0.09, 6);
        addTube(hull.of(stripe), wale, 0.12, 6);
        for (int i = 0; i < 7; ++i) {
            const double x = -7.2 + 2.3 * i;
            const double z = side * (deckHalfWidth(x) - 1.1);
            addCylinder(hull.of(iron), {x, deckHeight(x) + 0.45, z}, {x, deckHeight(x) + 0.5, z + side * 1.9}, 0.17, 0.11, 10);
            addBox(hull.of(dark), {x - 0.25, deckHeight(x), z - 0.5}, {x + 0.25, deckHeight(x) + 0.4, z + 0.5});
        }
    }
    draft.placeOnce(std::move(hull));
}

}  // namespace gno::scenes
