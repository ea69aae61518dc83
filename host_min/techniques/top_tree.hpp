// SPDX-License-Identifier: MIT
// A TOP tree on the device, built by the pass list of glsl/top/passes.hpp.
#pragma once
#include <vector>

#include "glsl/top/node.h"
#include "glsl/top/passes.hpp"
#include "host_min/frame/pass_runner.hpp"
#include "host_min/techniques/array_buffers.hpp"
#include "host_min/techniques/structure.hpp"

namespace gno::host {

struct TopBuildCounters {
    uint64_t steps = 0, intersections = 0, dropped = 0, inserted = 0;
};

/// Which limit of the device a frame would pass, and what to do; empty: none.
std::string topOverLimit(const DeviceFacts& device, const FrameLoad& load, const TopOptions& options);

class TopTree final : public Structure {
public:
    explicit TopTree(const TopOptions& options) : options_(options) {}

    void prepare(const FrameInputs& inputs) override;
    void record(Recording& recording, uint32_t segment) const override;
    void count() override;

    [[nodiscard]] const Buffer& planes() const { return arrays_["gnoTopPlanes"]; }
    [[nodiscard]] const Buffer& links() const { return arrays_["gnoTopLinks"]; }
    [[nodiscard]] const Buffer& header() const { return arrays_["gnoTopHeader"]; }
    [[nodiscard]] std::vector<Binding> bindings() const { return arrays_.bindings(); }
    [[nodiscard]] const TopBuildCounters& counters() const { return counters_; }
    [[nodiscard]] uint64_t bytes() const { return arrays_.bytes({"gnoTopPlanes", "gnoTopLinks", "gnoTopHeader"}); }

private:
    TopOptions options_;
    const FrameInputs* inputs_ = nullptr;
    ArrayBuffers arrays_;
    PassRunner passes_;
    TopBuildCounters counters_;
};

}  // namespace gno::host
