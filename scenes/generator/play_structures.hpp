// SPDX-License-Identifier: MIT
// What stands on a playground. Every model stands around its own origin on y = 0 and consists of closed solids.
#pragma once
#include "scenes/generator/draft.hpp"

namespace gno::scenes {

struct PlayPaints {
    uint32_t wood, red, yellow, blue, steel, rope;
};

Model playTower(const PlayPaints& paints, int sides);     ///< platform, roof, slide, ladder, climbing net
Model climbingDome(const PlayPaints& paints, int sides);  ///< bars along the edges of a geodesic half ball
Model monkeyBars(const PlayPaints& paints, int sides);
Model swingFrame(const PlayPaints& paints, int sides);  ///< 4 m wide, top bar at 2.4 m
Model swingSeat(const PlayPaints& paints, int sides);   ///< origin at the top bar, chains of single links
Model springRider(const PlayPaints& paints, uint32_t body, int sides);
Model merryGoRound(const PlayPaints& paints, int sides);
Model seesaw(const PlayPaints& paints, int sides);
Model parkBench(const PlayPaints& paints);

}  // namespace gno::scenes
