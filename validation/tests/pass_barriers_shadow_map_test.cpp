// SPDX-License-Identifier: MIT
// The barriers of a shadow map's lists: enough for frames that follow each other, and not one too much.
#include <gtest/gtest.h>

#include <array>

#include "host_min/techniques/shadow_map_layers.hpp"
#include "validation/support/barrier_check.hpp"

namespace gno {
namespace {

TEST(PassBarriers, ShadowMap) {
    const test::SmallFrame frame(false);
    const host::FrameInputs& inputs = frame.inputs();
    const ShadowMapOptions options{.size = 512};
    host::ShadowMapLayers layers(options, false);
    host::build(layers, inputs, {.warmUp = false});
    ASSERT_GE(layers.viewCount(), 2u);
    PassList passes = shadowMapFitPasses(inputs.width(), inputs.height());
    for (const Pass& pass : shadowMapBuildPasses(inputs.triangleCount(), layers.viewCount(), options)) passes.push_back(pass);
    for (const Pass& pass : shadowMapQueryPasses(inputs.width(), inputs.height(), false)) passes.push_back(pass);
    constexpr std::string_view noAttachments = "the layer (1.3.239) follows no attachments of dynamic rendering";
    const std::array unseen{test::UnseenBarrier{"shadow_map/examples/reset.comp", 0, kBeforeShaders,
                                                "drawing stands between it and the frame before; not when no view is drawn"},
                            test::UnseenBarrier{"shadow_map/examples/depth.vert", 0, kBeforeShaders, noAttachments},
                            test::UnseenBarrier{"shadow_map/examples/query.comp", 0, kBeforeDepth, noAttachments}};
    test::expectExactBarriers({passes, frame.with(layers.bindings()), inputs.push()}, unseen);
}

}  // namespace
}  // namespace gno
