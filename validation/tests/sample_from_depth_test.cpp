// SPDX-License-Identifier: MIT
// View samples of depth and normal alone (core/sample_from_depth.glsl) have the answers of those with a primitive id: shipped scenes, point and
// directional light, D32 and D24. Lines say what differs and what it costs in nodes; GNOMON_FROM_DEPTH=WxH,SCENE... asks other pictures.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "host_min/scene/scene.hpp"
#include "validation/support/device_test.hpp"
#include "validation/support/glsl_as_cpp.hpp"

namespace gno {
#include "glsl/core/orient3d.glsl"
}
#include "glsl/core/sample_from_depth.glsl"

namespace gno {
namespace {

using host::OracleSample;
using Samples = std::vector<OracleSample>;

enum class DepthFormat { d32, d24 };

struct Unprojection {  // std140, as in core/examples/view_samples_from_depth.comp
    glm::mat4 gridFromClip;
    float depthStep, subPixels;
    float unused[2];
};

/// What a depth buffer of this format holds, 1 / 0 at the ends.
std::vector<float> depthsOf(const host::FrameInputs& drawn, DepthFormat format) {
    std::vector<float> depths = drawn.depth().downloadAs<float>();
    if (format == DepthFormat::d24)
        for (float& depth : depths) depth = float(std::nearbyint(double(depth) * 16777215.0) / 16777215.0);
    return depths;
}

/// The samples of the drawn picture, made by the example shader from depth and normal.
Samples samplesFromDepth(const host::FrameInputs& drawn, glm::vec4 light, DepthFormat format) {
    const host::Device& device = drawn.device();
    host::Image depths(device, drawn.width(), drawn.height(), vk::Format::eR32Sfloat);
    host::Image samples(device, drawn.width(), drawn.height(), vk::Format::eR32G32B32A32Uint);
    depths.clear(vk::ClearColorValue(0.f, 0.f, 0.f, 0.f));
    samples.clear(vk::ClearColorValue(77u, 77u, 77u, 77u));
    depths.upload(std::as_bytes(std::span<const float>(depthsOf(drawn, format))));
    const Unprojection unprojection{glm::mat4(glm::inverse(drawn.clipFromGrid())),
                                    format == DepthFormat::d24 ? GNO_DEPTH_STEP_D24 : GNO_DEPTH_STEP_D32,
                                    256,  // lavapipe's subPixelPrecisionBits are 8
                                    {}};
    host::Buffer block(device, sizeof unprojection, vk::BufferUsageFlagBits::eUniformBuffer);
    block.upload(std::span(&unprojection, 1));
    host::ExamplePush push = drawn.push();
    push.light = light;
    const std::array resources{host::Binding{"gnoDepths", &depths}, host::Binding{"gnoNormals", &drawn.normals()},
                               host::Binding{"gnoUnprojection", &block}, host::Binding{"gnoSamples", &samples}};
    host::Recording recording(device);
    test::passes()
        .compute("core/examples/view_samples_from_depth.comp")
        .dispatch(recording, resources, std::as_bytes(std::span(&push, 1)), (drawn.width() + 7) / 8, (drawn.height() + 7) / 8);
    recording.submit();
    Samples result;
    for (const glm::uvec4& t : samples.downloadAs<glm::uvec4>())
        result.push_back({{std::bit_cast<float>(t.x), std::bit_cast<float>(t.y), std::bit_cast<float>(t.z)}, t.w});
    return result;
}

struct Picture {
    std::vector<uint32_t> visibility;
    uint64_t visited = 0, exact = 0;
};

Picture ask(const host::FrameInputs& inputs, const std::string& technique, host::Precision precision) {
    host::StructureCache structures;
    host::Technique& asked = host::techniqueByName(technique);
    const host::TechniqueResult result =
        asked.run(inputs, structures, host::Settings(asked.info().settings, std::vector<std::string>()), {.precision = precision, .warmUp = false});
    return {result.visibility, result.counters.visitedNodes, result.counters.exactCalls};
}

Picture ask(const host::Frame& frame, const Samples& samples, uint32_t width, glm::vec4 light, const std::string& technique,
            host::Precision precision) {
    host::FrameInputs inputs(test::passes(), frame, samples, width);
    inputs.setLight(light, host::Cull::none);
    return ask(inputs, technique, precision);
}

struct Difference {
    size_t samples = 0;  ///< with an id
    size_t answers = 0;  ///< of these: another answer
    size_t facing = 0;   ///< pixels that only one of both takes for a view sample
};

Difference differenceOf(const Picture& withId, const Picture& without) {
    Difference result;
    const auto isSample = [](uint32_t visibility) { return visibility == GNO_VISIBILITY_LIT || visibility == GNO_VISIBILITY_SHADOW; };
    for (size_t i = 0; i < withId.visibility.size(); ++i) {
        const uint32_t one = withId.visibility[i], other = without.visibility[i];
        result.samples += isSample(one);
        if (isSample(one) != isSample(other))
            ++result.facing;
        else
            result.answers += one != other;
    }
    return result;
}

struct Question {
    uint32_t width = 200, height = 150;
    std::vector<std::string> scenes{"fence/fence.glb", "crib/crib.glb", "spiral_staircase/spiral_staircase.glb"};
};

Question question() {
    Question asked;
    const char* text = std::getenv("GNOMON_FROM_DEPTH");
    if (!text) return asked;
    std::istringstream words(text);
    char x = 0;
    words >> asked.width >> x >> asked.height;
    asked.scenes.clear();
    while (words.get() == ',') {
        std::string scene;
        while (words.peek() != ',' && words.peek() != EOF) scene += char(words.get());
        asked.scenes.push_back(scene);
    }
    return asked;
}

template <class What>
void eachPicture(const What& what) {
    const Question asked = question();
    for (const std::string& scene : asked.scenes) {
        const host::SceneFile file = host::SceneFile::load(std::filesystem::path(GNOMON_SCENES_DIR) / scene);
        const host::Frame frame = file.evaluate(0, 0);
        host::FrameInputs drawn(test::passes(), frame, asked.width, asked.height);
        for (const size_t light : {0u, 1u}) {
            SCOPED_TRACE(fmt::format("{}, light {}", scene, light));
            drawn.setLight(frame.lights.at(light).homogeneous, host::Cull::none);
            what(fmt::format("{} light {}", scene, light), frame, drawn);
        }
    }
}

// At the same places, none differs from the run with ids: a sample's own caster never darkens it. At the places of the run with ids a few per mille
// do: a boundary of a shadow runs between the two places, which lie up to three errors of the depth buffer apart.
TEST(SampleFromDepth, AnswersAsWithAnId) {
    eachPicture([](const std::string& name, const host::Frame& frame, const host::FrameInputs& drawn) {
        const Picture withId = ask(drawn, "d-hybrid", host::Precision::certified);
        for (const DepthFormat format : {DepthFormat::d32, DepthFormat::d24}) {
            const Samples samples = samplesFromDepth(drawn, drawn.light(), format);
            const Picture without = ask(frame, samples, drawn.width(), drawn.light(), "d-hybrid", host::Precision::certified);
            Samples named = samples;
            for (size_t i = 0; i < named.size(); ++i)
                if (named[i].own == GNO_NO_CASTER) named[i].own = drawn.pixels()[i].own;
            const Picture samePlaces = ask(frame, named, drawn.width(), drawn.light(), "d-hybrid", host::Precision::certified);
            EXPECT_EQ(differenceOf(samePlaces, without).answers, 0u);
            EXPECT_EQ(differenceOf(samePlaces, without).facing, 0u);
            const Difference difference = differenceOf(withId, without);
            EXPECT_GT(difference.samples, 500u);
            EXPECT_LE(difference.answers, difference.samples / 250);
            EXPECT_EQ(difference.facing, 0u);
            fmt::print("{} {}: {} samples, {} answers and {} facings differ; nodes a sample {:.2f} for {:.2f}, exact calls {:.3f} for {:.3f}\n",
                       name, format == DepthFormat::d24 ? "D24" : "D32", difference.samples, difference.answers, difference.facing,
                       double(without.visited) / double(difference.samples), double(withId.visited) / double(difference.samples),
                       double(without.exact) / double(difference.samples), double(withId.exact) / double(difference.samples));
        }
    });
}

// The bound holds: each sample lies strictly in front of the plane of the caster that was drawn, and no farther from it than three errors. Without
// being moved a good part of them would be dark.
TEST(SampleFromDepth, LiesInFrontOfItsOwnCaster) {
    eachPicture([](const std::string&, const host::Frame& frame, const host::FrameInputs& drawn) {
        const std::vector<uint32_t> primitives = drawn.primitives().downloadAs<uint32_t>();
        for (const DepthFormat format : {DepthFormat::d32, DepthFormat::d24}) {
            const Samples samples = samplesFromDepth(drawn, drawn.light(), format);
            size_t behind = 0, far = 0, asked = 0;
            for (size_t i = 0; i < samples.size(); ++i) {
                if (samples[i].own != GNO_NO_CASTER || drawn.pixels()[i].own > GNO_NO_CASTER) continue;
                const host::Triangle& t = frame.triangles[primitives[i]];
                const glm::dvec3 a(t.a), n = glm::normalize(glm::cross(glm::dvec3(t.b) - a, glm::dvec3(t.c) - a));
                const double side = glm::dot(n, glm::dvec3(samples[i].position) - a),
                             light = glm::dot(n, glm::dvec3(drawn.light()) - a * double(drawn.light().w));
                ++asked;
                behind += side * light <= 0;
                far += std::abs(side) > 2e-4;
            }
            EXPECT_GT(asked, 500u);
            EXPECT_EQ(behind, 0u);
            EXPECT_EQ(far, 0u);
        }
    });
}

// What the module is for: positions of the depth buffer as they are, and no id.
TEST(SampleFromDepth, UnmovedSamplesDarkenThemselves) {
    eachPicture([](const std::string&, const host::Frame& frame, const host::FrameInputs& drawn) {
        const Picture withId = ask(drawn, "d-hybrid", host::Precision::certified);
        Samples samples = drawn.pixels();
        const std::vector<glm::vec4> positions = drawn.positions().downloadAs<glm::vec4>();
        for (size_t i = 0; i < samples.size(); ++i)
            if (samples[i].own <= GNO_NO_CASTER) samples[i] = {gnoSnapToGrid(glm::vec3(positions[i])), GNO_NO_CASTER};
        const Difference difference =
            differenceOf(withId, ask(frame, samples, drawn.width(), drawn.light(), "d-hybrid", host::Precision::certified));
        EXPECT_GT(difference.answers, difference.samples / 20);
    });
}

// Every technique that is exact answers these samples alike, on every rung that it has.
TEST(SampleFromDepth, EveryTechniqueCanBeAsked) {
    const host::SceneFile file = host::SceneFile::load(std::filesystem::path(GNOMON_SCENES_DIR) / "fence/fence.glb");
    const host::Frame frame = file.evaluate(0, 0);
    host::FrameInputs drawn(test::passes(), frame, 96, 64);
    drawn.setLight(frame.lights.at(0).homogeneous, host::Cull::none);
    const Samples samples = samplesFromDepth(drawn, drawn.light(), DepthFormat::d32);
    const Picture want = ask(frame, samples, drawn.width(), drawn.light(), "d-hybrid", host::Precision::certified);
    for (const auto precision : {host::Precision::conservative, host::Precision::certified})
        for (const char* technique : {"psv", "d-stackless", "forest", "light-grid", "light-bvh", "ptsv"})
            EXPECT_EQ(differenceOf(want, ask(frame, samples, drawn.width(), drawn.light(), technique, precision)).answers, 0u) << technique;
}

}  // namespace
}  // namespace gno
