// SPDX-License-Identifier: MIT
#include "host_min/techniques/ray_query.hpp"

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

    std::string structureKey(const FrameInputs&, const Settings&, const RunOptions&) const override { return "ray scene"; }

    std::unique_ptr<Structure> makeStructure(const FrameInputs&, const Settings&, const RunOptions&) const override {
        return std::make_unique<RayScene>();
    }

    Query query(const Structure& structure, const FrameInputs& inputs, const Settings& settings, const RunOptions&) const override {
        return {rayQueryPasses(inputs.width(), inputs.height(), settings.word("stage") == "fragment"),
                dynamic_cast<const RayScene&>(structure).bindings(), false};
    }

    void read(const Structure& structure, const FrameInputs& inputs, const Settings&, const RunOptions& options,
              TechniqueResult& result) const override {
        const auto& scene = dynamic_cast<const RayScene&>(structure);
        result.bytes = scene.bytes();
        if (options.counters) result.counters.more = count(inputs, scene);
        if (options.dump)
            result.dump.push_back(
                {"indices", "uint index[3 * casters], all three the same where the caster is left out", scene.indices().download()});
    }

private:
    /// By the instrumented query, whose counts are others than the trees'.
    static NamedNumbers count(const FrameInputs& inputs, const RayScene& scene) {
        const auto poisoned = [&](vk::Format format) {
            Image image(inputs.device(), inputs.width(), inputs.height(), format);
            image.clear(vk::ClearColorValue(kPoison, kPoison, kPoison, kPoison));
            return image;
        };
        const Image counts = poisoned(vk::Format::eR32G32B32A32Uint), visibility = poisoned(vk::Format::eR32Uint);
        std::vector<Binding> resources = inputs.withCasters(scene.bindings());
        resources.insert(resources.end(), {{"gnoCounts", &counts}, {"gnoVisibility", &visibility}});
        const PassRunner counting(inputs.passes(), rayQueryPasses(inputs.width(), inputs.height(), false), resources, {.counters = true});
        Recording recording(inputs.device());
        counting.record(recording, inputs.push());
        recording.submit();
        uint64_t rays = 0, candidates = 0;
        for (const glm::uvec4& pixel : counts.downloadAs<glm::uvec4>()) {
            rays += pixel.x;
            candidates += pixel.y;
        }
        return {{"rays", rays}, {"candidates", candidates}};
    }

    static constexpr uint32_t kPoison = 0xDEADBEEFu;  // a shader that writes nothing must not look right

    TechniqueInfo info_;
};

}  // namespace

std::unique_ptr<Technique> makeRayQueryTechnique() { return std::make_unique<RayQueryTechnique>(); }

}  // namespace gno::host
