// SPDX-License-Identifier: MIT
// The barriers of the rivals' lists: enough for frames that follow each other, and not one too much.
#include <gtest/gtest.h>

#include <array>

#include "host_min/techniques/light_bvh_tree.hpp"
#include "host_min/techniques/ray_scene.hpp"
#include "validation/support/barrier_check.hpp"

namespace gno {
namespace {

TEST(PassBarriers, LightBvh) {
    const test::SmallFrame frame(false);
    const host::FrameInputs& inputs = frame.inputs();
    const uint64_t pool = lightBvhFirstPool(inputs.casterCount(), false);
    host::ArrayBuffers arrays;
    arrays.fit(inputs.device(), lightBvhArrays(inputs.triangleCount(), pool));
    PassList passes = lightBvhBuildPasses(inputs.triangleCount(), pool);
    for (const Pass& pass : lightBvhQueryPasses(inputs.width(), inputs.height(), {})) passes.push_back(pass);
    constexpr std::string_view silent =
        "it changes in place what the pass before wrote: a write after a write to the layer (1.3.239), which says nothing of those by descriptors";
    const std::array unseen{test::UnseenBarrier{"rivals/examples/light_bvh_begin.comp", 0, kBeforeShaders, silent},
                            test::UnseenBarrier{"rivals/examples/light_bvh_sort_prefix.comp", test::kAnyNumber, kBeforeShaders, silent},
                            test::UnseenBarrier{"rivals/examples/light_bvh_up.comp", test::kAnyNumber, kBeforeShaders, silent},
                            test::UnseenBarrier{"rivals/examples/light_bvh_collapse.comp", 0, kBeforeIndirect,
                                                "the pass before counts by atomics alone, which the layer (1.3.239) takes for reads"}};
    test::expectExactBarriers({passes, frame.with(arrays.bindings()), inputs.push()}, unseen);
}

TEST(PassBarriers, RayQuery) {
    if (!test::talkingPasses().device().facts().rayQuery) GTEST_SKIP() << "no ray queries";
    const test::SmallFrame frame(false);
    const host::FrameInputs& inputs = frame.inputs();
    host::RayScene scene;
    scene.prepare(inputs);
    PassList passes = rayQueryBuildPasses(inputs.triangleCount());
    for (const Pass& pass : rayQueryPasses(inputs.width(), inputs.height(), false)) passes.push_back(pass);
    const std::array unseen{
        test::UnseenBarrier{"rivals/examples/ray_set_up.comp", 0, kBeforeRays,
                            "the query before it has waited for the builds; a build may follow a build, too"},
        test::UnseenBarrier{kRayTopLevel, 0, kBeforeRays, "the layer (1.3.239) follows no builds of acceleration structures"},
        test::UnseenBarrier{kRayBottomLevel, 0, kBeforeShaders, "the layer (1.3.239) follows no builds of acceleration structures"},
        test::UnseenBarrier{"rivals/examples/ray_query.comp", 0, kBeforeRays, "the same: it knows of no build before it"}};
    const auto command = [&](host::Recording& recording, const Pass& pass) { scene.recordCommand(recording, pass); };
    test::expectExactBarriers({passes, frame.with(scene.bindings()), inputs.push(), {.command = command}}, unseen);
}

}  // namespace
}  // namespace gno
