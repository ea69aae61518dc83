// SPDX-License-Identifier: MIT
// Houses and street furniture of the city, all closed solids around their own origin on y = 0; metres.
#pragma once
#include "scenes/generator/draft.hpp"

namespace gno::scenes {

struct CityPaints {
    std::vector<uint32_t> walls;
    std::vector<uint32_t> cars;
    uint32_t window, trim, tiles, metal, rubber;
};

/// A house of about 14 by 13 m with `floors` floors, facade to +z.
Model makeHouse(const CityPaints& paints, int floors, bool gabled, Random& random);
Model makeTower(const CityPaints& paints, int floors, Random& random);
Model makeCar(const CityPaints& paints, uint32_t color);
Model makeStreetLamp(const CityPaints& paints);
Model makeBollard(const CityPaints& paints);

}  // namespace gno::scenes
