// SPDX-License-Identifier: MIT
// Tables of the page. A click on a header sorts; numbers carry their exact value in data-v; the box above filters.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "validation/study/report/study.hpp"

namespace gno::report {

struct Cell {
    std::string text;
    std::optional<double> value;  ///< sorts by it; a table cell without one in a column of numbers comes last
};

struct Table {
    std::string id, caption;
    std::vector<std::string> headers;
    std::vector<std::vector<Cell>> rows;
};

Table priceTable(const Study& study);
Table ladderTable(const Study& study);
Table rowTable(const Study& study);

std::string htmlOf(const Table& table);

}  // namespace gno::report
