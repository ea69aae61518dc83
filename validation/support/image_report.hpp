// SPDX-License-Identifier: MIT
// What a failing image test leaves behind: got.png, want.png, diff.png, and a table of the wrong pixels.
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "host_min/frame/inputs.hpp"

namespace gno::test {

/// All spans have width * height entries, rows top to bottom.
struct MaskReport {
    std::string name;  ///< of the folder; may hold slashes
    uint32_t width, height;
    std::span<const uint32_t> got, want;         ///< GNO_VISIBILITY_*
    std::span<const host::OracleSample> pixels;  ///< as FrameInputs::pixels()
    std::span<const uint32_t> caster;            ///< who shadows the pixel, says the oracle; host::kNoCaster: nobody
};

/// Writes FOLDER/NAME/{got,want,diff}.png and pixels.csv (x, y, sample, own, caster, got, want; numbers print exactly). Returns FOLDER/NAME.
std::filesystem::path writeReport(const std::filesystem::path& folder, const MaskReport& report);

/// The oracle's answer, which knows view samples only, spread over the pixels.
struct PixelAnswer {
    std::vector<uint32_t> want, caster;
};
PixelAnswer spread(const host::OracleAnswer& answer, std::span<const host::OracleSample> pixels);

}  // namespace gno::test
