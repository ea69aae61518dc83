// SPDX-License-Identifier: MIT
// A second, faster witness: Embree answers the oracle's question with fp32 shadow rays. It may be wrong; the oracle stands.
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "host_min/oracle.hpp"

namespace gno::host::oracle {

/// One entry per sample, 1 = something but the sample's own triangle is between it and the light (embree_scene.hpp, robust mode). Throws WorkError
/// when Embree fails.
std::vector<uint8_t> askWitness(const OracleQuestion& question, const std::function<void(double)>& progress);

}  // namespace gno::host::oracle
