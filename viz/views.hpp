// SPDX-License-Identifier: MIT
// The views: each reads its dumps, writes pictures and VTK files into options.out, or shows a window. All throw InputError or WorkError.
#pragma once
#include "viz/options.hpp"

namespace gno::viz {

void viewTree(const Options& options);
void viewClusters(const Options& options);
void viewSamples(const Options& options);
void viewForest(const Options& options);

}  // namespace gno::viz
