// SPDX-License-Identifier: MIT
#include "host_min/techniques/cluster_hierarchy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "host_min/error.hpp"

namespace gno::host {
namespace {

constexpr uint32_t kTotals = 5;
constexpr uint32_t kMasks = 1, kBounds = 2;  // GNO_CLUSTER_MASKS_OF_NODES, GNO_CLUSTER_BOUNDS_OF_NODES

uint64_t boxCount(const GnoClusterLayout& layout, const ClusterOptions& options) {
    switch (layout.form) {
        case GNO_CLUSTER_IMPLICIT:
            return 0;
        case GNO_CLUSTER_COMPACT:
            return options.boxCapacity;
        default:
            return gnoClusterNodeCount(layout);
    }
}

uint64_t boundBytes(const GnoClusterLayout& layout, const ClusterOptions& options) {
    return (layout.form == GNO_CLUSTER_FLAT ? 4 : 12) * boxCount(layout, options);
}

uint32_t checkedSize(const FrameInputs& inputs, const GnoClusterLayout& layout, const ClusterOptions& options) {
    const uint64_t limit = inputs.device().facts().maxStorageBufferRange;
    if (boundBytes(layout, options) > limit)
        throw InputError(fmt::format(
            "--set bounds={}: at {}x{} an array of bounds takes {} bytes, over the device's maxStorageBufferRange of {}: use --set bounds=compact{}",
            layout.form == GNO_CLUSTER_COMPACT ? "compact" : "explicit", inputs.width(), inputs.height(), boundBytes(layout, options), limit,
            layout.form == GNO_CLUSTER_COMPACT ? " with a smaller boxes" : ""));
    if (112 * uint64_t(inputs.triangleCount()) > limit)
        throw InputError(fmt::format("{} triangles: the shadow volumes of more than {} pass the device's maxStorageBufferRange of {}",
                                     inputs.triangleCount(), limit / 112, limit));
    return inputs.triangleCount();
}

uint64_t sumBytes(const FrameInputs& inputs, const ClusterOptions& options) {
    const uint64_t bytes = options.layers ? 16 * uint64_t(inputs.width()) * inputs.height() : 0;
    const uint64_t limit = inputs.device().facts().maxStorageBufferRange;
    if (bytes > limit)
        throw InputError(
            fmt::format("{}x{}: what casters let through takes {} bytes, over the device's maxStorageBufferRange of {}: use a smaller --size, or "
                        "--set materials=off",
                        inputs.width(), inputs.height(), bytes, limit));
    return bytes;
}

/// Groups of 64 in rows that stay below the limit on either axis.
std::array<uint32_t, 2> rowsOf64(uint32_t count) {
    const uint32_t groups = std::max(1u, (count + 63) / 64);
    const uint32_t columns = std::min(groups, 32768u);
    return {columns, (groups + columns - 1) / columns};
}

std::array<uint32_t, 2> rowsOfCasters(uint32_t count) {
    const uint32_t groups = std::max(1u, (count + 63) / 64);
    if (groups > kMostGroups) throw InputError(fmt::format("{} triangles are over the limit of {}", count, 64 * kMostGroups));
    return {groups, 1};
}

}  // namespace

GnoClusterFrame clusterFrame(const Camera& camera, uint32_t width, uint32_t height) {
    const double aspect = double(width) / height;
    const double down = camera.perspective ? std::tan(camera.yfov / 2) : camera.ymag;
    const glm::dmat4& m = camera.gridFromCamera;
    GnoClusterFrame frame{};
    frame.origin = glm::vec4(glm::vec3(m[3]), camera.perspective ? 1.0f : 0.0f);
    frame.right = glm::vec4(glm::vec3(m[0]), float(down * aspect));
    frame.down = glm::vec4(-glm::vec3(m[1]), float(down));
    frame.forward = glm::vec4(-glm::vec3(m[2]), 0.0f);
    frame.size = {width, height};
    return frame;
}

ClusterHierarchy::ClusterHierarchy(const FrameInputs& inputs, const ClusterOptions& options)
    : inputs_(inputs),
      options_(options),
      layout_(gnoClusterLayout({inputs.width(), inputs.height()}, options.form)),
      frame_(inputs.device(), sizeof(GnoClusterFrame) + sizeof(GnoClusterLayout), vk::BufferUsageFlagBits::eUniformBuffer),
      header_(inputs.device(), sizeof(GnoClusterHeader), vk::BufferUsageFlagBits::eStorageBuffer | vk::BufferUsageFlagBits::eIndirectBuffer),
      slices_(inputs.device(), 4 * (uint64_t(gnoClusterSlices(layout_)) + 1)),
      masks_(inputs.device(), 4 * uint64_t(gnoClusterWordCount(layout_))),
      shade_(inputs.device(), 4 * uint64_t(gnoClusterShadeWords(layout_))),
      low_(inputs.device(), (checkedSize(inputs, layout_, options), boundBytes(layout_, options))),
      high_(inputs.device(), boundBytes(layout_, options)),
      pointers_(inputs.device(), options.form == GNO_CLUSTER_COMPACT ? 8 * uint64_t(gnoClusterWordCount(layout_)) : 0),
      volumes_(inputs.device(), 112 * uint64_t(inputs.triangleCount())),
      info_(inputs.device(), 8 * uint64_t(inputs.triangleCount())),
      jobs_(inputs.device(), options.split > 0 ? 8 * uint64_t(options.jobCapacity) : 0),
      sums_(inputs.device(), sumBytes(inputs, options)),
      totals_(inputs.device(), 8 * kTotals),
      steps_(inputs.device(), 4),
      counts_(inputs.device(), inputs.width(), inputs.height(), vk::Format::eR32Uint) {
    GnoClusterFrame frame = clusterFrame(inputs.frame().camera, inputs.width(), inputs.height());
    frame.casterCount = inputs.triangleCount();
    frame.jobCapacity = options.split > 0 ? options.jobCapacity : 0;
    frame.boxCapacity = options.form == GNO_CLUSTER_COMPACT ? options.boxCapacity : 0;
    frame.split = options.split;
    frame.extraPlanes = options.extraPlanes;
    frame.frontCulled = (inputs.push().cull & uint32_t(Cull::front)) != 0;
    std::vector<std::byte> bytes(sizeof frame + sizeof layout_);
    std::memcpy(bytes.data(), &frame, sizeof frame);
    std::memcpy(bytes.data() + sizeof frame, &layout_, sizeof layout_);
    frame_.upload(std::span<const std::byte>(bytes));
    counts_.clear(vk::ClearColorValue(0u, 0u, 0u, 0u));
}

const ComputePass& ClusterHierarchy::pass(const std::string& name, uint32_t what, uint32_t which) const {
    // Only what the shader reads: a pipeline that differs in nothing is not compiled again.
    Specialization constants{{20, layout_.form}};
    if (name == "tiles.comp") constants[10] = layout_.form == GNO_CLUSTER_FLAT ? 32 : 64;
    if (name == "tiles.comp" || name == "up.comp") constants[21] = what;
    if (name.starts_with("traverse")) constants[22] = which;
    if (name.starts_with("traverse") || name == "volumes.comp") constants[0] = uint32_t(options_.precision);
    if (name == "finish_size.comp") constants[23] = options_.groups;
    return inputs_.passes().compute("clusters/examples/" + name, constants);
}

std::vector<Binding> ClusterHierarchy::resources(const Image* visibility) const {
    std::vector<Binding> all{{"gnoClusterFrame", &frame_},
                             {"gnoClusterHeader", &header_},
                             {"gnoClusterSliceTable", &slices_},
                             {"gnoClusterMasks", &masks_},
                             {"gnoClusterShade", &shade_},
                             {"gnoClusterLow", &low_},
                             {"gnoClusterHigh", &high_},
                             {"gnoClusterPointers", &pointers_},
                             {"gnoClusterVolumes", &volumes_},
                             {"gnoClusterInfo", &info_},
                             {"gnoClusterJobs", &jobs_},
                             {"gnoCasters", &inputs_.casters()},
                             {"gnoStates", &inputs_.states()},
                             {"gnoSamples", &inputs_.samples()},
                             {"gnoTotals", &totals_},
                             {"gnoSteps", &steps_},
                             {"gnoCounts", &counts_},
                             {"gnoVisibility", visibility ? visibility : &counts_}};
    if (options_.layers) {
        const MaterialBuffers& materials = inputs_.materials();
        for (const Binding& more :
             {Binding{"gnoMaterialOf", &materials.of()}, Binding{"gnoSurfaces", &materials.surfaces()}, Binding{"gnoMaterials", &materials.list()},
              Binding{"gnoTexels", &materials.texels()}, Binding{"gnoTransmittances", &sums_}})
            all.push_back(more);
    }
    return all;
}

void ClusterHierarchy::recordBuild(Recording& recording) const {
    const std::vector<Binding> all = resources(nullptr);
    const uint32_t columns = (inputs_.width() + 7) / 8, rows = (inputs_.height() + 7) / 8;
    const auto run = [&](const ComputePass& which, std::array<uint32_t, 2> groups, std::span<const std::byte> push = {}) {
        which.dispatch(recording, all, push, groups[0], groups[1]);
        recording.barrier();
    };
    const auto climb = [&](uint32_t what) {
        for (uint32_t depth = layout_.levels - 1; depth > 0; --depth)
            run(pass("up.comp", what), rowsOf64(gnoClusterWordsAt(layout_, depth)), std::as_bytes(std::span(&depth, 1)));
    };
    const std::array<uint32_t, 2> tiles{layout_.tiles.x, layout_.tiles.y};

    recording.beginPass("cluster_build");
    run(pass("reset.comp"), {std::min(1024u, rowsOf64(gnoClusterWordCount(layout_))[0]), 1});
    run(pass("range.comp"), {columns, rows});
    run(pass("slices.comp"), rowsOf64(gnoClusterSlices(layout_) + 1));
    const uint32_t first = layout_.form == GNO_CLUSTER_EXPLICIT || layout_.form == GNO_CLUSTER_FLAT ? kMasks | kBounds : kMasks;
    run(pass("tiles.comp", first), tiles);
    climb(first);
    if (layout_.form == GNO_CLUSTER_COMPACT) {
        run(pass("allocate.comp"), rowsOf64(gnoClusterWordCount(layout_)));
        run(pass("tiles.comp", kBounds), tiles);
        climb(kBounds);
    }
    recording.endPass();
}

void ClusterHierarchy::recordSetUp(Recording& recording) const {
    const ExamplePush push = inputs_.push();
    const auto casters = rowsOfCasters(inputs_.triangleCount());
    recording.beginPass("cluster_setup");
    if (options_.layers) pass("clear_sums.comp").dispatch(recording, resources(nullptr), {}, (inputs_.width() + 7) / 8, (inputs_.height() + 7) / 8);
    pass("volumes.comp").dispatch(recording, resources(nullptr), std::as_bytes(std::span(&push, 1)), casters[0], casters[1]);
    recording.endPass();
}

void ClusterHierarchy::recordPass(Recording& recording, uint32_t which, bool counters) const {
    const std::vector<Binding> all = resources(nullptr);
    const ExamplePush push = inputs_.push();
    const auto bytes = std::as_bytes(std::span(&push, 1));
    const std::string name = options_.layers ? "traverse_layers.comp" : "traverse.comp";
    const ComputePass& traverse = pass(counters ? name + ".counters" : name, 3, which);
    recording.beginPass(which == 1 ? "cluster_expand" : "cluster_finish");
    if (which == 1) {
        traverse.dispatch(recording, all, bytes, options_.groups);
    } else {
        pass("finish_size.comp").dispatch(recording, all, {}, 1);
        recording.barrier();
        traverse.dispatchIndirect(recording, all, bytes, header_, offsetof(GnoClusterHeader, groups));
    }
    recording.endPass();
}

void ClusterHierarchy::recordMerge(Recording& recording, const Image& visibility) const {
    recording.beginPass("cluster_merge");
    pass(options_.layers ? "merge_layers.comp" : "merge.comp")
        .dispatch(recording, resources(&visibility), {}, (inputs_.width() + 7) / 8, (inputs_.height() + 7) / 8);
    recording.endPass();
}

void ClusterHierarchy::record(Recording& recording, const Image& visibility) const {
    recordBuild(recording);
    recordSetUp(recording);
    recordPass(recording, 1, false);
    if (options_.split > 0) recordPass(recording, 2, false);
    recordMerge(recording, visibility);
}

uint32_t ClusterHierarchy::occupied() const {
    uint32_t count = 0;
    const auto words = masks_.downloadAs<uint32_t>();  // a buffer's size is rounded up: what follows the last word is nobody's
    for (uint32_t i = 0; i < gnoClusterWordCount(layout_); ++i) count += uint32_t(std::popcount(words[i]));
    return count;
}

ClusterCounters ClusterHierarchy::count(const Image& visibility) {
    ClusterCounters counters;
    {  // the traversal clears bits, so the tree is looked at before it
        Recording recording(inputs_.device());
        recordBuild(recording);
        recording.submit();
        counters.occupiedNodes = occupied();
        counters.boxes = header_.downloadAs<GnoClusterHeader>().front().boxCount;
    }
    totals_.fill(0);
    steps_ = Buffer(inputs_.device(), 4 * std::max<uint64_t>(inputs_.triangleCount(), options_.split > 0 ? options_.jobCapacity : 0));
    steps_.fill(0);
    counts_.clear(vk::ClearColorValue(0u, 0u, 0u, 0u));
    const auto steps = [&](uint32_t jobs) {
        std::vector<uint32_t> all = steps_.downloadAs<uint32_t>();
        all.resize(jobs);
        steps_.fill(0);
        return all;
    };
    {  // the passes are submitted apart: both write gnoSteps
        Recording recording(inputs_.device());
        recordSetUp(recording);
        recordPass(recording, 1, true);
        recording.submit();
    }
    counters.expandSteps = steps(inputs_.triangleCount());
    counters.jobs = header_.downloadAs<GnoClusterHeader>().front().jobCount;
    Recording recording(inputs_.device());
    if (options_.split > 0) recordPass(recording, 2, true);
    recordMerge(recording, visibility);
    recording.submit();
    if (options_.split > 0) counters.finishSteps = steps(std::min(counters.jobs, options_.jobCapacity));
    const auto words = totals_.downloadAs<uint32_t>();
    const auto total = [&](uint32_t at) { return uint64_t(words[2 * at + 1]) << 32 | words[2 * at]; };
    counters.nodeTests = total(0);
    counters.planeTests = total(1);
    counters.leafTests = total(2);
    counters.exactCalls = total(3);
    counters.accepted = total(4);
    counters.testsOfPixel = counts_.downloadAs<uint32_t>();
    return counters;
}

std::vector<glm::uvec3> ClusterHierarchy::sums() const {
    const auto words = sums_.downloadAs<glm::uvec4>();
    std::vector<glm::uvec3> result(size_t(inputs_.width()) * inputs_.height());
    for (size_t i = 0; i < result.size(); ++i)
        for (int channel = 0; channel < 3; ++channel)
            result[i][channel] = (words[i].w >> channel & 1u) != 0 ? GNO_TRANSMITTANCE_OPAQUE : words[i][channel];
    return result;
}

NamedNumbers ClusterHierarchy::bytes() const {
    NamedNumbers result{{"masks", masks_.bytes()}, {"shade", shade_.bytes()}, {"volumes", volumes_.bytes() + info_.bytes()}};
    if (layout_.form != GNO_CLUSTER_IMPLICIT) result.push_back({"bounds", low_.bytes() + high_.bytes()});
    if (layout_.form == GNO_CLUSTER_COMPACT) result.push_back({"pointers", pointers_.bytes()});
    if (options_.split > 0) result.push_back({"jobs", jobs_.bytes()});
    if (options_.layers) result.push_back({"materials", inputs_.materials().bytes() + sums_.bytes()});
    return result;
}

std::vector<DumpedBuffer> ClusterHierarchy::dump() const {
    const auto words = [](const Buffer& buffer, uint64_t count) {  // the buffer itself may be longer
        std::vector<std::byte> bytes = buffer.download();
        bytes.resize(4 * count);
        return bytes;
    };
    const uint64_t masks = gnoClusterWordCount(layout_);
    const uint32_t boxWords = layout_.form == GNO_CLUSTER_FLAT ? 1 : 3;
    std::vector<DumpedBuffer> result{
        {"frame", "GnoClusterFrame, GnoClusterLayout", frame_.download(), uint32_t(frame_.bytes() / 4)},
        {"header", "GnoClusterHeader", header_.download(), sizeof(GnoClusterHeader) / 4},
        {"slices", "float start[slices + 1]", words(slices_, uint64_t(gnoClusterSlices(layout_)) + 1)},
        {"masks", "uint word[words]: as the traversal left them, without the nodes that were accepted", words(masks_, masks)},
        {"volumes", "vec4 plane[7 * casters]", words(volumes_, 28 * uint64_t(inputs_.triangleCount())), 28}};
    if (layout_.form != GNO_CLUSTER_IMPLICIT) {
        for (const auto& [name, buffer] : {std::pair("low", &low_), std::pair("high", &high_)}) {
            uint64_t boxes = gnoClusterNodeCount(layout_);
            if (layout_.form == GNO_CLUSTER_COMPACT) boxes = std::min(options_.boxCapacity, header_.downloadAs<GnoClusterHeader>().front().boxCount);
            result.push_back({name, layout_.form == GNO_CLUSTER_FLAT ? "float depth[nodes]" : "float xyz[3 * boxes]",
                              words(*buffer, boxWords * boxes), boxWords});
        }
    }
    if (layout_.form == GNO_CLUSTER_COMPACT) result.push_back({"pointers", "uvec2 firstBoxAndMask[words]", words(pointers_, 2 * masks), 2});
    Recording recording(inputs_.device());
    recordBuild(recording);  // gives the accepted nodes back
    recording.submit();
    result.push_back({"masks_built", "uint word[words]: as built, a bit for each occupied child", words(masks_, masks)});
    return result;
}

}  // namespace gno::host
