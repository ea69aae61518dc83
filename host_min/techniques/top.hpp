// SPDX-License-Identifier: MIT
// The four queries of "Deep Partitioned Shadow Volumes" over one TOP tree.
#pragma once
#include <memory>

#include "host_min/techniques/technique.hpp"

namespace gno::host {

enum class TopTechniqueName { psv, dPsv, dStackless, dHybrid };

std::unique_ptr<Technique> makeTopTechnique(TopTechniqueName name);

}  // namespace gno::host
