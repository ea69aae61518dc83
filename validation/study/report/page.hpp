// SPDX-License-Identifier: MIT
// The page: one HTML file that needs nothing else. Styles, script, charts and pictures are inside.
#pragma once
#include <string>
#include <vector>

#include "validation/study/report/figures.hpp"

namespace gno::report {

struct DrawnFigure {
    NamedFigure what;
    std::string png;  ///< bytes
};

/// A technique's worst row, with the bytes of its pictures.
struct WorstFrame {
    const Row* row;
    std::string shaded, truth, wrong;  ///< PNG bytes; wrong may be empty
};

std::string makePage(const Study& study, const std::vector<DrawnFigure>& figures, const std::vector<WorstFrame>& worst);

std::string escaped(const std::string& text);  ///< for HTML text and attributes
std::string base64(const std::string& bytes);  ///< RFC 4648, padded

}  // namespace gno::report
