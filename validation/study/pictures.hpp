// SPDX-License-Identifier: MIT
// Pictures of the row where a technique and precision is worst on a scene, of all rows so far.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "host_min/app/frame_pictures.hpp"
#include "validation/study/results_file.hpp"
#include "validation/study/subject.hpp"

namespace gno::study {

/// The largest share of wrong samples so far, by scene, technique and precision.
class Worst {
public:
    explicit Worst(const std::vector<Row>& rows);
    /// True, and remembered, when this row has more of them than any before.
    bool isWorse(const Row& row);

private:
    std::map<std::tuple<std::string, std::string, std::string>, double> shares_;
};

/// Writes the pictures of one group's rows into FOLDER/pictures. Reads the frame back when the first one is asked for.
class GroupPictures {
public:
    GroupPictures(const Subject& subject, std::filesystem::path folder) : subject_(subject), folder_(std::move(folder)) {}

    /// Shaded by the result, shaded by the exact answers, and the wrong samples marked; the row's "pictures". Throws like AtomicFile.
    Row write(const Row& row, const host::TechniqueResult& result);

private:
    const Subject& subject_;
    std::filesystem::path folder_;
    std::optional<host::FramePictures> frame_;
};

}  // namespace gno::study
