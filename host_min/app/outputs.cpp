// SPDX-License-Identifier: MIT
#include "host_min/app/outputs.hpp"

#include <fmt/format.h>

#include "host_min/output/atomic_file.hpp"
#include "host_min/output/heatmap.hpp"
#include "host_min/output/png.hpp"
#include "host_min/output/shade_picture.hpp"

namespace gno::host {

FrameOutputs::FrameOutputs(const ShadeOptions& options, const FrameInputs& inputs, const SceneFile& file, uint32_t frame, uint32_t light)
    : options_(options), inputs_(inputs), stem_(fmt::format("{}-l{}-f{:03}", options.scene.stem().string(), light, frame)) {
    if (!options.pictures) return;
    frame_.emplace(inputs, file, inputs.frame().lights.at(light));
    layers_.push_back(exrVectorLayer("position", frame_->positions().pixels));
    layers_.push_back(exrVectorLayer("normal", frame_->normals().pixels));
    layers_.push_back({"primitive", {{"", frame_->primitives()}}});
}

void FrameOutputs::add(const Record& record, const TechniqueResult& result, const OracleAnswer* answer) {
    const std::string layerName = fmt::format("{}.{}", record.technique, record.precision);
    if (options_.dump) dumps_.push_back(makeDump(inputs_, result, record, answer));
    if (!options_.pictures) return;
    const uint32_t w = inputs_.width(), h = inputs_.height();
    const Raster<uint8_t> visibility(w, h, narrowVisibility(result.visibility));
    ExrLayer layer{layerName, {{"visibility", visibility.pixels}}};
    const Raster<glm::vec3> passing = passingLight(inputs_, result.sums);
    if (!result.sums.empty()) layers_.push_back(exrVectorLayer(layerName + ".passing", passing.pixels));
    pictures_.push_back({layerName + "-shaded", frame_->shaded(visibility, result.sums.empty() ? nullptr : &passing)});
    pictures_.push_back({layerName + "-mask", maskPicture(visibility)});
    const auto addHeatMap = [&](const std::vector<uint32_t>& values, const char* channel, const char* title, const char* unit) {
        if (values.empty()) return;
        layer.channels.push_back({channel, values});
        pictures_.push_back({fmt::format("{}-{}", layerName, channel),
                             heatMap(Raster<uint32_t>(w, h, values), frame_->isSample(), {fmt::format("{}: {}", layerName, title), unit, {}})});
    };
    addHeatMap(result.visitedNodes, "visited_nodes", "visited nodes", "nodes");
    addHeatMap(result.sampleTests, "sample_tests", "tests of a sample", "tests");
    addHeatMap(result.deepestStack, "stack", "deepest stack", "entries");
    if (answer) {
        const Raster<uint8_t> want = frame_->wanted(visibility, *answer, !result.sums.empty());
        pictures_.push_back({layerName + "-difference", differencePicture(visibility, want)});
    }
    layers_.push_back(std::move(layer));
}

void FrameOutputs::write() {
    if (options_.pictures || !dumps_.empty()) makeFolder(options_.out);
    for (const NamedPicture& picture : pictures_) writePng(options_.out / fmt::format("{}-{}.png", stem_, picture.suffix), picture.picture);
    if (options_.pictures) writeExr(options_.out / (stem_ + ".exr"), inputs_.width(), inputs_.height(), layers_);
    for (const Dump& dump : dumps_) writeDump(options_.out, stem_, dump);
}

}  // namespace gno::host
