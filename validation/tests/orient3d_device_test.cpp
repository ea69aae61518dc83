// SPDX-License-Identifier: MIT
// core/orient3d.glsl on the device, with and without its filter, against the same text compiled as C++ (to the bit) and against __int128.
#include <gtest/gtest.h>

#include <cstring>

#include "host_min/vulkan/buffer.hpp"
#include "host_min/vulkan/pass.hpp"
#include "host_min/vulkan/recording.hpp"
#include "host_min/vulkan/shader.hpp"
#include "validation/support/device_test.hpp"
#include "validation/support/exact_reference.hpp"
#include "validation/support/glsl_as_cpp.hpp"
#include "validation/support/grid_questions.hpp"
#include "validation/support/spirv_file.hpp"

namespace gno {
#include "glsl/core/orient3d.glsl"
namespace {

using questions::Question;

// As in glsl/core/examples/orient3d.comp.
struct Asked {
    vec4 light, a, b, c, p;
};
struct Answer {
    int orient, facing, lateral;
    uint inShadow;
    vec4 normal;
    bool operator==(const Answer& other) const { return std::memcmp(this, &other, sizeof other) == 0; }
};
static_assert(sizeof(Asked) == 80 && sizeof(Answer) == 32);

constexpr uint32_t kPerFamily = 20000;
constexpr uint32_t kGroupSize = 64;

/// All families; half of the points lie behind the caster or on the edge of its volume.
std::vector<Question> makeQuestions() {
    std::vector<Question> all;
    questions::Random random(20160);
    for (const questions::Family& family : questions::kFamilies)
        for (uint32_t i = 0; i < kPerFamily; ++i) {
            Question q = family.make(random);
            if (random.below(2) == 0) {
                const double s = 0.5 * random.real() + 0.5, t = (0.5 * random.real() + 0.5) * (1 - s) * (random.below(4) == 0 ? 0 : 1),
                             k = 0.5 + random.real();
                const glm::dvec3 a(q.t.a), on = a + (glm::dvec3(q.t.b) - a) * s + (glm::dvec3(q.t.c) - a) * t, light(vec3(q.light));
                q.p = random.nudge(q.light.w != 0.0f ? on + (on - light) * k : on - light * k);
            }
            all.push_back(q);
        }
    return all;
}

const std::vector<Question>& allQuestions() {
    static const std::vector<Question> all = makeQuestions();
    return all;
}

std::vector<Answer> onDevice(std::span<const uint32_t> spirv, size_t answers) {
    const host::Device& device = test::passes().device();
    std::vector<Asked> asked;
    for (const Question& q : allQuestions()) asked.push_back({q.light, vec4(q.t.a, 0), vec4(q.t.b, 0), vec4(q.t.c, 0), vec4(q.p, 0)});
    host::Buffer in(device, asked.size() * sizeof(Asked)), out(device, answers * sizeof(Answer));
    in.upload(std::span<const Asked>(asked));
    out.fill(0xDEADBEEFu);
    const host::ComputePass pass(device, spirv);
    const std::array resources{host::Binding{"Questions", &in}, host::Binding{"Answers", &out}};
    host::Recording recording(device);
    recording.beginPass("orient3d");
    pass.dispatch(recording, resources, {}, (uint32_t(answers) + kGroupSize - 1) / kGroupSize);
    recording.endPass();
    recording.submit();
    return out.downloadAs<Answer>();
}

Answer onCpu(const Question& q) {
    return {gnoOrient3d(q.t.a, q.t.b, q.t.c, q.p), gnoFacing(q.light, q.t), gnoOrient3dLight(q.light, q.t.a, q.t.b, q.p),
            gnoInShadowOf(q.light, q.t, q.p) ? 1u : 0u, vec4(gnoExactNormal(q.t), 0.0f)};
}

void expectDeviceIsRight(std::span<const uint32_t> spirv) {
    const std::vector<Question>& all = allQuestions();
    ASSERT_GE(all.size(), 200000u);
    const std::vector<Answer> device = onDevice(spirv, all.size());
    ASSERT_EQ(device.size(), all.size());
    size_t inShadow = 0, zeros = 0;
    for (size_t i = 0; i < all.size(); ++i) {
        const Question& q = all[i];
        ASSERT_EQ(device[i], onCpu(q)) << "question " << i << "\n" << questions::show(q);
        const exact::Vec a = exact::fixed(q.t.a), b = exact::fixed(q.t.b), c = exact::fixed(q.t.c), p = exact::fixed(q.p);
        ASSERT_EQ(device[i].orient, exact::orient3d(a, b, c, p)) << questions::show(q);
        ASSERT_EQ(device[i].facing, exact::orient3dLight(q.light, a, b, c)) << questions::show(q);
        ASSERT_EQ(device[i].lateral, exact::orient3dLight(q.light, a, b, p)) << questions::show(q);
        ASSERT_EQ(device[i].inShadow != 0, exact::inShadowOf(q.light, a, b, c, p)) << questions::show(q);
        inShadow += device[i].inShadow;
        zeros += (device[i].orient == 0 ? 1u : 0u) + (device[i].lateral == 0 ? 1u : 0u);
    }
    EXPECT_GT(inShadow, all.size() / 20);
    EXPECT_LT(inShadow, all.size() / 2);
    EXPECT_GT(zeros, all.size() / 20) << "these questions are too easy";
}

TEST(Orient3dDevice, FilteredSignsAreTheCpusToTheBit) { expectDeviceIsRight(host::embeddedShader("core/examples/orient3d.comp")); }
TEST(Orient3dDevice, UnfilteredSignsAreTheCpusToTheBit) { expectDeviceIsRight(test::readSpirv(GNOMON_ORIENT3D_UNFILTERED)); }

/// The comparison reads what the device wrote: answers that were not asked for keep the poison, and the shader stays inside the shorter list.
TEST(Orient3dDevice, WritesNothingButItsAnswers) {
    const std::vector<Answer> few = onDevice(host::embeddedShader("core/examples/orient3d.comp"), 1000);
    ASSERT_EQ(few.size(), 1000u);
    for (size_t i = 0; i < few.size(); ++i) ASSERT_EQ(few[i], onCpu(allQuestions()[i]));
    const std::vector<Answer> more = onDevice(host::embeddedShader("core/examples/orient3d.comp"), allQuestions().size() + kGroupSize);
    Answer poison;
    std::memset(&poison, 0, sizeof poison);
    const uint32_t word = 0xDEADBEEFu;
    for (size_t i = 0; i < sizeof poison / 4; ++i) std::memcpy(reinterpret_cast<char*>(&poison) + 4 * i, &word, 4);
    for (size_t i = allQuestions().size(); i < more.size(); ++i) ASSERT_EQ(more[i], poison);
}

}  // namespace
}  // namespace gno
