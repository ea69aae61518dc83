// SPDX-License-Identifier: MIT
#include "host_min/techniques/shadow_map.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host_min/techniques/dumped.hpp"
#include "host_min/techniques/shadow_map_layers.hpp"

namespace gno::host {
namespace {

uint32_t facesByName(const std::string& word) {
    return word == "back" ? GNO_SHADOW_MAP_BACK : word == "front" ? GNO_SHADOW_MAP_FRONT : GNO_SHADOW_MAP_BOTH;
}

class ShadowMapTechnique final : public Technique {
public:
    ShadowMapTechnique() {
        info_.name = "shadow-map";
        info_.paper = "Casting Curved Shadows on Curved Surfaces, SIGGRAPH 1978; fit=focused: Sample Distribution Shadow Maps, I3D 2011";
        info_.precisions = {Precision::published};
        info_.effects = {"point_light", "directional_light", "spot_light", "open_casters"};
        info_.settings = {
            {"map", "texels along a side, of each view", 512, 8192, {}, "2048"},
            {"fit", "a view covers the whole scene (cube faces: 90 degrees), or just the view samples", 0, 0, {"uniform", "focused"}, "focused"},
            {"bias", "slope-scaled bias: texels by which a caster's plane is followed away from the light", 0, 64, {}, "1.0", true},
            {"constant_bias", "constant bias: texel widths by which a sample is moved towards the light", 0, 64, {}, "1.0", true},
            {"faces", "faces that are drawn, as the light sees them", 0, 0, {"both", "back", "front"}, "both"},
            {"stage", "shader stage of the query", 0, 0, {"compute", "fragment"}, "compute"}};
        info_.hostWaits = true;
    }

    const TechniqueInfo& info() const override { return info_; }

    std::string structureKey(const FrameInputs&, const Settings& settings, const RunOptions&) const override {
        return fmt::format("shadow-map {} {} {} {} {}", settings.number("map"), settings.word("fit"), settings.real("bias"),
                           settings.real("constant_bias"), settings.word("faces"));
    }

    std::unique_ptr<Structure> makeStructure(const FrameInputs&, const Settings& settings, const RunOptions&) const override {
        const ShadowMapOptions options{settings.number("map"), float(settings.real("bias")), float(settings.real("constant_bias")),
                                       facesByName(settings.word("faces"))};
        return std::make_unique<ShadowMapLayers>(options, settings.word("fit") == "focused");
    }

    std::string overLimit(const DeviceFacts& device, const FrameLoad&, const Settings& settings) const override {
        return shadowMapOverLimit(device, settings.number("map"));
    }

    Query query(const Structure& structure, const FrameInputs& inputs, const Settings& settings, const RunOptions&) const override {
        return {shadowMapQueryPasses(inputs.width(), inputs.height(), settings.word("stage") == "fragment"),
                dynamic_cast<const ShadowMapLayers&>(structure).bindings(), false};
    }

    void read(const Structure& structure, const FrameInputs& inputs, const Settings& settings, const RunOptions& options,
              TechniqueResult& result) const override {
        const auto& layers = dynamic_cast<const ShadowMapLayers&>(structure);
        const Image& map = layers.map();
        result.bytes = {{"map", layers.texels() * map.texelBytes()}, {"views", layers.views().bytes()}};
        if (options.counters) count(inputs, layers.viewCount(), layers.texels(), facesByName(settings.word("faces")), result.counters);
        if (!options.dump) return;
        result.dump.push_back(dumped("views", "GnoShadowMapHeader header, GnoShadowMapView view[views]", layers.views(), 4,
                                     shadowMapViewBytes(layers.viewCount()) / 4));
        std::vector<std::byte> depths;
        for (uint32_t i = 0; i < map.layers(); ++i) {
            const auto layer = map.download(i);
            depths.insert(depths.end(), layer.begin(), layer.end());
        }
        result.dump.push_back({"map", "float depth[views][map][map]", std::move(depths)});
    }

private:
    static void count(const FrameInputs& inputs, uint64_t views, uint64_t texels, uint32_t faces, RecordCounters& totals) {
        const auto states = inputs.states().downloadAs<uint32_t>();
        const auto isDrawn = [&](uint32_t state) {  // bits of core/caster_state.glsl
            const uint32_t facing = state & 3u;     // 0: the light sees the front, 2: the back
            if ((state & 4u) == 0) return false;
            return faces == GNO_SHADOW_MAP_BACK ? facing == 2u : faces == GNO_SHADOW_MAP_FRONT ? facing == 0u : facing != 1u;
        };
        const uint64_t drawn = uint64_t(std::count_if(states.begin(), states.begin() + inputs.triangleCount(), isDrawn));
        totals.more = {
            {"views", views}, {"texels", texels}, {"triangles_drawn", drawn * views}, {"vertices", 3ull * inputs.triangleCount() * views}};
    }

    TechniqueInfo info_;
};

}  // namespace

std::unique_ptr<Technique> makeShadowMapTechnique() { return std::make_unique<ShadowMapTechnique>(); }

}  // namespace gno::host
