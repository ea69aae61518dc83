// SPDX-License-Identifier: MIT
// What the instrumented build of a TOP tree adds up (gnoTotals of glsl/top/examples/build.comp and glsl/forest/examples/build.comp).
#pragma once
#include "host_min/techniques/top_tree.hpp"

namespace gno::host {

class BuildTotals {
public:
    explicit BuildTotals(const Device& device) : buffer_(device, sizeof(Words)) { buffer_.fill(0); }

    [[nodiscard]] Binding binding() const { return {"gnoTotals", &buffer_}; }
    [[nodiscard]] TopBuildCounters read() const {
        const Words words = buffer_.downloadAs<Words>().front();
        return {uint64_t(words.stepsHigh) << 32 | words.stepsLow, words.intersections, words.dropped, words.inserted};
    }

private:
    struct Words {
        uint32_t stepsLow, stepsHigh, intersections, dropped, inserted;
    };
    Buffer buffer_;
};

}  // namespace gno::host
