// SPDX-License-Identifier: MIT
// The barriers of the forest's and the light grid's lists: enough for frames that follow each other, and not one too much.
#include <gtest/gtest.h>

#include <array>

#include "glsl/rivals/light_grid_passes.hpp"
#include "host_min/techniques/array_buffers.hpp"
#include "host_min/techniques/cell_assignment.hpp"
#include "validation/support/barrier_check.hpp"

namespace gno {
namespace {

void expectForest(bool directional, bool viewCull, bool cover, std::span<const test::UnseenBarrier> unseen) {
    SCOPED_TRACE(std::string(directional ? "directional" : "point") + (viewCull ? ", view cull" : "") + (cover ? ", cover" : ""));
    const test::SmallFrame frame(directional);
    const host::FrameInputs& inputs = frame.inputs();
    const LightCells cells = host::lightCells(inputs, "forest", 16, viewCull, cover);
    host::ArrayBuffers arrays;
    arrays.fit(inputs.device(), forestArrays(cells, forestFirstPool(inputs.casterCount()), {}));
    PassList passes = forestBuildPasses(cells, {});
    append(passes, forestQueryPasses(inputs.width(), inputs.height(), {}, {}));
    test::expectExactBarriers({passes, frame.with(arrays.bindings()), inputs.push()}, unseen);
}

TEST(PassBarriers, Forest) {
    const std::vector<test::UnseenBarrier> unseen;
    for (const bool viewCull : {false, true})
        for (const bool cover : {false, true}) expectForest(viewCull != cover, viewCull, cover, unseen);
}

void expectLightGrid(bool viewCull, bool cover, uint32_t nest, std::span<const test::UnseenBarrier> unseen) {
    SCOPED_TRACE(std::string(viewCull ? "view cull, " : "") + (cover ? "cover, " : "") + "nest " + std::to_string(nest));
    const test::SmallFrame frame(false);
    const host::FrameInputs& inputs = frame.inputs();
    const LightCells cells = host::lightCells(inputs, "light grid", 16, viewCull, cover);
    const LightGridPools pools = lightGridFirstPools(inputs.casterCount());
    const LightGridOptions options{.nest = nest};
    host::ArrayBuffers arrays;
    arrays.fit(inputs.device(), lightGridArrays(cells, pools, lightGridNests(cells, pools.pairs, nest, 1u << 27), options));
    PassList passes = lightGridBuildPasses(cells, options);
    append(passes, lightGridQueryPasses(inputs.width(), inputs.height(), 2, options, false));
    test::expectExactBarriers({passes, frame.with(arrays.bindings()), inputs.push()}, unseen);
}

TEST(PassBarriers, LightGrid) {
    const std::vector<test::UnseenBarrier> unseen;
    for (const bool viewCull : {false, true}) expectLightGrid(viewCull, viewCull, 8, unseen);
    expectLightGrid(true, true, 0, unseen);
}

}  // namespace
}  // namespace gno
