// SPDX-License-Identifier: MIT
// Colours that everybody can tell apart: viridis (perceptually uniform) for numbers, Okabe and Ito's for kinds.
#pragma once
#include <string>
#include <vector>

#include <vtkLookupTable.h>
#include <vtkSmartPointer.h>
#include <glm/glm.hpp>

namespace gno::viz {

/// Numbers from `least` to `most`; logarithmic asks for least > 0.
vtkSmartPointer<vtkLookupTable> numberColours(double least, double most, bool logarithmic = false);

struct Kind {
    std::string name;
    glm::dvec3 colour;  ///< sRGB, 0 .. 1
};

/// Values 0, 1, ... with their names.
vtkSmartPointer<vtkLookupTable> kindColours(const std::vector<Kind>& kinds);

inline constexpr glm::dvec3 kOrange{0.902, 0.624, 0.0}, kSky{0.337, 0.706, 0.914}, kGreen{0.0, 0.620, 0.451}, kYellow{0.941, 0.894, 0.259},
    kBlue{0.0, 0.447, 0.698}, kVermilion{0.835, 0.369, 0.0}, kPurple{0.8, 0.475, 0.655}, kDark{0.12, 0.12, 0.14}, kWhite{1.0, 1.0, 1.0},
    kPale{0.72, 0.73, 0.75};

}  // namespace gno::viz
