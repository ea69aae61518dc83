// SPDX-License-Identifier: MIT
// Colours that colour-blind readers can tell apart: Okabe and Ito's without their yellow, a grey, then six that lie far from these and from each
// other in CIE Lab, seen with and without red and green cones (Machado, Oliveira, Fernandes 2009), and are dark enough to stand on white.
#pragma once
#include <map>
#include <span>
#include <string>

#include "viz/charts/figure.hpp"

namespace gno::viz {

inline constexpr Color kInk{38, 38, 38}, kFaint{150, 150, 150};

/// A colour a name. It comes from the name itself, so that it stays when names are added, save where two names want the same one: then the later in
/// the alphabet takes the next free colour. With more names than colours they repeat; the marker has to tell.
std::map<std::string, Color> colorsOf(std::span<const std::string> names);

}  // namespace gno::viz
