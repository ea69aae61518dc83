// SPDX-License-Identifier: MIT
#pragma once
#include "scenes/generator/draft.hpp"

namespace gno::scenes {

/// Hull, deck houses, guns and rails of a three-master: x runs from stern (-17) to bow (17), the deck lies at about y = 4, all metres.
void addShipHull(Draft& draft);

/// Half width of the deck at x, and its height.
double deckHalfWidth(double x);
double deckHeight(double x);

}  // namespace gno::scenes
