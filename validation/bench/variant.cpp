// SPDX-License-Identifier: MIT
#include "validation/bench/variant.hpp"

#include <fmt/format.h>

#include <array>

#include "glsl/core/pass.hpp"
#include "glsl/top/node.h"
#include "validation/support/spirv_file.hpp"

namespace gno::bench {
namespace {

using host::Binding;

constexpr uint32_t kPoison = 0xDEADBEEFu;  // a shader that writes nothing must not look right

host::Specialization constants(uint32_t stack, bool depthTest) {
    return {{GNO_ID_PRECISION, GNO_PRECISION_CERTIFIED}, {GNO_ID_STACK_SIZE, stack}, {GNO_ID_DEPTH_TEST, depthTest ? 1u : 0u}};
}

}  // namespace

Variant::Variant(const host::Device& device, const std::string& name) : device_(device), name_(name) {
    const host::Specialization build{{GNO_ID_PRECISION, GNO_PRECISION_CERTIFIED}, {GNO_ID_GROUP_SIZE, kTopGroupSize}};
    setUp_ = pass("set_up", build);
    build_ = pass("build", build);
    queries_["psv"] = pass("query_stack", constants(32, false));
    queries_["d-stackless"] = pass("query_stackless", constants(1, true));
    queries_["d-hybrid"] = pass("query_hybrid", constants(12, true));
}

std::unique_ptr<host::ComputePass> Variant::pass(const std::string& shader, const host::Specialization& values) const {
    if (name_ == kAsShipped) return std::make_unique<host::ComputePass>(device_, fmt::format("top/examples/{}.comp.counters", shader), values);
    const std::vector<uint32_t> spirv = test::readSpirv(fmt::format("{}/{}/{}.spv", GNOMON_BENCH_VARIANTS, name_, shader));
    return std::make_unique<host::ComputePass>(device_, std::span(spirv), values);
}

Variant::Tree Variant::build(const host::FrameInputs& inputs, uint32_t seed) const {
    Tree tree{{device_, topPlaneBytes(inputs.triangleCount())}, {device_, topLinkBytes(inputs.triangleCount())}, {device_, sizeof(GnoTopHeader)}};
    host::Buffer totals(device_, 5 * 4);
    totals.fill(0);
    const host::ExamplePush push = inputs.push(seed);
    const auto bytes = std::as_bytes(std::span(&push, 1));
    const std::array resources{Binding{"gnoCasters", &inputs.casters()}, Binding{"gnoStates", &inputs.states()},
                               Binding{"gnoTopPlanes", &tree.planes},    Binding{"gnoTopLinks", &tree.links},
                               Binding{"gnoTopHeader", &tree.header},    Binding{"gnoTotals", &totals}};
    host::Recording recording(device_);
    for (const auto* dispatch : {setUp_.get(), build_.get()}) {
        recording.beginPass(dispatch == build_.get() ? "build" : "set_up");
        dispatch->dispatch(recording, resources, bytes, groupsFor(inputs.triangleCount(), kTopGroupSize));
        recording.endPass();
    }
    recording.submit();
    const auto words = totals.downloadAs<uint32_t>();
    tree.steps = uint64_t(words[1]) << 32 | words[0];
    return tree;
}

Variant::Answer Variant::ask(const host::FrameInputs& inputs, const Tree& tree, const std::string& technique) const {
    host::Image visibility(device_, inputs.width(), inputs.height(), vk::Format::eR32Uint);
    host::Image counts(device_, inputs.width(), inputs.height(), vk::Format::eR32G32B32A32Uint);
    for (host::Image* image : {&visibility, &counts}) image->clear(vk::ClearColorValue(kPoison, kPoison, kPoison, kPoison));
    const host::ExamplePush push = inputs.push();
    const std::array resources{Binding{"gnoCasters", &inputs.casters()},
                               Binding{"gnoTopPlanes", &tree.planes},
                               Binding{"gnoTopLinks", &tree.links},
                               Binding{"gnoTopHeader", &tree.header},
                               Binding{"gnoSamples", &inputs.samples()},
                               Binding{"gnoVisibility", &visibility},
                               Binding{"gnoCounts", &counts}};
    host::Recording recording(device_);
    queries_.at(technique)->dispatch(recording, resources, std::as_bytes(std::span(&push, 1)), (inputs.width() + 7) / 8, (inputs.height() + 7) / 8);
    recording.submit();
    Answer answer{.visibility = visibility.downloadAs<uint32_t>()};
    for (const glm::uvec4& pixel : counts.downloadAs<glm::uvec4>()) {
        answer.visitedNodes += pixel.x;
        answer.exactCalls += pixel.w;
    }
    return answer;
}

}  // namespace gno::bench
