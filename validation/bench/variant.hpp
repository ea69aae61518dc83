// SPDX-License-Identifier: MIT
// The TOP tree on the device, made of the modules as they stand or of a variant of their text (variants/NAME.variant), always with counters.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "host_min/techniques/technique.hpp"

namespace gno::bench {

inline constexpr const char* kAsShipped = "as shipped";

class Variant {
public:
    /// Throws when the build has no variant of this name.
    Variant(const host::Device& device, const std::string& name);

    struct Tree {
        host::Buffer planes, links, header;
        uint64_t steps = 0;  ///< of all insertions
    };
    [[nodiscard]] Tree build(const host::FrameInputs& inputs, uint32_t seed) const;

    struct Answer {
        std::vector<uint32_t> visibility;  ///< GNO_VISIBILITY_* per pixel
        uint64_t visitedNodes = 0, exactCalls = 0;
    };
    /// technique: psv, d-stackless or d-hybrid, with the host's own sizes of stacks. Precision certified.
    [[nodiscard]] Answer ask(const host::FrameInputs& inputs, const Tree& tree, const std::string& technique) const;

private:
    [[nodiscard]] std::unique_ptr<host::ComputePass> pass(const std::string& shader, const host::Specialization& constants) const;

    const host::Device& device_;
    std::string name_;
    std::unique_ptr<host::ComputePass> setUp_, build_;
    std::map<std::string, std::unique_ptr<host::ComputePass>> queries_;
};

}  // namespace gno::bench
