// SPDX-License-Identifier: MIT
// Everything that is written for one frame and light: SCENE-lN-fNNN.exr, PNGs beside it, and with --dump the techniques' buffers.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "host_min/app/dump.hpp"
#include "host_min/app/frame_pictures.hpp"
#include "host_min/app/options.hpp"
#include "host_min/output/exr.hpp"
#include "host_min/output/image.hpp"

namespace gno::host {

class FrameOutputs {
public:
    FrameOutputs(const ShadeOptions& options, const FrameInputs& inputs, const SceneFile& file, uint32_t frame, uint32_t light);

    /// `answer` may be null: then there is no difference picture.
    void add(const Record& record, const TechniqueResult& result, const OracleAnswer* answer);
    void write();  ///< makes the folder; each file is complete or not there

private:
    struct NamedPicture {
        std::string suffix;  ///< "d-psv.certified-mask"
        Picture picture;
    };
    const ShadeOptions& options_;
    const FrameInputs& inputs_;
    std::string stem_;                    ///< SCENE-lN-fNNN
    std::optional<FramePictures> frame_;  ///< with pictures only
    std::vector<ExrLayer> layers_;
    std::vector<NamedPicture> pictures_;
    std::vector<Dump> dumps_;
};

}  // namespace gno::host
