// SPDX-License-Identifier: MIT
#include "validation/study/pictures.hpp"

#include <fmt/format.h>

#include "host_min/output/atomic_file.hpp"
#include "host_min/output/png.hpp"
#include "host_min/output/shade_picture.hpp"
#include "validation/study/sweep_options.hpp"

namespace gno::study {
namespace {

/// The sums of all pixels, from those of the samples.
std::vector<glm::uvec3> sumsOfPixels(const Subject& subject) {
    std::vector<glm::uvec3> sums;
    size_t sample = 0;
    for (const host::OracleSample& pixel : subject.inputs().pixels())
        sums.push_back(pixel.own <= GNO_NO_CASTER ? subject.answer().sums[sample++] : glm::uvec3(0));
    return sums;
}

}  // namespace

Worst::Worst(const std::vector<Row>& rows) {
    for (const Row& row : rows) isWorse(row);
}

bool Worst::isWorse(const Row& row) {
    if (!row.contains("check")) return false;
    const auto wrong = row["check"].value("wrong", uint64_t(0)), checked = row["check"].value("checked", uint64_t(0));
    if (wrong == 0 || checked == 0) return false;
    double& most = shares_[{row.value("scene", ""), row.value("technique", ""), row.value("precision", "")}];
    const double share = double(wrong) / double(checked);
    if (share <= most) return false;
    most = share;
    return true;
}

Row GroupPictures::write(const Row& row, const host::TechniqueResult& result) {
    if (!frame_) frame_.emplace(subject_.inputs(), subject_.file(), subject_.light());
    const bool withSums = !result.sums.empty();
    const host::FrameInputs& inputs = subject_.inputs();
    const host::Raster<uint8_t> got(inputs.width(), inputs.height(), host::narrowVisibility(result.visibility));
    const host::Raster<uint8_t> want = frame_->wanted(got, subject_.answer(), withSums);
    host::Raster<glm::vec3> passing, passingTruth;
    if (withSums) {
        passing = host::passingLight(inputs, result.sums);
        passingTruth = host::passingLight(inputs, sumsOfPixels(subject_));
    }
    host::makeFolder(folder_ / "pictures");
    Row names = Row::object();
    const std::string stem = fmt::format("pictures/{}-f{:03}-l{}-{}x{}", row["name"].get<std::string>(), row["frame"].get<uint32_t>(),
                                         row["light"].get<uint32_t>(), inputs.width(), inputs.height());
    const std::string own =
        fmt::format("{}-{}.{}-{}", stem, row["technique"].get<std::string>(), row["precision"].get<std::string>(), stableHash(row["job"]));
    const auto write = [&](const char* key, const std::string& file, const host::Picture& picture) {
        host::writePng(folder_ / file, picture);
        names[key] = file;
    };
    write("shaded", own + "-shaded.png", frame_->shaded(got, withSums ? &passing : nullptr));
    const std::string truth = fmt::format("{}-{}-truth{}.png", stem, stableHash(row["group"]), withSums ? "-sums" : "");
    write("truth", truth, frame_->shaded(want, withSums ? &passingTruth : nullptr));
    write("wrong", own + "-wrong.png", host::differencePicture(got, want));
    return names;
}

}  // namespace gno::study
