// SPDX-License-Identifier: MIT
// Runs a list of passes (glsl/core/pass.hpp) as any engine would: resources by their names, barriers from the list, a time stamp on either side of
// each part. Making one compiles pipelines and writes descriptor sets; recording allocates nothing, submits nothing, waits for nothing.
#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "glsl/core/pass.hpp"
#include "host_min/frame/example_push.hpp"
#include "host_min/vulkan/pass_cache.hpp"
#include "host_min/vulkan/recording.hpp"

namespace gno::host {

struct PassRunnerOptions {
    bool counters = false;                                   ///< the instrumented variant of each shader that has one
    float slopeBias = 0;                                     ///< of depth passes: Vulkan's depthBiasSlopeFactor
    std::function<void(Recording&, const Pass&)> command{};  ///< records passes of PassKind::command
};

class PassRunner {
public:
    PassRunner() = default;
    /// `resources` must outlive it: arrays by name, images (the visibility is the colour target of full-screen passes, the image of a depth pass's
    /// `writes` its target). Throws std::logic_error when a shader wants what is not there, or a constant has a name that it does not know.
    PassRunner(PassCache& passes, const PassList& list, std::span<const Binding> resources, PassRunnerOptions options = {});

    /// All passes with their barriers; consecutive passes of one part between two time stamps.
    void record(Recording& recording, const ExamplePush& push) const;
    /// The same without time stamps (these bring barriers of their own).
    void recordBare(Recording& recording, const ExamplePush& push) const;

    [[nodiscard]] const PassList& list() const { return list_; }

private:
    struct Ready {
        const ComputePass* compute = nullptr;
        const RasterPass* raster = nullptr;
        BoundSets sets;
        const Buffer* indirect = nullptr;
        const Image* target = nullptr;
    };
    void recordPass(Recording& recording, size_t index, const ExamplePush& push) const;

    PassList list_;
    PassRunnerOptions options_;
    std::vector<Ready> ready_;
};

}  // namespace gno::host
