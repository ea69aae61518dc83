// SPDX-License-Identifier: MIT
// core/sample.glsl on the device: snapping is the host's to the bit, view samples lie strictly on the lit side of their own plane (exact signs).
#include <gtest/gtest.h>

#include <cmath>

#include "host_min/scene/grid.hpp"
#include "host_min/vulkan/buffer.hpp"
#include "host_min/vulkan/pass.hpp"
#include "host_min/vulkan/recording.hpp"
#include "validation/support/device_test.hpp"
#include "validation/support/exact_reference.hpp"
#include "validation/support/grid_questions.hpp"
#include "validation/support/spirv_file.hpp"

namespace gno {
namespace {

// As in validation/drop_in/core_sample_list.comp.
struct Question {
    vec4 p, a, b, c, viewer, light;
};
struct Answer {
    vec4 snapped;
    uvec4 texel;
};

std::vector<Answer> onDevice(const std::vector<Question>& questions) {
    const host::Device& device = test::passes().device();
    host::Buffer in(device, questions.size() * sizeof(Question)), out(device, questions.size() * sizeof(Answer));
    in.upload(std::span<const Question>(questions));
    out.fill(0xDEADBEEFu);
    const host::ComputePass pass(device, test::readSpirv(GNOMON_SAMPLE_SPIRV));
    const std::array resources{host::Binding{"questions", &in}, host::Binding{"answers", &out}};
    host::Recording recording(device);
    recording.beginPass("samples");
    pass.dispatch(recording, resources, {}, uint32_t(questions.size() + 63) / 64);
    recording.endPass();
    recording.submit();
    return out.downloadAs<Answer>();
}

TEST(SampleDevice, SnapsAsTheHostDoes) {
    questions::Random r(11);
    std::vector<Question> all;
    const auto coordinate = [&](int i) {
        if (i % 4 == 0) return float(std::ldexp(0.5 + r.below(4096), -40)) * (r.below(2) == 0 ? 1.0f : -1.0f);  // half-way between two grid points
        if (i % 4 == 1) return float(r.real() * 0x1p-16);                                                       // where grid and fp32 steps meet
        return float(std::ldexp(r.real(), -r.below(48)));
    };
    for (int i = 0; i < 100000; ++i) all.push_back({vec4(coordinate(i), coordinate(i), coordinate(i), 0), {}, {}, {}, {}, vec4(0, 0, 1, 0)});
    const std::vector<Answer> got = onDevice(all);
    ASSERT_EQ(got.size(), all.size());
    for (size_t i = 0; i < all.size(); ++i)
        for (int k = 0; k < 3; ++k) {
            const float want = host::snapCoordinate(double(all[i].p[k]));
            ASSERT_EQ(got[i].snapped[k], want) << std::hexfloat << all[i].p[k];
            ASSERT_EQ(std::signbit(got[i].snapped[k]), std::signbit(want)) << std::hexfloat << all[i].p[k];
        }
}

TEST(SampleDevice, ViewSamplesLieOffTheirOwnPlane) {
    questions::Random r(12);
    std::vector<Question> all;
    for (const questions::Family& family : questions::kFamilies)
        for (int i = 0; i < 5000; ++i) {
            const questions::Question q = family.make(r);
            const double u = 0.5 * r.real() + 0.5, v = (1 - u) * (0.5 * r.real() + 0.5);
            const vec3 largest = max(abs(q.t.a), max(abs(q.t.b), abs(q.t.c)));
            const double off = 4 * 0x1p-23 * double(std::max(largest.x, std::max(largest.y, largest.z)));
            const glm::dvec3 a(q.t.a),
                p = a + (glm::dvec3(q.t.b) - a) * u + (glm::dvec3(q.t.c) - a) * v + off * glm::dvec3(r.real(), r.real(), r.real());
            all.push_back({vec4(glm::clamp(p, -1.4, 1.4), 0), vec4(q.t.a, 0), vec4(q.t.b, 0), vec4(q.t.c, 0), vec4(r.uniform(), 1), q.light});
        }
    const std::vector<Answer> got = onDevice(all);
    ASSERT_EQ(got.size(), all.size());
    size_t made = 0;
    for (size_t i = 0; i < all.size(); ++i) {
        const Question& q = all[i];
        const questions::Question show{q.light, {vec3(q.a), vec3(q.b), vec3(q.c)}, vec3(q.p)};
        if (got[i].texel.w == GNO_FACING_AWAY) continue;
        ++made;
        ASSERT_EQ(got[i].texel.w, i) << questions::show(show);
        const vec3 moved(std::bit_cast<float>(got[i].texel.x), std::bit_cast<float>(got[i].texel.y), std::bit_cast<float>(got[i].texel.z));
        const exact::Vec a = exact::fixed(show.t.a), b = exact::fixed(show.t.b), c = exact::fixed(show.t.c), p = exact::fixed(moved);
        const int side = exact::orient3d(a, b, c, p);
        ASSERT_NE(side, 0) << questions::show(show);
        ASSERT_EQ(side, -exact::orient3dLight(q.light, a, b, c)) << "not on the light's side\n" << questions::show(show);
        ASSERT_FALSE(exact::inShadowOf(q.light, a, b, c, p)) << questions::show(show);
    }
    EXPECT_GT(made, all.size() / 4);
    EXPECT_LT(made, all.size() * 3 / 4);
}

}  // namespace
}  // namespace gno
