// SPDX-License-Identifier: MIT
// What a query says of a structure that is not there to ask: nothing was built, a pass was left out, it was built for another rung, by another
// version, or into a pool that was too small. Every sample has the answer GNO_VISIBILITY_UNKNOWN, or the right one, and the query ends.
// Memory is filled with several words before, and once with what the frame before left.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "glsl/core/state.h"
#include "glsl/top/node.h"
#include "glsl/top/passes.hpp"
#include "host_min/techniques/array_buffers.hpp"
#include "validation/tests/made_scenes.hpp"

namespace gno {
namespace {

using Mask = std::vector<uint32_t>;
constexpr std::array kFills{0u, 0xDEADBEEFu, 0xFFFFFFFFu};
constexpr uint32_t kSeed = 7;

/// One structure and the ways to ask it.
struct Family {
    std::string name;
    ArrayList arrays;
    PassList build;
    std::vector<PassList> queries;
    std::string_view header;               ///< the array that holds the word of core/state.h,
    uint64_t state = 0;                    ///< at this offset
    std::vector<std::string_view> silent;  ///< passes whose absence does no harm, or leaves less work for the query: every answer is right
};

Family top(uint32_t casters, uint32_t precision) {
    Family family{"top", topArrays(casters), topBuildPasses(casters, {.precision = precision, .seed = kSeed}),
                  {},    "gnoTopHeader",     offsetof(GnoTopHeader, state),
                  {}};
    for (const TopQuery query : {TopQuery::stack, TopQuery::stackless, TopQuery::hybrid})
        for (const uint32_t stack : {12u, 1u})
            if (query != TopQuery::stackless || stack == 12)
                family.queries.push_back(topQueryPasses(64, 8, {.query = query, .precision = precision, .stack = stack}));
    return family;
}

/// A scene, a family's arrays, and what is done with them.
class Stage {
public:
    Stage(const test::Scene& scene, const Family& family)
        : scene_(scene), frame_(test::frameOf(scene_)), inputs_(test::passes(), frame_, scene_.samples, scene_.width), family_(family) {
        inputs_.setLight(scene_.light, scene_.cull);
        for (const Array& array : family_.arrays) {
            buffers_.emplace_back(array.name, host::Buffer(inputs_.device(), array.bytes, vk::BufferUsageFlags(bufferUsage(array.usage))));
            buffers_.back().second.fill(0);
        }
    }
    void fill(uint32_t word) {
        for (auto& [name, buffer] : buffers_) buffer.fill(word);
    }
    void run(const PassList& list) {
        const host::PassRunner runner(inputs_.passes(), list, resources());
        host::Recording recording(inputs_.device());
        runner.recordBare(recording, inputs_.push(kSeed));
        recording.submit();
    }
    [[nodiscard]] Mask ask(const PassList& query) {
        host::Image visibility(inputs_.device(), inputs_.width(), inputs_.height(), vk::Format::eR32Uint);
        visibility.clear(vk::ClearColorValue(77u, 77u, 77u, 77u));
        std::vector<host::Binding> all = resources();
        all.push_back({"gnoVisibility", &visibility});
        const host::PassRunner runner(inputs_.passes(), query, all);
        host::Recording recording(inputs_.device());
        runner.recordBare(recording, inputs_.push(kSeed));
        recording.submit();
        Mask mask = visibility.downloadAs<uint32_t>();
        mask.resize(scene_.samples.size());
        return mask;
    }
    [[nodiscard]] host::Buffer& operator[](std::string_view name) {
        for (auto& [own, buffer] : buffers_)
            if (own == name) return buffer;
        throw std::out_of_range("no array of this name");
    }
    [[nodiscard]] const Mask& right() {  ///< by the definition
        if (right_.empty())
            for (const uint8_t dark : test::ask(scene_).inShadow) right_.push_back(dark != 0 ? GNO_VISIBILITY_SHADOW : GNO_VISIBILITY_LIT);
        return right_;
    }

private:
    [[nodiscard]] std::vector<host::Binding> resources() const {
        std::vector<host::Binding> all;
        for (const auto& [name, buffer] : buffers_) all.push_back({name, &buffer});
        return inputs_.withCasters(all);
    }
    test::Scene scene_;
    host::Frame frame_;
    host::FrameInputs inputs_;
    Family family_;
    std::vector<std::pair<std::string_view, host::Buffer>> buffers_;
    Mask right_;
};

constexpr uint32_t kCasters = 300;
test::Scene scene(bool directional, uint32_t seed = 11) { return test::soup(seed, directional, kCasters, 0.25, 500); }

void expectUnknown(Stage& stage, const Family& family, const std::string& what) {
    for (const PassList& query : family.queries) {
        const Mask mask = stage.ask(query);
        EXPECT_EQ(std::count(mask.begin(), mask.end(), GNO_VISIBILITY_UNKNOWN), std::ssize(mask)) << family.name << ", " << what;
    }
}

void expectUnknownOrRight(Stage& stage, const Family& family, const std::string& what) {
    for (const PassList& query : family.queries) {
        const Mask mask = stage.ask(query);
        size_t wrong = 0;
        for (size_t i = 0; i < mask.size(); ++i) wrong += mask[i] != GNO_VISIBILITY_UNKNOWN && mask[i] != stage.right()[i];
        EXPECT_EQ(wrong, 0u) << family.name << ", " << what;
    }
}

void expectRight(Stage& stage, const Family& family, const std::string& what) {
    for (const PassList& query : family.queries) EXPECT_EQ(stage.ask(query), stage.right()) << family.name << ", " << what;
}

std::vector<Family> families(uint32_t precision) { return {top(kCasters, precision)}; }

class Answers : public testing::TestWithParam<bool> {};

TEST_P(Answers, AreRightWhenAllIsDone) {
    for (const uint32_t precision : {GNO_PRECISION_CONSERVATIVE, GNO_PRECISION_CERTIFIED})
        for (const Family& family : families(precision)) {
            Stage stage(scene(GetParam()), family);
            for (const uint32_t word : kFills) {
                stage.fill(word);
                stage.run(family.build);
                expectRight(stage, family, fmt::format("memory {:x}", word));
            }
            stage.run(family.build);
            expectRight(stage, family, "a second frame");
            const std::vector<uint32_t> header = stage[family.header].downloadAs<uint32_t>();
            const uint32_t state = header[family.state / 4];
            EXPECT_TRUE(state == gnoState(precision) || state == gnoState(GNO_STATE_ANY)) << family.name;
        }
}

TEST_P(Answers, OfMemoryThatNobodyWrote) {
    for (const Family& family : families(GNO_PRECISION_CERTIFIED)) {
        Stage stage(scene(GetParam()), family);
        for (const uint32_t word : {0u, 0xDEADBEEFu, 0xFFFFFFFFu, 0x7F7F7F7Fu, 1u}) {
            stage.fill(word);
            expectUnknown(stage, family, fmt::format("memory {:x}", word));
        }
    }
}

// One pass is forgotten: in the first frame, and in a later one, when all arrays hold what the frame before has built.
TEST_P(Answers, WithoutOnePass) {
    for (const Family& family : families(GNO_PRECISION_CERTIFIED)) {
        Stage stage(scene(GetParam()), family);
        for (size_t left = 0; left < family.build.size(); ++left) {
            PassList list = family.build;
            list.erase(list.begin() + std::ptrdiff_t(left));
            const bool silent = std::find(family.silent.begin(), family.silent.end(), family.build[left].shader) != family.silent.end();
            const std::string what = fmt::format("without pass {}, {}", left, family.build[left].shader);
            for (const uint32_t word : kFills) {
                stage.fill(word);
                stage.run(list);
                (silent ? expectRight : expectUnknown)(stage, family, fmt::format("{}, memory {:x}", what, word));
            }
            stage.fill(0);
            stage.run(family.build);
            stage.run(list);
            expectUnknownOrRight(stage, family, what + ", a later frame");
        }
    }
}

// Only the work groups of half of the casters: a size that the host and the shader do not agree on.
TEST_P(Answers, WithTooFewWorkGroups) {
    for (const Family& family : families(GNO_PRECISION_CERTIFIED)) {
        Stage stage(scene(GetParam()), family);
        for (size_t pass = 0; pass < family.build.size(); ++pass) {
            PassList list = family.build;
            if (list[pass].groups[0] < 2 || !list[pass].indirect.empty() || list[pass].shader.find("set_up") != std::string_view::npos) continue;
            list[pass].groups[0] /= 2;
            for (const uint32_t word : kFills) {
                stage.fill(word);
                stage.run(list);
                expectUnknown(stage, family, fmt::format("half of {}", list[pass].shader));
            }
        }
    }
}

PassList withPrecision(PassList list, uint32_t precision) {
    for (Pass& pass : list) {
        Few<Constant, 8> constants;
        for (const Constant& constant : pass.constants)
            constants.push_back({constant.name, constant.name == "kPrecision" ? precision : constant.value});
        pass.constants = constants;
    }
    return list;
}

bool hasPrecision(const PassList& list) {
    return std::any_of(list.begin(), list.end(), [](const Pass& pass) {
        return std::any_of(pass.constants.begin(), pass.constants.end(), [](const Constant& constant) { return constant.name == "kPrecision"; });
    });
}

// The query, or one of the build's passes, is made for another rung than the rest.
TEST_P(Answers, OfAnotherPrecision) {
    for (const uint32_t precision : {GNO_PRECISION_PUBLISHED, GNO_PRECISION_CONSERVATIVE, GNO_PRECISION_CERTIFIED})
        for (const Family& family : families(precision)) {
            if (!hasPrecision(family.build)) continue;  // a structure for every rung
            const uint32_t other = precision == GNO_PRECISION_CERTIFIED ? GNO_PRECISION_CONSERVATIVE : GNO_PRECISION_CERTIFIED;
            Stage stage(scene(GetParam()), family);
            stage.run(family.build);
            Family asked = family;
            for (PassList& query : asked.queries) query = withPrecision(query, other);
            if (hasPrecision(asked.queries.front())) expectUnknown(stage, asked, "the query");
            for (size_t pass = 0; pass < family.build.size(); ++pass) {
                if (!hasPrecision({family.build[pass]})) continue;
                PassList list = family.build;
                list[pass] = withPrecision({list[pass]}, other).front();
                stage.run(list);
                expectUnknown(stage, family, std::string(list[pass].shader));
            }
        }
}

TEST_P(Answers, OfAnotherVersion) {
    for (const Family& family : families(GNO_PRECISION_CERTIFIED)) {
        Stage stage(scene(GetParam()), family);
        stage.run(family.build);
        std::vector<uint32_t> header = stage[family.header].downloadAs<uint32_t>();
        const uint32_t state = header.at(family.state / 4);
        for (const uint32_t changed : {state + (1u << 4), state + (1u << 10), state ^ (3u << 2), state ^ (1u << 16)}) {
            header[family.state / 4] = changed;
            stage[family.header].upload(std::span<const uint32_t>(header));
            expectUnknown(stage, family, fmt::format("{:x} for {:x}", changed, state));
        }
        header[family.state / 4] = state;
        stage[family.header].upload(std::span<const uint32_t>(header));
        expectRight(stage, family, "the word as it was");
    }
}

INSTANTIATE_TEST_SUITE_P(, Answers, testing::Bool(),
                         [](const testing::TestParamInfo<bool>& given) { return given.param ? "Directional" : "Point"; });

// No word of one kind is one of another, and none of them is what memory is usually filled with.
TEST(State, WordsDiffer) {
    std::vector<uint32_t> words{0u, 0xFFFFFFFFu, 0xDEADBEEFu, 0xCDCDCDCDu, 0x7F7F7F7Fu};
    for (const uint32_t precision : {GNO_PRECISION_PUBLISHED, GNO_PRECISION_CONSERVATIVE, GNO_PRECISION_CERTIFIED, GNO_STATE_ANY})
        words.insert(words.end(), {gnoState(precision), gnoIncompleteState(precision)});
    std::sort(words.begin(), words.end());
    EXPECT_EQ(std::adjacent_find(words.begin(), words.end()), words.end());
    EXPECT_EQ(gnoState(0) >> 16, 0x474Eu);
    EXPECT_EQ(gnoState(0) >> 4 & 0xFFFu, uint32_t(GNO_VERSION_MAJOR) * 64 + GNO_VERSION_MINOR);
}

}  // namespace
}  // namespace gno
