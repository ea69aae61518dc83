// SPDX-License-Identifier: MIT
#include "host_min/app/outputs.hpp"

#include <fmt/format.h>

#include "host_min/output/atomic_file.hpp"
#include "host_min/output/heatmap.hpp"
#include "host_min/output/png.hpp"
#include "host_min/output/shade_picture.hpp"

namespace gno::host {
namespace {

std::vector<glm::vec3> xyz(const Image& image) {
    std::vector<glm::vec3> result;
    for (const glm::vec4& texel : image.downloadAs<glm::vec4>()) result.emplace_back(texel);
    return result;
}

std::vector<uint8_t> narrow(const std::vector<uint32_t>& values) {
    std::vector<uint8_t> result;
    result.reserve(values.size());
    for (const uint32_t value : values) result.push_back(uint8_t(std::min(value, 255u)));
    return result;
}

}  // namespace

FrameOutputs::FrameOutputs(const ShadeOptions& options, const FrameInputs& inputs, const SceneFile& file, uint32_t frame, uint32_t light)
    : options_(options),
      inputs_(inputs),
      stem_(fmt::format("{}-l{}-f{:03}", options.scene.stem().string(), light, frame)),
      light_(inputs.frame().lights.at(light)) {
    if (!options.pictures) return;
    const uint32_t w = inputs.width(), h = inputs.height();
    positions_ = {w, h, xyz(inputs.positions())};
    normals_ = {w, h, xyz(inputs.normals())};
    baseColors_ = Raster<glm::vec3>(w, h);
    const auto primitives = inputs.primitives().downloadAs<uint32_t>();
    for (size_t i = 0; i < primitives.size(); ++i) {
        isSample_.push_back(inputs.pixels()[i].own <= GNO_NO_CASTER);
        if (primitives[i] != GNO_BACKGROUND) baseColors_.pixels[i] = glm::vec3(file.materials()[inputs.frame().material[primitives[i]]].baseColor);
    }
    layers_.push_back(exrVectorLayer("position", positions_.pixels));
    layers_.push_back(exrVectorLayer("normal", normals_.pixels));
    layers_.push_back({"primitive", {{"", primitives}}});
}

void FrameOutputs::add(const Record& record, const TechniqueResult& result, const OracleAnswer* answer) {
    const std::string layerName = fmt::format("{}.{}", record.technique, record.precision);
    if (options_.dump) dumps_.push_back(makeDump(inputs_, result, record, answer));
    if (!options_.pictures) return;
    const uint32_t w = inputs_.width(), h = inputs_.height();
    const Raster<uint8_t> visibility(w, h, narrow(result.visibility));
    ExrLayer layer{layerName, {{"visibility", visibility.pixels}}};
    Raster<glm::vec3> passing(w, h);
    for (size_t i = 0; i < result.sums.size(); ++i)
        for (int channel = 0; channel < 3; ++channel)
            passing.pixels[i][channel] = result.sums[i][channel] >= kNoLight ? 0.0f : std::exp2(-float(result.sums[i][channel]) / 65536.0f);
    if (!result.sums.empty()) layers_.push_back(exrVectorLayer(layerName + ".passing", passing.pixels));
    pictures_.push_back({layerName + "-shaded", shadePicture({positions_,
                                                              normals_,
                                                              baseColors_,
                                                              visibility,
                                                              light_.homogeneous,
                                                              light_.color,
                                                              {0, 1, 0},
                                                              inputs_.viewer(),
                                                              result.sums.empty() ? nullptr : &passing})});
    pictures_.push_back({layerName + "-mask", maskPicture(visibility)});
    const auto addHeatMap = [&](const std::vector<uint32_t>& values, const char* channel, const char* title, const char* unit) {
        if (values.empty()) return;
        layer.channels.push_back({channel, values});
        pictures_.push_back({fmt::format("{}-{}", layerName, channel),
                             heatMap(Raster<uint32_t>(w, h, values), isSample_, {fmt::format("{}: {}", layerName, title), unit, {}})});
    };
    addHeatMap(result.visitedNodes, "visited_nodes", "visited nodes", "nodes");
    addHeatMap(result.sampleTests, "sample_tests", "tests of a sample", "tests");
    addHeatMap(result.deepestStack, "stack", "deepest stack", "entries");
    if (answer) {
        Raster<uint8_t> want = visibility;
        size_t sample = 0;
        for (size_t i = 0; i < want.size(); ++i) {
            if (!isSample_[i]) continue;
            const bool dark = result.sums.empty() ? answer->inShadow[sample] != 0 : answer->sums[sample] == glm::uvec3(kNoLight);
            want.pixels[i] = uint8_t(dark ? GNO_VISIBILITY_SHADOW : GNO_VISIBILITY_LIT);
            ++sample;
        }
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
