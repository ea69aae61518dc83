// SPDX-License-Identifier: MIT
// The barriers of a TOP tree's lists: enough for frames that follow each other, and not one too much.
#include <gtest/gtest.h>

#include "glsl/top/passes.hpp"
#include "host_min/techniques/array_buffers.hpp"
#include "validation/support/barrier_check.hpp"

namespace gno {
namespace {

TEST(PassBarriers, Top) {
    const test::SmallFrame frame(false);
    const host::FrameInputs& inputs = frame.inputs();
    host::ArrayBuffers arrays;
    arrays.fit(inputs.device(), topArrays(inputs.triangleCount()));
    for (const TopQuery query : {TopQuery::stack, TopQuery::stackless, TopQuery::hybrid}) {
        PassList passes = topBuildPasses(inputs.triangleCount(), {});
        for (const Pass& pass : topQueryPasses(inputs.width(), inputs.height(), {.query = query})) passes.push_back(pass);
        test::expectExactBarriers({passes, frame.with(arrays.bindings()), inputs.push()});
    }
}

}  // namespace
}  // namespace gno
