// SPDX-License-Identifier: MIT
// A light-space bounding volume hierarchy on the device, built by the pass list of glsl/rivals/light_bvh_passes.hpp.
#pragma once
#include <vector>

#include "glsl/rivals/light_bvh.h"
#include "glsl/rivals/light_bvh_passes.hpp"
#include "host_min/frame/pass_runner.hpp"
#include "host_min/techniques/array_buffers.hpp"
#include "host_min/techniques/structure.hpp"
#include "host_min/techniques/technique.hpp"

namespace gno::host {

struct LightBvhOptions {
    uint32_t pool = 0;  ///< references; 0: chosen from the casters, and enlarged when it was too small
};

/// Which limit of the device a frame would pass, and what to do; empty: none that is known before.
std::string lightBvhOverLimit(const DeviceFacts& device, const FrameLoad& load);

class LightBvhTree final : public Structure {
public:
    explicit LightBvhTree(const LightBvhOptions& options) : options_(options) {}

    void prepare(const FrameInputs& inputs) override;
    void record(Recording& recording, uint32_t segment) const override;
    /// Throws InputError when a given pool is too small, or more references are needed than the device allows.
    [[nodiscard]] bool read() override;

    [[nodiscard]] std::vector<Binding> bindings() const { return arrays_.bindings(); }
    [[nodiscard]] uint32_t references() const { return references_; }
    [[nodiscard]] uint32_t nodes() const { return nodeCount_; }
    [[nodiscard]] uint32_t levels() const { return levelCount_; }
    [[nodiscard]] NamedNumbers bytes() const;
    [[nodiscard]] std::vector<DumpedBuffer> dump() const;

private:
    LightBvhOptions options_;
    const FrameInputs* inputs_ = nullptr;
    ArrayBuffers arrays_;
    PassRunner passes_;
    uint64_t pool_ = 0;    ///< references
    uint64_t wanted_ = 0;  ///< by what earlier frames told
    uint32_t references_ = 0, nodeCount_ = 0, levelCount_ = 0;
};

}  // namespace gno::host
