// SPDX-License-Identifier: MIT
#include "host_min/app/result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host_min/techniques/measure.hpp"

namespace gno::host {

Cull cullByName(const std::string& word) {
    return word == "front" ? Cull::front : word == "hull" ? Cull::hull : word == "all" ? Cull::all : Cull::none;
}

double measureFloor(const FrameInputs& inputs, uint32_t repeat, bool warmUp) {
    const Image visibility(inputs.device(), inputs.width(), inputs.height(), vk::Format::eR32Uint);
    const ExamplePush push = inputs.push();
    const std::array resources{Binding{"gnoSamples", &inputs.samples()}, Binding{"gnoVisibility", &visibility}};
    {
        Recording recording(inputs.device());
        recording.toGeneral(visibility);
        recording.submit();
    }
    const auto times = measure(inputs.device(), repeat, warmUp, [&](Recording& recording) {
        recording.beginPass("floor");
        inputs.passes()
            .compute("core/examples/floor.comp")
            .dispatch(recording, resources, std::as_bytes(std::span(&push, 1)), (inputs.width() + 7) / 8, (inputs.height() + 7) / 8);
        recording.endPass();
    });
    return times.front().ms;
}

bool answersForMaterials(const TechniqueInfo& info) {
    return std::any_of(info.effects.begin(), info.effects.end(),
                       [](const std::string& effect) { return effect == "alpha_tested_casters" || effect == "coloured_casters"; });
}

std::vector<OracleSample> oracleSamples(const FrameInputs& inputs) {
    std::vector<OracleSample> samples;
    samples.reserve(inputs.sampleCount());
    for (const OracleSample& pixel : inputs.pixels())
        if (pixel.own <= GNO_NO_CASTER) samples.push_back(pixel);
    return samples;
}

OracleAnswer askOracle(Oracle& oracle, const FrameInputs& inputs, bool withSums, const std::function<void(double)>& progress) {
    const std::vector<OracleSample> samples = oracleSamples(inputs);
    OracleQuestion question{inputs.frame().triangles, {}, inputs.light(), samples};
    if (withSums) {
        question.surfaceOf = inputs.frame().surfaceOf;
        question.surfaces = inputs.frame().surfaces;
        question.look = inputs.frame().look.get();
    }
    return oracle.ask(question, progress);
}

RecordCheck compare(const TechniqueResult& result, const FrameInputs& inputs, const OracleAnswer& answer, std::vector<uint32_t>* wrongPixels) {
    RecordCheck check;
    size_t sample = 0;
    for (size_t pixel = 0; pixel < result.visibility.size(); ++pixel) {
        if (inputs.pixels()[pixel].own > GNO_NO_CASTER) continue;
        const size_t i = sample++;
        const bool dark = result.sums.empty() ? answer.inShadow[i] != 0 : answer.sums[i] == glm::uvec3(kNoLight);
        const bool sameSums = result.sums.empty() || result.sums[pixel] == answer.sums[i];
        ++check.checked;
        if (sameSums && result.visibility[pixel] == (dark ? GNO_VISIBILITY_SHADOW : GNO_VISIBILITY_LIT)) continue;
        ++check.wrong;
        if (result.visibility[pixel] != GNO_VISIBILITY_UNKNOWN) {
            const bool want = sameSums ? dark : glm::any(glm::lessThan(result.sums[pixel], answer.sums[i]));
            check.leaks += want;
            check.falseDark += !want;
        }
        if (wrongPixels) wrongPixels->push_back(uint32_t(pixel));
    }
    check.self = answer.selfShadowed;
    check.witness = answer.witnessDisagreements;
    return check;
}

Record makeRecord(const FrameInputs& inputs, const TechniqueResult& result) {
    Record record;
    const DeviceFacts& device = inputs.device().facts();
    record.device = {device.deviceName, fmt::format("{} {}", device.driverName, device.driverInfo), device.subgroupSize};
    record.size = {inputs.width(), inputs.height()};
    const Frame& frame = inputs.frame();
    record.grid = {{frame.grid.origin.x, frame.grid.origin.y, frame.grid.origin.z},
                   frame.grid.step(),
                   frame.harm.movedPixels,
                   frame.harm.lightArcsec,
                   frame.harm.changed};
    record.triangles = inputs.triangleCount();
    record.casters = inputs.casterCount();
    record.takenForOpaque = result.sums.empty() ? inputs.frame().surfaces.size() : 0;
    record.samples = inputs.sampleCount();
    record.inShadow = uint64_t(std::count(result.visibility.begin(), result.visibility.end(), GNO_VISIBILITY_SHADOW));
    record.unknown = uint64_t(std::count(result.visibility.begin(), result.visibility.end(), GNO_VISIBILITY_UNKNOWN));
    record.passes = result.passes;
    record.bytes = result.bytes;
    record.counters = result.counters;
    record.hostWaits = result.hostWaits;
    record.reruns = result.reruns;
    return record;
}

}  // namespace gno::host
