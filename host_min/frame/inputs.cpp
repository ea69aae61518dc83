// SPDX-License-Identifier: MIT
#include "host_min/frame/inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "glsl/top/node.h"
#include "host_min/error.hpp"
#include "host_min/frame/cull_hull.hpp"
#include "host_min/vulkan/acceleration_structure.hpp"

namespace gno::host {
namespace {

constexpr uint32_t kMaxSide = 8192;
constexpr uint32_t kGroup = 64;  // of caster_state.comp

/// A bit a triangle, 32 a word; `flags` is empty (none is set) or has one entry per triangle.
std::vector<uint32_t> packed(std::span<const uint8_t> flags, size_t triangles) {
    std::vector<uint32_t> bits((triangles + 31) / 32, 0);
    for (size_t i = 0; i < flags.size(); ++i)
        if (flags[i]) bits[i / 32] |= 1u << (i % 32);
    return bits;
}

/// Where the device has ray queries, an acceleration structure may be built from the casters as they lie.
vk::BufferUsageFlags casterUsage(const DeviceFacts& device) {
    const vk::BufferUsageFlags usage = vk::BufferUsageFlagBits::eStorageBuffer;
    return device.rayQuery ? usage | AccelerationStructure::kInputUsage : usage;
}

/// The camera with its near and far plane moved to the nearest and the farthest vertex where those lie inside of them: of a distant, narrow view the
/// depth buffer then tells the scene's parts from each other. Nothing is clipped that was not.
Camera tightened(Camera camera, const Frame& frame) {
    double nearest = std::numeric_limits<double>::infinity(), farthest = -nearest;
    const glm::dvec3 backward(camera.gridFromCamera[2]), place(camera.gridFromCamera[3]);
    for (const Triangle& t : frame.triangles)
        for (const glm::vec3& at : {t.a, t.b, t.c}) {
            const double depth = glm::dot(backward, place - glm::dvec3(at));
            nearest = std::min(nearest, depth);
            farthest = std::max(farthest, depth);
        }
    const double room = 1e-3 * (farthest - nearest) + 1e-6 * std::abs(farthest) + 1e-5;  // far above the rounding of positions in [-1, 1]
    if (!(farthest > camera.znear)) return camera;                                       // nothing before it
    camera.znear = std::max(camera.znear, nearest - room);
    camera.zfar = camera.zfar > 0 ? std::min(camera.zfar, farthest + room) : farthest + room;
    return camera;
}

}  // namespace

void checkSize(const DeviceFacts& device, uint64_t width, uint64_t height) {
    const uint32_t limit = std::min(kMaxSide, device.maxImageDimension2D);
    if (width < 1 || height < 1) throw InputError(fmt::format("--size {}x{}: both must be at least 1", width, height));
    if (width > limit || height > limit) throw InputError(fmt::format("--size {}x{} is over the limit of {}x{}", width, height, limit, limit));
}

FrameInputs::FrameInputs(PassCache& passes, const Frame& frame, uint32_t width, uint32_t height) : FrameInputs(passes, frame, width, height, false) {
    rasterise();
}

FrameInputs::FrameInputs(PassCache& passes, const Frame& frame, uint32_t width, uint32_t height, bool givenSamples)
    : passes_(passes),
      frame_(frame),
      width_(width),
      height_(height),
      givenSamples_(givenSamples),
      casters_(passes.device(), frame.triangles.size() * sizeof(Triangle), casterUsage(passes.device().facts())),
      states_(passes.device(), frame.triangles.size() * 4),
      closed_(passes.device(), (frame.triangles.size() + 31) / 32 * 4),
      oneSided_(passes.device(), closed_.bytes()),
      camera_(passes.device(), sizeof(glm::mat4), vk::BufferUsageFlagBits::eUniformBuffer),
      planes_(passes.device(), kMaxCullPlanes * sizeof(glm::vec4), vk::BufferUsageFlagBits::eUniformBuffer),
      positions_(passes.device(), width, height, vk::Format::eR32G32B32A32Sfloat),
      normals_(passes.device(), width, height, vk::Format::eR32G32B32A32Sfloat),
      primitives_(passes.device(), width, height, vk::Format::eR32Uint),
      depth_(passes.device(), width, height, vk::Format::eD32Sfloat),
      samples_(passes.device(), width, height, vk::Format::eR32G32B32A32Uint) {
    if (topLinkBytes(frame.triangles.size()) > device().facts().maxStorageBufferRange)
        throw InputError(fmt::format("{} triangles are over the limit of {} that the device's maxStorageBufferRange sets", frame.triangles.size(),
                                     device().facts().maxStorageBufferRange / 64));
    casters_.upload(std::span(frame.triangles));
    closed_.upload(std::span<const uint32_t>(packed(frame.closed, frame.triangles.size())));
    oneSided_.upload(std::span<const uint32_t>(packed(frame.oneSided, frame.triangles.size())));
    Recording recording(device());
    for (const Image* image : {&positions_, &normals_, &primitives_, &depth_, &samples_}) recording.toGeneral(*image);
    recording.submit();
}

FrameInputs::FrameInputs(PassCache& passes, const Frame& frame, std::span<const OracleSample> samples, uint32_t width)
    : FrameInputs(passes, frame, width, uint32_t(std::max<size_t>(1, (samples.size() + width - 1) / width)), true) {
    std::vector<glm::uvec4> texels(size_t(width_) * height_, glm::uvec4(0, 0, 0, GNO_BACKGROUND));
    for (size_t i = 0; i < samples.size(); ++i) {
        const glm::vec3 p = samples[i].position;
        texels[i] = {std::bit_cast<uint32_t>(p.x), std::bit_cast<uint32_t>(p.y), std::bit_cast<uint32_t>(p.z), samples[i].own};
    }
    samples_.upload(std::as_bytes(std::span(texels)));
}

glm::dmat4 FrameInputs::clipFromGrid() const { return tightened(frame_.camera, frame_).clipFromGrid(double(width_) / height_); }

void FrameInputs::rasterise() {
    const glm::mat4 clip(clipFromGrid());
    camera_.upload(std::span(&clip, 1));

    const std::array formats{positions_.format(), normals_.format(), primitives_.format()};
    const std::string name = hasMaterials() ? "core/examples/gbuffer_materials" : "core/examples/gbuffer";
    const RasterPass& pass = passes_.raster(name + ".vert", name + ".frag", formats, true);
    const std::array targets{RasterPass::Target{&positions_, vk::ClearColorValue(0.f, 0.f, 0.f, 0.f)},
                             RasterPass::Target{&normals_, vk::ClearColorValue(0.f, 0.f, 0.f, 0.f)},
                             RasterPass::Target{&primitives_, vk::ClearColorValue(GNO_BACKGROUND, 0u, 0u, 0u)}};
    std::vector<Binding> resources{{"gnoCasters", &casters_}, {"gnoCamera", &camera_}, {"gnoOneSided", &oneSided_}};
    if (hasMaterials())
        resources.insert(resources.end(), {{"gnoMaterialOf", &materials().of()},
                                           {"gnoSurfaces", &materials().surfaces()},
                                           {"gnoMaterials", &materials().list()},
                                           {"gnoTexels", &materials().texels()}});
    const ExamplePush constants = push();
    Recording recording(device());
    pass.draw(recording, targets, &depth_, resources, std::as_bytes(std::span(&constants, 1)), 3 * triangleCount());
    recording.submit();
}

void FrameInputs::setLight(glm::vec4 light, Cull cull) {
    light_ = light;
    cull_ = cull;
    leftWhole_.clear();
    if ((uint32_t(cull) & uint32_t(Cull::front)) != 0 && !givenSamples_) {
        if (!frontCull_) {
            frontCull_ = legalFrontCull(frame_, double(width_) / height_);
            closed_.upload(std::span<const uint32_t>(packed(frontCull_->mayLose, frame_.triangles.size())));
        }
        leftWhole_ = frontCull_->leftWhole;
    }
    const std::vector<glm::vec4> hull = givenSamples_ ? std::vector<glm::vec4>() : cullHull(frame_.camera, double(width_) / height_, light_);
    planes_.upload(std::span(hull));
    planeCount_ = uint32_t(hull.size());
    const ExamplePush constants = push();
    const auto bytes = std::as_bytes(std::span(&constants, 1));

    const ComputePass& casterPass = passes_.compute("core/examples/caster_state.comp");
    const ComputePass& samplePass = passes_.compute("core/examples/view_samples.comp");
    const std::array casterBindings{Binding{"gnoCasters", &casters_}, Binding{"gnoClosed", &closed_}, Binding{"gnoStates", &states_},
                                    Binding{"gnoCullPlanes", &planes_}};
    const std::array sampleBindings{Binding{"gnoCasters", &casters_}, Binding{"gnoPositions", &positions_}, Binding{"gnoPrimitives", &primitives_},
                                    Binding{"gnoSamples", &samples_}};
    for (int warm = 0; warm < 2; ++warm) {  // the first run of a pipeline holds its compilation
        Recording recording(device());
        recording.beginPass(casterSetUp_.name);
        casterPass.dispatch(recording, casterBindings, bytes, (triangleCount() + kGroup - 1) / kGroup);
        recording.endPass();
        if (!givenSamples_) samplePass.dispatch(recording, sampleBindings, bytes, (width_ + 7) / 8, (height_ + 7) / 8);
        casterSetUp_ = recording.submit().front();
    }

    const auto texels = samples_.downloadAs<glm::uvec4>();
    pixels_.resize(texels.size());
    sampleCount_ = facingAwayCount_ = 0;
    for (size_t i = 0; i < texels.size(); ++i) {
        pixels_[i] = {{std::bit_cast<float>(texels[i].x), std::bit_cast<float>(texels[i].y), std::bit_cast<float>(texels[i].z)}, texels[i].w};
        sampleCount_ += texels[i].w <= GNO_NO_CASTER;
        facingAwayCount_ += texels[i].w == GNO_FACING_AWAY;
    }
    const auto states = states_.downloadAs<uint32_t>();
    casterCount_ = uint64_t(std::count_if(states.begin(), states.begin() + triangleCount(), [](uint32_t s) { return (s & 4u) != 0; }));
}

ExamplePush FrameInputs::push(uint32_t seed) const {
    return {light_, viewer(), {width_, height_}, triangleCount(), seed, uint32_t(cull_), planeCount_, 0};
}

std::vector<Binding> FrameInputs::withCasters(std::vector<Binding> others) const {
    others.insert(others.end(), {{"gnoCasters", &casters_}, {"gnoStates", &states_}, {"gnoSamples", &samples_}});
    return others;
}

const MaterialBuffers& FrameInputs::materials() const {
    if (!materials_) materials_.emplace(device(), frame_);
    return *materials_;
}

}  // namespace gno::host
