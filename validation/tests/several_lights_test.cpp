// SPDX-License-Identifier: MIT
// Several lights in one shader: structures of two point lights and a directional one lie one behind the other in the same buffers, and a shader of
// validation/drop_in asks them in turn. Its answers are those of three single runs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "glsl/forest/cells.h"
#include "glsl/rivals/light_bvh.h"
#include "glsl/rivals/light_grid.h"
#include "glsl/top/node.h"
#include "glsl/top/passes.hpp"
#include "host_min/frame/pass_runner.hpp"
#include "host_min/scene/scene.hpp"
#include "host_min/techniques/technique.hpp"
#include "validation/support/device_test.hpp"
#include "validation/support/spirv_file.hpp"

namespace gno {
namespace {

using host::Binding;
using host::Buffer;

constexpr uint32_t kPoison = 0xDEADBEEFu;
constexpr uint64_t kAlign = 256;  // as many elements: the bytes are a multiple of any minStorageBufferOffsetAlignment then

/// An array of a structure, and the word of the shader's Light that says where a light's part of it begins.
struct ArrayPart {
    const char* name;
    size_t elementBytes;
    size_t word;
};

struct Kind {
    const char* technique;
    std::vector<std::string> settings;
    const char* spirv;
    const char* grid;  ///< the uniform buffer that each light's struct holds a copy of; null: none
    std::vector<ArrayPart> parts;
    size_t words;  ///< of Light, after place and grid
    friend void PrintTo(const Kind& kind, std::ostream* stream) { *stream << kind.technique; }
};

const std::vector<Kind>& kinds() {
    static const std::vector<Kind> all{
        {"d-hybrid",
         {},
         GNOMON_SEVERAL_TREES,
         nullptr,
         {{"gnoTopPlanes", 16, 0}, {"gnoTopLinks", 16, 0}, {"gnoTopHeader", sizeof(GnoTopHeader), 1}},
         4},
        {"forest",
         {"cells=16"},
         GNOMON_SEVERAL_FORESTS,
         "gnoForestGrid",
         {{"gnoTopPlanes", 16, 0},
          {"gnoTopLinks", 16, 0},
          {"gnoTopHeader", sizeof(GnoTopHeader), 1},
          {"gnoForestCells", sizeof(GnoForestCell), 2},
          {"gnoForestPairs", sizeof(GnoForestPair), 3}},
         4},
        {"light-grid",
         {"cells=16"},
         GNOMON_SEVERAL_LISTS,
         "gnoForestGrid",
         {{"gnoGridLists", sizeof(GnoLightGridList), 0},
          {"gnoGridItems", sizeof(GnoLightGridItem), 1},
          {"gnoGridHeader", sizeof(GnoLightGridHeader), 2},
          {"gnoGridPlanes", 16, 3}},
         4},
        {"light-bvh",
         {},
         GNOMON_SEVERAL_HIERARCHIES,
         "gnoLightBvhGrid",
         {{"gnoLightBvhNode", sizeof(GnoLightBvhNode), 0}, {"gnoLightBvhParents", 4, 0}, {"gnoLightBvhHeader", sizeof(GnoLightBvhHeader), 1}},
         4},
    };
    return all;
}

/// The struct Light of the shader: place, grid where there is one, words.
struct Light {
    glm::vec4 place;
    std::vector<std::byte> grid;
    std::vector<uint32_t> words;
};

void append(std::vector<std::byte>& bytes, const void* data, size_t size) {
    const auto* first = static_cast<const std::byte*>(data);
    bytes.insert(bytes.end(), first, first + size);
}

class SeveralLights : public testing::TestWithParam<Kind> {
protected:
    SeveralLights()
        : frame_(host::SceneFile::load(GNOMON_SOURCE_DIR "/scenes/show_stairs.glb").evaluate(0, 0)),
          inputs_(test::passes(), frame_, kWidth, kHeight) {
        for (const host::Light& light : frame_.lights) {
            if (light.homogeneous.w == 1 && points() == 0) lights_.push_back(light.homogeneous);
            if (light.homogeneous.w == 0 && points() == lights_.size()) lights_.push_back(light.homogeneous);
        }
        const auto point = std::find_if(lights_.begin(), lights_.end(), [](const glm::vec4& l) { return l.w == 1; });
        if (point == lights_.end() || lights_.size() != 2) throw std::runtime_error("the scene has no point light or no directional one");
        const glm::vec3 middle = frame_.low + frame_.high;  // twice; the third light stands on the other side of it
        lights_.insert(lights_.begin(), glm::vec4(middle.x - point->x, point->y, middle.z - point->z, 1));
    }

    [[nodiscard]] size_t points() const {
        return size_t(std::count_if(lights_.begin(), lights_.end(), [](const glm::vec4& l) { return l.w == 1; }));
    }

    /// One run of a technique for each light, and the structures' arrays, moved behind each other into buffers that all lights share.
    void runSingly(const Kind& kind) {
        host::Technique& technique = host::techniqueByName(kind.technique);
        const host::Settings settings(technique.info().settings, kind.settings);
        const host::RunOptions options{.counters = false, .warmUp = false};
        std::vector<uint64_t> next(kind.words, kAlign);  // no light's part begins at 0
        for (const glm::vec4& place : lights_) {
            inputs_.setLight(place, host::Cull::none);
            host::StructureCache cache;
            single_.push_back(technique.run(inputs_, cache, settings, options).visibility);
            const auto structure = technique.makeStructure(inputs_, settings, options);
            build(*structure, inputs_, {.warmUp = false, .counters = false});
            Light light{place, {}, std::vector<uint32_t>(next.begin(), next.end())};
            std::vector<uint64_t> end = next;
            for (const Binding& bound : technique.query(*structure, inputs_, settings, options).resources) {
                const auto* buffer = std::get_if<const Buffer*>(&bound.resource);
                if (!buffer) continue;
                if (kind.grid && bound.name == kind.grid) {
                    light.grid = (*buffer)->download();
                    light.grid.resize(sizeof(GnoForestGrid));
                }
                for (const ArrayPart& part : kind.parts) {
                    if (bound.name != part.name) continue;
                    std::vector<std::byte> bytes = (*buffer)->download();
                    bytes.resize(bytes.size() / part.elementBytes * part.elementBytes);
                    std::vector<std::byte>& all = arrays_[part.name];
                    const size_t from = next[part.word] * part.elementBytes;
                    while (all.size() < from) append(all, &kPoison, 4);
                    append(all, bytes.data(), bytes.size());
                    const uint64_t elements = next[part.word] + bytes.size() / part.elementBytes;
                    end[part.word] = std::max(end[part.word], (elements + kAlign - 1) / kAlign * kAlign);
                }
            }
            EXPECT_EQ(arrays_.size(), kind.parts.size());
            EXPECT_EQ(light.grid.empty(), kind.grid == nullptr);
            next = end;
            asked_.push_back(std::move(light));
        }
        for (const auto& [name, bytes] : arrays_) buffers_.try_emplace(name, device(), bytes.size()).first->second.upload(std::span(bytes));
    }

    /// What the shader finds, a mask per light.
    [[nodiscard]] std::vector<std::vector<uint32_t>> askTogether(const char* spirv, const std::vector<Light>& lights) {
        std::vector<std::byte> uniform;
        const glm::vec4 viewer = inputs_.viewer();
        const std::array<uint32_t, 4> count{uint32_t(lights.size()), 0, 0, 0};
        append(uniform, &viewer, sizeof viewer);
        append(uniform, &count, sizeof count);
        for (const Light& light : lights) {
            append(uniform, &light.place, sizeof light.place);
            append(uniform, light.grid.data(), light.grid.size());
            append(uniform, light.words.data(), 4 * light.words.size());
        }
        uniform.resize(32 + 8 * (uniform.size() - 32) / lights.size());
        Buffer uniformBuffer(device(), uniform.size(), vk::BufferUsageFlagBits::eUniformBuffer);
        uniformBuffer.upload(std::span<const std::byte>(uniform));

        std::vector<glm::uvec4> points;
        const auto positions = inputs_.positions().downloadAs<glm::uvec4>();
        const auto primitives = inputs_.primitives().downloadAs<uint32_t>();
        for (size_t i = 0; i < positions.size(); ++i) points.emplace_back(glm::uvec3(positions[i]), primitives[i]);
        Buffer pointBuffer(device(), 16 * points.size()), results(device(), 4 * (points.size() + 63));
        pointBuffer.upload(std::span<const glm::uvec4>(points));
        results.fill(kPoison);

        std::vector<Binding> resources{
            {"lights", &uniformBuffer}, {"points", &pointBuffer}, {"results", &results}, {"gnoCasters", &inputs_.casters()}};
        for (const auto& [name, buffer] : buffers_) resources.push_back({name, &buffer});
        for (const char* declared : {"gnoForestHeader", "gnoForestFew"})  // by forest/bindings.glsl; a query reads neither
            if (!buffers_.contains(declared)) resources.push_back({declared, &results});
        const host::ComputePass pass(device(), test::readSpirv(spirv));
        host::Recording recording(device());
        recording.beginPass("several lights");
        pass.dispatch(recording, resources, {}, uint32_t(points.size() + 63) / 64);
        recording.endPass();
        recording.submit();
        const auto found = results.downloadAs<uint32_t>();
        std::vector<std::vector<uint32_t>> masks(lights.size());
        for (size_t i = 0; i < points.size(); ++i)
            for (size_t l = 0; l < lights.size(); ++l)
                masks[l].push_back(primitives[i] == GNO_BACKGROUND ? GNO_VISIBILITY_BACKGROUND : (found[i] >> (4 * l)) & 15u);
        return masks;
    }

    static size_t differences(const std::vector<uint32_t>& a, const std::vector<uint32_t>& b) {
        size_t count = a.size() == b.size() ? 0 : std::max(a.size(), b.size());
        for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) count += a[i] != b[i];
        return count;
    }

    static const host::Device& device() { return test::passes().device(); }

    static constexpr uint32_t kWidth = 96, kHeight = 64;
    host::Frame frame_;
    host::FrameInputs inputs_;
    std::vector<glm::vec4> lights_;
    std::vector<std::vector<uint32_t>> single_;  ///< masks
    std::vector<Light> asked_;
    std::map<std::string, std::vector<std::byte>> arrays_;
    std::map<std::string, Buffer> buffers_;
};

TEST_P(SeveralLights, AnswerAsEachAlone) {
    ASSERT_EQ(points(), 2u);
    ASSERT_EQ(lights_.size(), 3u);
    runSingly(GetParam());
    for (size_t l = 0; l < lights_.size(); ++l) {
        for (const uint32_t value : {GNO_VISIBILITY_LIT, GNO_VISIBILITY_SHADOW})
            EXPECT_GT(std::count(single_[l].begin(), single_[l].end(), value), 100) << "light " << l << " shows nothing";
        EXPECT_GT(differences(single_[l], single_[(l + 1) % 3]), 100u) << "two lights that nobody could tell apart";
    }
    const auto together = askTogether(GetParam().spirv, asked_);
    for (size_t l = 0; l < lights_.size(); ++l) EXPECT_EQ(differences(together[l], single_[l]), 0u) << "light " << l;

    // And it would be seen if a light asked another one's part of the buffers.
    std::vector<Light> swapped = asked_;
    std::swap(swapped[0].words, swapped[1].words);
    const auto wrong = askTogether(GetParam().spirv, swapped);
    for (size_t l = 0; l < 2; ++l) EXPECT_GT(differences(wrong[l], single_[l]), 100u) << "light " << l;
    EXPECT_EQ(differences(wrong[2], single_[2]), 0u);
}

INSTANTIATE_TEST_SUITE_P(, SeveralLights, testing::ValuesIn(kinds()), [](const testing::TestParamInfo<Kind>& given) {
    std::string name = given.param.technique;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

/// A build knows nothing of that: it binds a light's part of each buffer by its descriptor's offset.
class SeveralBuilds : public SeveralLights {};

TEST_P(SeveralBuilds, BindPartsOfTheSameBuffers) {
    const TopOptions options;
    const uint32_t casters = inputs_.triangleCount();
    const uint64_t nodes = (4ull * casters + kAlign - 1) / kAlign * kAlign;
    for (const ArrayPart& part : GetParam().parts) {
        const uint64_t elements = (lights_.size() + 1) * (part.word == 0 ? nodes : kAlign);
        buffers_.try_emplace(part.name, device(), elements * part.elementBytes).first->second.fill(kPoison);
    }
    for (size_t l = 0; l < lights_.size(); ++l) {
        inputs_.setLight(lights_[l], host::Cull::none);
        host::StructureCache cache;
        host::Technique& technique = host::techniqueByName(GetParam().technique);
        single_.push_back(
            technique.run(inputs_, cache, host::Settings(technique.info().settings, {}), {.counters = false, .warmUp = false}).visibility);
        asked_.push_back({lights_[l], {}, {uint32_t((l + 1) * nodes), uint32_t((l + 1) * kAlign), 0, 0}});
        std::vector<Binding> parts;
        for (const ArrayPart& part : GetParam().parts) {
            const uint64_t bytes = (part.word == 0 ? 4ull * casters : 1) * part.elementBytes;
            parts.push_back({part.name, host::BufferPart{&buffers_.at(part.name), asked_[l].words[part.word] * part.elementBytes, bytes}});
        }
        const host::PassRunner build(inputs_.passes(), topBuildPasses(casters, options), inputs_.withCasters(parts));
        host::Recording recording(device());
        build.record(recording, inputs_.push(options.seed));
        recording.submit();
    }
    const auto together = askTogether(GetParam().spirv, asked_);
    for (size_t l = 0; l < lights_.size(); ++l) EXPECT_EQ(differences(together[l], single_[l]), 0u) << "light " << l;
}

INSTANTIATE_TEST_SUITE_P(, SeveralBuilds, testing::Values(kinds().front()), [](const auto&) { return std::string("d_hybrid"); });

}  // namespace
}  // namespace gno
