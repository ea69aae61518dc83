// SPDX-License-Identifier: MIT
#include "host_min/techniques/structure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "host_min/error.hpp"
#include "host_min/interrupt.hpp"
#include "host_min/techniques/measure.hpp"

namespace gno::host {
namespace {

constexpr uint32_t kMostReruns = 3;

std::vector<PassTime> once(Structure& structure, const Device& device) {
    throwIfInterrupted();
    const auto start = std::chrono::steady_clock::now();
    std::vector<PassTime> times;
    double onDevice = 0;
    for (uint32_t segment = 0; segment < structure.segments(); ++segment) {
        Recording recording(device);
        structure.record(recording, segment);
        for (PassTime& time : recording.submit()) {
            onDevice += time.ms;
            times.push_back(std::move(time));
        }
        if (segment + 1 < structure.segments()) structure.between(segment);
    }
    if (structure.segments() > 1) {
        // NaN where the device has no time stamps: then nobody knows which part of it was the host's.
        const double all = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
        times.push_back({"host_wait", std::isnan(onDevice) ? onDevice : std::max(0.0, all - onDevice)});
    }
    return times;
}

}  // namespace

FrameLoad FrameLoad::of(const FrameInputs& inputs) { return {inputs.triangleCount(), inputs.width(), inputs.height(), inputs.hasMaterials()}; }

std::string overCasters(uint64_t triangles, uint64_t most, const std::string& why) {
    if (triangles <= most) return {};
    return fmt::format("{} triangles, and it holds {} ({}): use a scene with fewer, or another technique", triangles, most, why);
}

void throwLimit(const std::string& text) {
    if (!text.empty()) throw LimitError(text);
}

void Structure::between(uint32_t) { throw std::logic_error("a structure of several segments must say what the host does between them"); }

void build(Structure& structure, const FrameInputs& inputs, const BuildOptions& options) {
    std::vector<std::vector<PassTime>> runs;
    for (structure.reruns_ = 0;; ++structure.reruns_) {
        structure.prepare(inputs);
        runs.assign(1, once(structure, inputs.device()));
        if (structure.read()) break;
        if (structure.reruns_ == kMostReruns) throw InputError("a structure is still not complete after its pool was enlarged three times");
    }
    if (options.warmUp) runs.clear();
    while (runs.size() < std::max(options.repeat, 1u)) runs.push_back(once(structure, inputs.device()));
    structure.passes_ = {{inputs.casterSetUp().name, inputs.casterSetUp().ms}};
    for (const PassTime& time : medianOf(runs)) structure.passes_.push_back({time.name, time.ms});
    if (options.counters) structure.count();
}

}  // namespace gno::host
