// SPDX-License-Identifier: MIT
#include "host_min/techniques/ray_query.hpp"

#include <fmt/format.h>

#include <array>

#include "host_min/error.hpp"
#include "host_min/techniques/measure.hpp"
#include "host_min/techniques/ray_scene.hpp"

namespace gno::host {
namespace {

class RayQueryTechnique final : public Technique {
public:
    RayQueryTechnique() {
        info_.name = "ray-query";
        info_.paper = "VK_KHR_ray_query: the driver's acceleration structure, fp32 shadow rays";
        info_.precisions = {Precision::published};
        info_.effects = {"point_light", "directional_light", "spot_light", "open_casters"};
        info_.settings.push_back({"stage", "shader stage of the timed query", 0, 0, {"compute", "fragment"}, "compute"});
        info_.rayQuery = true;
    }

    const TechniqueInfo& info() const override { return info_; }

    TechniqueResult run(const FrameInputs& inputs, StructureCache& structures, const Settings& settings, const RunOptions& options) override {
        const std::string missing = missingFor(info_, inputs.device().facts());
        if (!missing.empty()) throw InputError(fmt::format("technique {}: the device lacks {}", info_.name, missing));
        const RayScene& scene =
            structures.get<RayScene>("ray scene", [&] { return std::make_shared<RayScene>(inputs, options.repeat, options.warmUp); });

        TechniqueResult result;
        result.passes = scene.passes();
        result.bytes = scene.bytes();
        Image visibility(inputs.device(), inputs.width(), inputs.height(), vk::Format::eR32Uint);
        visibility.clear(vk::ClearColorValue(kPoison, kPoison, kPoison, kPoison));
        if (options.counters) result.counters.more = count(inputs, scene, visibility);
        const bool fragment = settings.word("stage") == "fragment";
        for (const PassTime& pass : measure(inputs.device(), options.repeat, options.warmUp, [&](Recording& recording) {
                 recording.beginPass("ray_query");
                 query(recording, inputs, scene, visibility, nullptr, fragment);
                 recording.endPass();
             }))
            result.passes.push_back({pass.name, pass.ms});
        result.visibility = visibility.downloadAs<uint32_t>();
        if (options.dump)
            result.dump.push_back(
                {"indices", "uint index[3 * casters], all three the same where the caster is left out", scene.indices().download()});
        return result;
    }

private:
    static constexpr uint32_t kPoison = 0xDEADBEEFu;  // a shader that writes nothing must not look right

    static void query(Recording& recording, const FrameInputs& inputs, const RayScene& scene, const Image& visibility, const Image* counts,
                      bool fragment) {
        const std::string base = "rivals/examples/ray_query";
        const ExamplePush push = inputs.push();
        const auto bytes = std::as_bytes(std::span(&push, 1));
        const std::array resources{Binding{"gnoRayStructure", &scene.top()}, Binding{"gnoSamples", &inputs.samples()},
                                   Binding{"gnoVisibility", &visibility}, Binding{"gnoCounts", counts ? counts : &inputs.samples()}};
        if (fragment) {
            const std::array formats{visibility.format()};
            const std::array targets{RasterPass::Target{&visibility, vk::ClearColorValue(kPoison, kPoison, kPoison, kPoison)}};
            inputs.passes()
                .raster("core/examples/fullscreen.vert", base + ".frag", formats, false)
                .draw(recording, targets, nullptr, resources, bytes, 3);
        } else {
            inputs.passes()
                .compute(base + (counts ? ".comp.counters" : ".comp"))
                .dispatch(recording, resources, bytes, (inputs.width() + 7) / 8, (inputs.height() + 7) / 8);
        }
    }

    static NamedNumbers count(const FrameInputs& inputs, const RayScene& scene, const Image& visibility) {
        Image counts(inputs.device(), inputs.width(), inputs.height(), vk::Format::eR32G32B32A32Uint);
        counts.clear(vk::ClearColorValue(kPoison, kPoison, kPoison, kPoison));
        Recording recording(inputs.device());
        query(recording, inputs, scene, visibility, &counts, false);
        recording.submit();
        uint64_t rays = 0, candidates = 0;
        for (const glm::uvec4& pixel : counts.downloadAs<glm::uvec4>()) {
            rays += pixel.x;
            candidates += pixel.y;
        }
        return {{"rays", rays}, {"candidates", candidates}};
    }

    TechniqueInfo info_;
};

}  // namespace

std::unique_ptr<Technique> makeRayQueryTechnique() { return std::make_unique<RayQueryTechnique>(); }

}  // namespace gno::host
