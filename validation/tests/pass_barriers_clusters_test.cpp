// SPDX-License-Identifier: MIT
// The barriers of a cluster hierarchy's lists: enough for frames that follow each other, and not one too much.
#include <gtest/gtest.h>

#include <array>

#include "glsl/clusters/passes.hpp"
#include "host_min/techniques/array_buffers.hpp"
#include "host_min/vulkan/buffer.hpp"
#include "validation/support/barrier_check.hpp"

namespace gno {
namespace {

/// What the layer (1.3.239) says nothing of in some of the forms: it reports no write after a write between descriptors, and takes an atomic for a
/// read.
using test::UnseenBarrier, test::kAnyNumber;
const std::array kUnseen{
    UnseenBarrier{"clusters/examples/up.comp", kAnyNumber, kBeforeShaders, "it changes in place what the pass before wrote", true},
    UnseenBarrier{"clusters/examples/volumes.comp", kAnyNumber, kBeforeShaders,
                  "it counts where one light's volumes follow another's finish with no merge between", true},
    UnseenBarrier{"clusters/examples/merge.comp", kAnyNumber, kBeforeShaders, "what it reads was made by atomics", true},
    UnseenBarrier{"clusters/examples/merge_layers.comp", kAnyNumber, kBeforeShaders, "what it reads was made by atomics", true}};

class PassBarriersClusters : public testing::TestWithParam<ClusterOptions> {};

TEST_P(PassBarriersClusters, Exact) {
    const test::SmallFrame frame(false);
    const host::FrameInputs& inputs = frame.inputs();
    host::ArrayBuffers arrays;
    arrays.fit(inputs.device(), clusterArrays(inputs.width(), inputs.height(), inputs.triangleCount(), GetParam()));
    std::vector<host::Binding> bound = arrays.bindings();
    const host::Buffer materials(inputs.device(), 16);  // recorded, not run
    for (const char* name : {"gnoMaterialOf", "gnoSurfaces", "gnoMaterials", "gnoTexels"}) bound.push_back({name, &materials});
    PassList passes = clusterBuildPasses(inputs.width(), inputs.height(), inputs.triangleCount(), GetParam());
    for (const Pass& pass : clusterQueryPasses(inputs.width(), inputs.height(), GetParam())) passes.push_back(pass);
    test::expectExactBarriers({passes, frame.with(bound), inputs.push()}, kUnseen);
}

INSTANTIATE_TEST_SUITE_P(Forms, PassBarriersClusters,
                         testing::Values(ClusterOptions{}, ClusterOptions{.form = ClusterForm::implicitBounds, .split = 0},
                                         ClusterOptions{.form = ClusterForm::explicitBounds}, ClusterOptions{.form = ClusterForm::flat},
                                         ClusterOptions{.layers = true}));

}  // namespace
}  // namespace gno
