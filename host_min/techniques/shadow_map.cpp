// SPDX-License-Identifier: MIT
#include "host_min/techniques/shadow_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host_min/error.hpp"
#include "host_min/techniques/measure.hpp"
#include "host_min/techniques/shadow_views.hpp"

namespace gno::host {
namespace {

constexpr uint32_t kPoison = 0xDEADBEEFu;  // a shader that writes nothing must not look right

uint32_t facesByName(const std::string& word) {
    return word == "back" ? GNO_SHADOW_MAP_BACK : word == "front" ? GNO_SHADOW_MAP_FRONT : GNO_SHADOW_MAP_BOTH;
}

/// Header and views, as glsl/shadow_map/bindings.glsl reads them.
Buffer viewBuffer(const Device& device, std::span<const ShadowFrustum> frusta, uint32_t size, float constantBias) {
    Buffer buffer(device, sizeof(GnoShadowMapHeader) + frusta.size() * sizeof(GnoShadowMapView));
    const GnoShadowMapHeader header{uint32_t(frusta.size()), size, 0, 0};
    std::vector<GnoShadowMapView> views;
    for (const ShadowFrustum& frustum : frusta) views.push_back(gnoShadowMapConstantBias(frustum.view(), constantBias, float(size)));
    buffer.upload(std::as_bytes(std::span(&header, 1)));
    buffer.upload(std::as_bytes(std::span(views)), sizeof header);
    return buffer;
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
    }

    const TechniqueInfo& info() const override { return info_; }

    TechniqueResult run(const FrameInputs& inputs, StructureCache&, const Settings& settings, const RunOptions& options) override {
        const Device& device = inputs.device();
        const uint32_t size = settings.number("map");
        const uint32_t limit = device.facts().maxImageDimension2D;
        if (size > limit) throw InputError(fmt::format("--set map={}: over the device's maxImageDimension2D ({})", size, limit));
        TechniqueResult result;
        result.passes.push_back({inputs.casterSetUp().name, inputs.casterSetUp().ms});

        const std::vector<ShadowFrustum> whole = shadowFrusta(inputs.frame(), inputs.light());
        const std::vector<uint32_t> bounds = measureSamples(inputs, whole, options, result.passes);
        const auto frusta = fitShadowFrusta(whole, bounds, inputs.frame().triangles, settings.word("fit") == "focused");
        const uint32_t side = frusta.empty() ? 1 : size;
        const Buffer views = viewBuffer(device, frusta, side, float(settings.real("constant_bias")));
        const Image map = makeMap(device, side, std::max<uint32_t>(1, uint32_t(frusta.size())));
        Image visibility(device, inputs.width(), inputs.height(), vk::Format::eR32Uint);
        visibility.clear(vk::ClearColorValue(kPoison, kPoison, kPoison, kPoison));

        // A recording each: after a graphics pass lavapipe leaves the time stamps of a compute pass to its rasteriser, which is not asked in time.
        const auto timed = [&](const char* name, const auto& record) {
            const auto times = measure(device, options.repeat, options.warmUp, [&](Recording& recording) {
                recording.beginPass(name);
                record(recording);
                recording.endPass();
            });
            result.passes.push_back({times.front().name, times.front().ms});
        };
        timed("shadow_map_build", [&](Recording& recording) {
            for (uint32_t view = 0; view < frusta.size(); ++view) draw(recording, inputs, views, map, view, settings);
        });
        timed("shadow_map_query",
              [&](Recording& recording) { query(recording, inputs, views, map, visibility, settings.word("stage") == "fragment"); });
        const uint64_t texels = uint64_t(side) * side * map.layers();
        result.bytes = {{"map", texels * map.texelBytes()}, {"views", views.bytes()}};
        result.visibility = visibility.downloadAs<uint32_t>();
        if (options.counters) count(inputs, frusta.size(), texels, facesByName(settings.word("faces")), result.counters);
        if (options.dump) {
            result.dump.push_back({"views", "GnoShadowMapHeader header, GnoShadowMapView view[views]", views.download()});
            std::vector<std::byte> depths;
            for (uint32_t i = 0; i < map.layers(); ++i) {
                const auto layer = map.download(i);
                depths.insert(depths.end(), layer.begin(), layer.end());
            }
            result.dump.push_back({"map", "float depth[views][map][map]", std::move(depths)});
        }
        return result;
    }

private:
    /// glsl/shadow_map/fit.glsl over the whole views.
    static std::vector<uint32_t> measureSamples(const FrameInputs& inputs, std::span<const ShadowFrustum> whole, const RunOptions& options,
                                                std::vector<RecordPass>& passes) {
        const Buffer views = viewBuffer(inputs.device(), whole, 1, 0);
        const Buffer bounds(inputs.device(), whole.size() * 16, vk::BufferUsageFlagBits::eStorageBuffer);
        const ComputePass& pass = inputs.passes().compute("shadow_map/examples/fit.comp");
        const std::array resources{Binding{"gnoShadowMapViews", &views}, Binding{"gnoShadowMapBounds", &bounds},
                                   Binding{"gnoSamples", &inputs.samples()}};
        const ExamplePush push = inputs.push();
        const auto times = measure(inputs.device(), options.repeat, options.warmUp, [&](Recording& recording) {
            recording.beginPass("shadow_map_setup");
            recording.commands().fillBuffer(bounds.handle(), 0, VK_WHOLE_SIZE, 0);
            recording.barrier();
            pass.dispatch(recording, resources, std::as_bytes(std::span(&push, 1)), (inputs.width() + 7) / 8, (inputs.height() + 7) / 8);
            recording.endPass();
        });
        passes.push_back({times.front().name, times.front().ms});
        return bounds.downloadAs<uint32_t>();
    }

    static Image makeMap(const Device& device, uint32_t size, uint32_t layers) {
        try {
            Image map = Image::array(device, size, size, vk::Format::eD32Sfloat, layers);
            Recording recording(device);
            recording.toGeneral(map);
            recording.submit();
            return map;
        } catch (const WorkError& error) {
            throw InputError(fmt::format("--set map={}: {} views do not fit: {}", size, layers, error.what()));
        }
    }

    static void draw(Recording& recording, const FrameInputs& inputs, const Buffer& views, const Image& map, uint32_t view,
                     const Settings& settings) {
        const RasterPass& pass = inputs.passes().raster("shadow_map/examples/depth.vert", "", {}, true, {{0, facesByName(settings.word("faces"))}});
        const std::array resources{Binding{"gnoCasters", &inputs.casters()}, Binding{"gnoStates", &inputs.states()},
                                   Binding{"gnoShadowMapViews", &views}};
        const ExamplePush push = inputs.push();
        pass.drawDepth(recording, map, view, -float(settings.real("bias")), resources, std::as_bytes(std::span(&push, 1)),
                       3 * inputs.triangleCount());
    }

    static void query(Recording& recording, const FrameInputs& inputs, const Buffer& views, const Image& map, const Image& visibility,
                      bool fragment) {
        const ExamplePush push = inputs.push();
        const auto bytes = std::as_bytes(std::span(&push, 1));
        const std::array resources{Binding{"gnoShadowMapViews", &views}, Binding{"gnoShadowMap", &map}, Binding{"gnoSamples", &inputs.samples()},
                                   Binding{"gnoVisibility", &visibility}};
        if (!fragment) {
            inputs.passes()
                .compute("shadow_map/examples/query.comp")
                .dispatch(recording, resources, bytes, (inputs.width() + 7) / 8, (inputs.height() + 7) / 8);
            return;
        }
        const std::array formats{visibility.format()};
        const std::array targets{RasterPass::Target{&visibility, vk::ClearColorValue(kPoison, kPoison, kPoison, kPoison)}};
        inputs.passes()
            .raster("core/examples/fullscreen.vert", "shadow_map/examples/query.frag", formats, false)
            .draw(recording, targets, nullptr, resources, bytes, 3);
    }

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
