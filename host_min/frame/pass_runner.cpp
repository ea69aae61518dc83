// SPDX-License-Identifier: MIT
#include "host_min/frame/pass_runner.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "host_min/vulkan/buffer.hpp"
#include "host_min/vulkan/image.hpp"

namespace gno::host {
namespace {

constexpr uint32_t kPoison = 0xDEADBEEFu;  // a shader that writes nothing must not look right
constexpr std::string_view kFullscreen = "core/examples/fullscreen.vert";

const Binding& resourceNamed(std::span<const Binding> resources, std::string_view name) {
    const auto found = std::find_if(resources.begin(), resources.end(), [&](const Binding& b) { return b.name == name; });
    if (found == resources.end()) throw std::logic_error("a pass list names " + std::string(name) + ", which is not bound");
    return *found;
}

/// The instrumented shader where it differs from the plain one.
std::string variantOf(std::string_view shader, bool counters) {
    std::string name(shader);
    if (!counters) return name;
    const auto plain = embeddedShader(name), counting = embeddedShader(name + ".counters");
    return std::equal(plain.begin(), plain.end(), counting.begin(), counting.end()) ? name : name + ".counters";
}

}  // namespace

PassRunner::PassRunner(PassCache& passes, const PassList& list, std::span<const Binding> resources, PassRunnerOptions options)
    : list_(list), options_(std::move(options)) {
    for (const Pass& pass : list_) {
        Ready ready;
        std::vector<Binding> renamed;
        for (const Renamed& other : pass.renamed) renamed.push_back({other.inShader, resourceNamed(resources, other.array).resource});
        renamed.insert(renamed.end(), resources.begin(), resources.end());
        const std::span<const Constant> constants(pass.constants.begin(), pass.constants.size());
        switch (pass.kind) {
            case PassKind::compute: {
                const std::string shader = variantOf(pass.shader, options_.counters);
                ready.compute = &passes.compute(shader, specialize(std::array<std::string_view, 1>{shader}, constants));
                ready.sets = ready.compute->layout().bound(renamed);
                break;
            }
            case PassKind::fullscreen: {
                ready.target = std::get<const Image*>(resourceNamed(resources, *pass.writes.begin()).resource);
                const std::array formats{ready.target->format()};
                ready.raster = &passes.raster(std::string(kFullscreen), std::string(pass.shader), formats, false,
                                              specialize(std::array<std::string_view, 1>{pass.shader}, constants));
                ready.sets = ready.raster->layout().bound(renamed);
                break;
            }
            case PassKind::depth:
                ready.target = std::get<const Image*>(resourceNamed(resources, *pass.writes.begin()).resource);
                ready.raster =
                    &passes.raster(std::string(pass.shader), "", {}, true, specialize(std::array<std::string_view, 1>{pass.shader}, constants));
                ready.sets = ready.raster->layout().bound(renamed);
                break;
            case PassKind::command:
                if (!options_.command) throw std::logic_error("a pass list has a command that nobody records: " + std::string(pass.shader));
                break;
        }
        if (!pass.indirect.empty()) ready.indirect = std::get<const Buffer*>(resourceNamed(resources, pass.indirect).resource);
        ready_.push_back(std::move(ready));
    }
}

void PassRunner::record(Recording& recording, const ExamplePush& push) const {
    for (size_t i = 0; i < list_.size(); ++i) {
        const bool first = i == 0 || list_[i].part != list_[i - 1].part, last = i + 1 == list_.size() || list_[i].part != list_[i + 1].part;
        if (first)
            recording.beginPass(std::string(list_[i].part));  // with a barrier that waits for everything
        else if (list_[i].before != kBeforeNothing)
            recording.barrier(barrierBefore(list_[i]));
        recordPass(recording, i, push);
        if (last) recording.endPass();
    }
}

void PassRunner::recordBare(Recording& recording, const ExamplePush& push) const {
    for (size_t i = 0; i < list_.size(); ++i) {
        if (list_[i].before != kBeforeNothing) recording.barrier(barrierBefore(list_[i]));
        recordPass(recording, i, push);
    }
}

void PassRunner::recordPass(Recording& recording, size_t index, const ExamplePush& frame) const {
    const Pass& pass = list_[index];
    const Ready& ready = ready_[index];
    ExamplePush push = frame;
    push.number = pass.number;
    const auto bytes = std::as_bytes(std::span(&push, 1));
    switch (pass.kind) {
        case PassKind::compute:
            recording.commands().bindPipeline(vk::PipelineBindPoint::eCompute, ready.compute->pipeline());
            ready.compute->layout().bind(recording, vk::PipelineBindPoint::eCompute, ready.sets, bytes);
            if (ready.indirect)
                recording.commands().dispatchIndirect(ready.indirect->handle(), pass.indirectOffset);
            else
                recording.commands().dispatch(pass.groups[0], pass.groups[1], pass.groups[2]);
            break;
        case PassKind::fullscreen: {
            const std::array targets{RasterPass::Target{ready.target, vk::ClearColorValue(kPoison, kPoison, kPoison, kPoison)}};
            ready.raster->draw(recording, targets, nullptr, ready.sets, bytes, 3);
            break;
        }
        case PassKind::depth:
            ready.raster->drawDepth(recording, *ready.target, pass.number, options_.slopeBias, ready.sets, bytes, pass.groups[0]);
            break;
        case PassKind::command:
            options_.command(recording, pass);
            break;
    }
}

}  // namespace gno::host
