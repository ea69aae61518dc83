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

/// What the layer (1.3.239) says nothing of, here or in one of the lists: it reports no write after a write between descriptors, and takes an atomic
/// for a read.
constexpr std::string_view kAtomics = "what came before changed the same words by atomics only, or wrote beside what is read";
constexpr std::string_view kInPlace = "it changes in place what the pass before wrote";
constexpr std::string_view kCounts = "the counts of the indirect dispatch were made by atomics";

using test::UnseenBarrier, test::kAnyNumber;
const std::vector<UnseenBarrier> kUnseen{{"forest/examples/assign_many.comp", kAnyNumber, kBeforeShaders, kAtomics, true},
                                         {"forest/examples/assign_many.comp", kAnyNumber, kBeforeIndirect, kCounts, true},
                                         {"forest/examples/assign_some.comp", kAnyNumber, kBeforeShaders, kAtomics, true},
                                         {"forest/examples/assign_some.comp", kAnyNumber, kBeforeIndirect, kCounts, true},
                                         {"forest/examples/assign_few.comp", kAnyNumber, kBeforeShaders, kAtomics, true},
                                         {"forest/examples/sort.comp", kAnyNumber, kBeforeShaders, kInPlace, true},
                                         {"forest/examples/set_up.comp", kAnyNumber, kBeforeIndirect, kCounts, true},
                                         {"rivals/examples/light_grid_allocate.comp", kAnyNumber, kBeforeShaders, kInPlace, true},
                                         {"rivals/examples/light_grid_allocate.comp", kAnyNumber, kBeforeIndirect, kCounts, true},
                                         {"rivals/examples/light_grid_depth.comp", kAnyNumber, kBeforeShaders, kInPlace, true},
                                         {"rivals/examples/light_grid_pairs.comp", kAnyNumber, kBeforeShaders, kAtomics, true},
                                         {"rivals/examples/light_grid_pairs.comp", kAnyNumber, kBeforeIndirect, kCounts, true},
                                         {"rivals/examples/light_grid_planes.comp", kAnyNumber, kBeforeShaders, kAtomics, true},
                                         {"rivals/examples/light_grid_sort.comp", kAnyNumber, kBeforeIndirect, kCounts, true}};

void expectForest(bool directional, bool viewCull, bool cover, std::span<const test::UnseenBarrier> unseen) {
    SCOPED_TRACE(std::string(directional ? "directional" : "point") + (viewCull ? ", view cull" : "") + (cover ? ", cover" : ""));
    const test::SmallFrame frame(directional);
    const host::FrameInputs& inputs = frame.inputs();
    const LightCells cells = host::lightCells(inputs, 16, viewCull, cover);
    host::ArrayBuffers arrays;
    arrays.fit(inputs.device(), forestArrays(cells, forestFirstPool(inputs.casterCount()), {}));
    PassList passes = forestBuildPasses(cells, {});
    append(passes, forestQueryPasses(inputs.width(), inputs.height(), {}, {}));
    test::expectExactBarriers({passes, frame.with(arrays.bindings()), inputs.push()}, unseen);
}

TEST(PassBarriers, Forest) {
    for (const bool viewCull : {false, true})
        for (const bool cover : {false, true}) expectForest(viewCull != cover, viewCull, cover, kUnseen);
}

void expectLightGrid(bool viewCull, bool cover, uint32_t nest, std::span<const test::UnseenBarrier> unseen) {
    SCOPED_TRACE(std::string(viewCull ? "view cull, " : "") + (cover ? "cover, " : "") + "nest " + std::to_string(nest));
    const test::SmallFrame frame(false);
    const host::FrameInputs& inputs = frame.inputs();
    const LightCells cells = host::lightCells(inputs, 16, viewCull, cover);
    const LightGridPools pools = lightGridFirstPools(inputs.casterCount());
    const LightGridOptions options{.nest = nest};
    host::ArrayBuffers arrays;
    arrays.fit(inputs.device(), lightGridArrays(cells, pools, lightGridNests(cells, pools.pairs, nest, 1u << 27), options));
    PassList passes = lightGridBuildPasses(cells, options);
    append(passes, lightGridQueryPasses(inputs.width(), inputs.height(), 2, options, false));
    test::expectExactBarriers({passes, frame.with(arrays.bindings()), inputs.push()}, unseen);
}

TEST(PassBarriers, LightGrid) {
    for (const bool viewCull : {false, true}) expectLightGrid(viewCull, viewCull, 8, kUnseen);
    expectLightGrid(true, true, 0, kUnseen);
}

}  // namespace
}  // namespace gno
