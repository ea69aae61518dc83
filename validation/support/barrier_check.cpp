// SPDX-License-Identifier: MIT
#include "validation/support/barrier_check.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>

#include "validation/tests/made_scenes.hpp"

namespace gno::test {
namespace {

constexpr std::array kBits{kBeforeShaders, kBeforeIndirect, kBeforeTransfer, kBeforeDepth, kBeforeRays};

std::string nameOf(const Pass& pass, Before bit) {
    constexpr std::array names{"kBeforeShaders", "kBeforeIndirect", "kBeforeTransfer", "kBeforeDepth", "kBeforeRays"};
    size_t index = 0;
    while (kBits[index] != bit) ++index;
    return fmt::format("{}, number {}, {}", pass.shader, pass.number, names[index]);
}

}  // namespace

host::PassCache& talkingPasses() {
    static const host::Device device([] {
        for (const char* limit : {"VK_LAYER_ENABLE_MESSAGE_LIMIT", "VK_KHRONOS_VALIDATION_ENABLE_MESSAGE_LIMIT"}) setenv(limit, "0", 1);
        host::DeviceOptions options = host::DeviceOptions::fromEnvironment();
        options.validation = true;
        return options;
    }());
    static host::PassCache cache(device);
    return cache;
}

SmallFrame::SmallFrame(bool directional) : scene_(soup(1966, directional, 200, 0.1, 300)), frame_(frameOf(scene_)) {
    inputs_.emplace(talkingPasses(), frame_, scene_.samples, scene_.width);
    inputs_->setLight(scene_.light, host::Cull::none);
    visibility_.emplace(inputs_->device(), inputs_->width(), inputs_->height(), vk::Format::eR32Uint);
    visibility_->clear(vk::ClearColorValue(0u, 0u, 0u, 0u));
}

std::vector<host::Binding> SmallFrame::with(std::vector<host::Binding> others) const {
    std::vector<host::Binding> all = inputs_->withCasters(std::move(others));
    all.push_back({"gnoVisibility", &*visibility_});
    return all;
}

uint64_t messagesOfTwoFrames(const WholeFrame& frame) {
    const host::Device& device = talkingPasses().device();
    const host::PassRunner runner(talkingPasses(), frame.passes, frame.resources, frame.options);
    host::Recording recording(device);
    const uint64_t before = device.validationMessages();
    for (int i = 0; i < 2; ++i) runner.recordBare(recording, frame.push);
    return device.validationMessages() - before;
}

void expectExactBarriers(const WholeFrame& frame, std::span<const UnseenBarrier> unseen) {
    EXPECT_EQ(messagesOfTwoFrames(frame), 0u) << "the list as it is";
    std::vector<bool> met(unseen.size(), false);
    std::optional<WholeFrame> seen;  // one whose barrier was missed
    size_t bits = 0;
    for (size_t i = 0; i < frame.passes.size(); ++i)
        for (const Before bit : kBits) {
            if ((frame.passes[i].before & bit) == 0) continue;
            ++bits;
            WholeFrame mutant = frame;
            mutant.passes[i].before &= ~uint32_t(bit);
            const bool isSeen = messagesOfTwoFrames(mutant) > 0;
            const std::string name = nameOf(frame.passes[i], bit);
            bool listed = false;
            for (size_t k = 0; k < unseen.size(); ++k) {
                if (unseen[k].shader != frame.passes[i].shader || unseen[k].bit != bit) continue;
                if (unseen[k].number != kAnyNumber && unseen[k].number != frame.passes[i].number) continue;
                met[k] = listed = true;
                EXPECT_TRUE(unseen[k].elsewhere || !isSeen) << name << ": the layer sees it now, although \"" << unseen[k].reason << "\"";
            }
            EXPECT_TRUE(isSeen || listed) << name << ": nobody misses it";
            if (isSeen) seen = std::move(mutant);
        }
    for (size_t k = 0; k < unseen.size(); ++k)
        EXPECT_TRUE(met[k] || unseen[k].elsewhere) << "no such bit: " << unseen[k].shader << ", number " << unseen[k].number;
    EXPECT_GT(bits, 0u);
    if (unseen.size() == bits) return;  // listed, one by one: of this list the layer knows nothing
    ASSERT_TRUE(seen) << "not one barrier was missed: is synchronization validation on?";
    EXPECT_GT(messagesOfTwoFrames(*seen), 0u) << "the layer has fallen silent";
}

}  // namespace gno::test
