// SPDX-License-Identifier: MIT
// Are the barriers of a pass list enough, and is none of them too much? Two whole frames are recorded into one command buffer, with the list's
// barriers and no others, under synchronization validation: no message. Without any one bit of any pass's `before` there has to be a message.
#pragma once
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "host_min/frame/inputs.hpp"
#include "host_min/frame/pass_runner.hpp"
#include "validation/support/device_test.hpp"

namespace gno::test {

/// Passes of a device whose messages are asked for; that of passes() must have none. Validation layer on, without a limit of repeated messages.
host::PassCache& talkingPasses();

/// A small scene of that device: what passes bind besides their technique's arrays.
class SmallFrame {
public:
    explicit SmallFrame(bool directional);
    SmallFrame(const SmallFrame&) = delete;
    SmallFrame& operator=(const SmallFrame&) = delete;

    [[nodiscard]] const host::FrameInputs& inputs() const { return *inputs_; }
    /// Casters, states, samples and an image for the answer, behind `others`.
    [[nodiscard]] std::vector<host::Binding> with(std::vector<host::Binding> others) const;

private:
    Scene scene_;
    host::Frame frame_;
    std::optional<host::FrameInputs> inputs_;
    std::optional<host::Image> visibility_;
};

/// Everything that a frame of one technique records: build and query.
struct WholeFrame {
    PassList passes;
    std::vector<host::Binding> resources;  ///< of talkingPasses().device()
    host::ExamplePush push{};
    host::PassRunnerOptions options{};
};

inline constexpr uint32_t kAnyNumber = 0xFFFFFFFFu;

/// A bit of Pass::before that synchronization validation does not miss when it is not there.
struct UnseenBarrier {
    std::string_view shader;
    uint32_t number;  ///< Pass::number, or kAnyNumber: of all passes of this shader
    Before bit;
    std::string_view reason;  ///< why the bit is right all the same
    bool elsewhere = false;   ///< in other lists, or at other passes of this shader, it is seen, or there is no such pass
};

/// How many messages two frames of this list bring; they are recorded and not run.
uint64_t messagesOfTwoFrames(const WholeFrame& frame);

/// EXPECTs what stands above. An entry of `unseen` that fits no bit, or one that is seen, is a failure, too.
void expectExactBarriers(const WholeFrame& frame, std::span<const UnseenBarrier> unseen = {});

}  // namespace gno::test
