// SPDX-License-Identifier: MIT
// A second, faster witness: Embree answers the oracle's question with fp32 shadow rays. It may be wrong; the oracle stands.
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "host_min/oracle.hpp"

namespace gno::host::oracle {

/// One entry per sample, 1 = something but the sample's own triangle is between it and the light. Throws WorkError when Embree fails.
/// Rays start at the sample (tnear 0) and end just before a point light; edge-on casters are hit or missed as fp32 has it.
std::vector<uint8_t> askWitness(const OracleQuestion& question, const std::function<void(double)>& progress);

}  // namespace gno::host::oracle
