// SPDX-License-Identifier: MIT
// `--dump`: what one technique left on the device for one frame and light, as STEM-NAME.bin files with a STEM-dump.json that says what they hold
// (README.md, "What --dump writes"). viz/ reads them.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "host_min/techniques/technique.hpp"

namespace gno::host {

struct Dump {
    std::string suffix;            ///< "d-psv.certified"
    nlohmann::ordered_json index;  ///< all but its "buffers"
    std::vector<DumpedBuffer> buffers;
};

/// Adds to the technique's own buffers what they were made from and what came out. `answer` may be null: nobody asked the oracle.
Dump makeDump(const FrameInputs& inputs, const TechniqueResult& result, const Record& record, const OracleAnswer* answer);

/// Each file is complete or not there; the index is the last one. `stem` is SCENE-lN-fNNN.
void writeDump(const std::filesystem::path& folder, const std::string& stem, const Dump& dump);

}  // namespace gno::host
