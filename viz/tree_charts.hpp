// SPDX-License-Identifier: MIT
// Charts about a TOP tree and about queries through it.
#pragma once
#include <span>

#include "viz/charts/figure.hpp"
#include "viz/query_path.hpp"
#include "viz/tree_statistics.hpp"

namespace gno::viz {

/// Depths, visits by depth, wedges, visits of single nodes.
Figure statisticsFigure(const Dump& dump, const TreeStatistics& statistics);

/// Depth of each visited node in the order of the visits, one panel per query; what brought the query there by colour and marker.
Figure stepsFigure(const std::string& title, std::span<const QueryPath> paths);

}  // namespace gno::viz
