// SPDX-License-Identifier: MIT
// One technique's result on one frame and light: asked about by the oracle, compared with its answer, made a record. For `gnomon shade` and for
// tools that measure without it.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "host_min/oracle.hpp"
#include "host_min/techniques/technique.hpp"

namespace gno::host {

Cull cullByName(const std::string& word);  ///< none, front, hull or all

/// Device time of a bare full-screen pass that reads the samples and writes a mask, ms: the median over `repeat`, as measure() takes it.
double measureFloor(const FrameInputs& inputs, uint32_t repeat, bool warmUp);

/// The technique answers for casters that are not opaque.
bool answersForMaterials(const TechniqueInfo& info);

/// The view samples of the inputs in the order of an oracle's answers.
std::vector<OracleSample> oracleSamples(const FrameInputs& inputs);

/// `withSums`: some technique answers for casters that are not opaque. `progress` as in Oracle::ask.
OracleAnswer askOracle(Oracle& oracle, const FrameInputs& inputs, bool withSums, const std::function<void(double)>& progress);

/// With sums, they have to be equal as well; then a wrong sample is a leak where too much light arrives, and false dark elsewhere. A sample
/// without an answer (GNO_VISIBILITY_UNKNOWN) is wrong, and neither. `wrongPixels`:
/// gets the indices of their pixels, in ascending order.
RecordCheck compare(const TechniqueResult& result, const FrameInputs& inputs, const OracleAnswer& answer,
                    std::vector<uint32_t>* wrongPixels = nullptr);

/// What the result and the inputs tell; who asked for it, and the check, is for the caller to fill in.
Record makeRecord(const FrameInputs& inputs, const TechniqueResult& result);

}  // namespace gno::host
