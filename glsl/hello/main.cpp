// SPDX-License-Identifier: MIT
// The smallest engine that uses this folder: some thousand triangles, two lights, two techniques. It walks
// the pass lists of top/passes.hpp and forest/passes.hpp, asks with a shader of its own (ask.comp), prints
// the mask, writes a PNG, and compares every answer with a brute-force loop over all casters.
//
//   hello SPIRV_FOLDER [OUT.png]     compiled examples (top/examples/build.comp.spv, ...) and hello/*.spv
//
// Exit status: 0 all answers are equal, 1 some differ, 2 no device or no file.
#include <vulkan/vulkan_raii.hpp>

#include <cstdio>
#include <cstring>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

#include "../core/grid.hpp"
#include "../core/passes.hpp"
#include "../forest/passes.hpp"
#include "../top/passes.hpp"
#include "scene.hpp"

namespace {

constexpr auto kStorage = vk::DescriptorType::eStorageBuffer;
constexpr std::uint32_t kWidth = 320, kHeight = 200;

// --- a little Vulkan
// -------------------------------------------------------------------------------------------

struct Gpu {
    vk::raii::Context context;
    vk::raii::Instance instance{nullptr};
    vk::raii::PhysicalDevice physical{nullptr};
    vk::raii::Device device{nullptr};
    vk::raii::Queue queue{nullptr};
    vk::raii::CommandPool pool{nullptr};
    std::uint32_t family = 0;

    Gpu() {
        const vk::ApplicationInfo app("hello gnomon", 1, nullptr, 0, VK_API_VERSION_1_2);
        instance = vk::raii::Instance(context, vk::InstanceCreateInfo({}, &app));
        vk::raii::PhysicalDevices all(instance);
        if (all.empty()) throw std::runtime_error("no Vulkan device");
        physical = std::move(all.front());
        const auto families = physical.getQueueFamilyProperties();
        while (family < families.size() && !(families[family].queueFlags & vk::QueueFlagBits::eCompute))
            ++family;
        if (family == families.size()) throw std::runtime_error("no compute queue");
        const float priority = 1;
        const vk::DeviceQueueCreateInfo wanted({}, family, 1, &priority);
        device = vk::raii::Device(physical, vk::DeviceCreateInfo({}, wanted));  // no feature, no extension
        queue = vk::raii::Queue(device, family, 0);
        pool = vk::raii::CommandPool(device, vk::CommandPoolCreateInfo({}, family));
    }
};

/// A buffer that the host sees; an engine would keep most of them device-local.
struct Buffer {
    vk::raii::Buffer handle{nullptr};
    vk::raii::DeviceMemory memory{nullptr};
    void* data = nullptr;

    Buffer() = default;
    Buffer(const Gpu& gpu, std::uint64_t bytes, std::uint32_t usage) {
        handle = vk::raii::Buffer(gpu.device, vk::BufferCreateInfo({}, bytes, vk::BufferUsageFlags(usage)));
        const auto needs = handle.getMemoryRequirements();
        const auto types = gpu.physical.getMemoryProperties();
        const auto wanted =
            vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent;
        std::uint32_t type = 0;
        while (!((needs.memoryTypeBits >> type) & 1u) ||
               (types.memoryTypes[type].propertyFlags & wanted) != wanted)
            ++type;
        memory = vk::raii::DeviceMemory(gpu.device, vk::MemoryAllocateInfo(needs.size, type));
        handle.bindMemory(*memory, 0);
        data = memory.mapMemory(0, VK_WHOLE_SIZE);
        std::memset(data, 0xCD, bytes);  // what the lists call First::anything may be anything
    }
    template <class T>
    void write(const std::vector<T>& values) {
        if (!values.empty()) std::memcpy(data, values.data(), sizeof(T) * values.size());
    }
};

using Buffers = std::map<std::string_view, Buffer>;

std::vector<std::uint32_t> readSpirv(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)), {});
    if (bytes.size() < 20 || bytes.size() % 4) throw std::runtime_error("no SPIR-V in " + path);
    std::vector<std::uint32_t> words(bytes.size() / 4);
    std::memcpy(words.data(), bytes.data(), bytes.size());
    return words;
}

/// Where a buffer is bound in our shader; the lists' arrays bring their own numbers.
struct Place {
    std::uint32_t set, binding;
    vk::DescriptorType type;
    const Buffer* buffer;
};

/// One pipeline layout and its sets for all passes of a list: a set layout may hold more than a shader uses.
struct Bound {
    std::vector<vk::raii::DescriptorSetLayout> layouts;
    vk::raii::PipelineLayout layout{nullptr};
    vk::raii::DescriptorPool pool{nullptr};
    std::vector<vk::DescriptorSet> sets;

    Bound(const Gpu& gpu, const std::vector<Place>& places, std::uint32_t pushBytes) {
        std::vector<vk::DescriptorPoolSize> sizes;
        std::uint32_t count = 0;
        for (const Place& place : places) {
            sizes.emplace_back(place.type, 1);
            count = std::max(count, place.set + 1);
        }
        std::vector<vk::DescriptorSetLayout> handles;
        for (std::uint32_t set = 0; set < count; ++set) {
            std::vector<vk::DescriptorSetLayoutBinding> bindings;
            for (const Place& place : places)
                if (place.set == set)
                    bindings.emplace_back(place.binding, place.type, 1, vk::ShaderStageFlagBits::eCompute);
            layouts.emplace_back(gpu.device, vk::DescriptorSetLayoutCreateInfo({}, bindings));
            handles.push_back(*layouts.back());
        }
        const vk::PushConstantRange push(vk::ShaderStageFlagBits::eCompute, 0, pushBytes);
        layout = vk::raii::PipelineLayout(gpu.device, vk::PipelineLayoutCreateInfo({}, handles, push));
        pool = vk::raii::DescriptorPool(gpu.device, vk::DescriptorPoolCreateInfo({}, count, sizes));
        const vk::DescriptorSetAllocateInfo info(*pool, handles);
        sets = (*gpu.device).allocateDescriptorSets(info, *gpu.device.getDispatcher());
        for (const Place& place : places) {
            const vk::DescriptorBufferInfo range(*place.buffer->handle, 0, VK_WHOLE_SIZE);
            const vk::WriteDescriptorSet write(sets[place.set], place.binding, 0, 1, place.type, nullptr,
                                               &range);
            gpu.device.updateDescriptorSets(write, {});
        }
    }
};

/// `constants`: number and value of each.
vk::raii::Pipeline makePipeline(const Gpu& gpu, const Bound& bound, const std::string& path,
                                const std::vector<std::pair<std::uint32_t, std::uint32_t>>& constants) {
    const auto words = readSpirv(path);
    const vk::raii::ShaderModule module(gpu.device, vk::ShaderModuleCreateInfo({}, words));
    std::vector<vk::SpecializationMapEntry> entries;
    std::vector<std::uint32_t> values;
    for (const auto& [id, value] : constants) {
        entries.emplace_back(id, std::uint32_t(4 * values.size()), 4);
        values.push_back(value);
    }
    const vk::SpecializationInfo special(std::uint32_t(entries.size()), entries.data(), 4 * values.size(),
                                         values.data());
    const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *module, "main",
                                                  &special);
    return {gpu.device, nullptr, vk::ComputePipelineCreateInfo({}, stage, *bound.layout)};
}

// --- walking the lists
// -----------------------------------------------------------------------------------------

struct ExamplePush {  // of core/examples/frame.glsl
    float light[4], viewer[4];
    std::uint32_t size[2], count, seed, cull, planes, number;
};

/// Makes the buffers of a list of arrays that are not there yet.
void makeArrays(const Gpu& gpu, const gno::ArrayList& arrays, Buffers& buffers) {
    for (const gno::Array& array : arrays)
        if (!buffers.contains(array.name))
            buffers.emplace(array.name, Buffer(gpu, array.bytes, gno::bufferUsage(array.usage)));
}

void append(std::vector<Place>& places, const gno::ArrayList& arrays, const Buffers& buffers) {
    for (const gno::Array& array : arrays)
        places.push_back({array.set, array.binding,
                          array.usage & gno::kUsageUniform ? vk::DescriptorType::eUniformBuffer
                                                           : vk::DescriptorType::eStorageBuffer,
                          &buffers.at(array.name)});
}

void barrier(const vk::raii::CommandBuffer& commands, const gno::MemoryBarrier& words) {
    const vk::MemoryBarrier memory(vk::AccessFlags(std::uint32_t(words.srcAccess)),
                                   vk::AccessFlags(std::uint32_t(words.dstAccess)));
    commands.pipelineBarrier(vk::PipelineStageFlags(std::uint32_t(words.srcStages)),
                             vk::PipelineStageFlags(std::uint32_t(words.dstStages)), {}, memory, {}, {});
}

/// Records every pass with the barrier before it. Pipelines are appended to `alive`.
void recordPasses(const Gpu& gpu, const vk::raii::CommandBuffer& commands, const gno::PassList& passes,
                  const Bound& bound, const Buffers& buffers, const std::string& spirv, ExamplePush push,
                  std::vector<vk::raii::Pipeline>& alive) {
    for (const gno::Pass& pass : passes) {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> constants;
        for (const gno::Constant& constant : pass.constants)
            constants.emplace_back(gno::constantId(constant.name), constant.value);
        alive.push_back(makePipeline(gpu, bound, spirv + "/" + std::string(pass.shader) + ".spv", constants));
        if (pass.before != gno::kBeforeNothing) barrier(commands, gno::barrierBefore(pass));
        push.number = pass.number;
        commands.bindPipeline(vk::PipelineBindPoint::eCompute, *alive.back());
        commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *bound.layout, 0, bound.sets, {});
        commands.pushConstants<ExamplePush>(*bound.layout, vk::ShaderStageFlagBits::eCompute, 0, push);
        if (pass.indirect.empty())
            commands.dispatch(pass.groups[0], pass.groups[1], pass.groups[2]);
        else
            commands.dispatchIndirect(*buffers.at(pass.indirect).handle, pass.indirectOffset);
    }
}

// --- the frame
// -------------------------------------------------------------------------------------------------

struct Frame {
    std::uint32_t casters = 0;
    std::vector<float> vertices;  // 9 per caster, on the grid
    std::vector<hello::Hit> hits;
    gno::Float3 viewer{}, low{}, high{};
};

using Light = std::array<float, 4>;

/// Pixels of a camera, by rays; your engine has a G-buffer.
Frame makeFrame(const gno::Grid& grid, const std::vector<hello::Triangle>& world, hello::Point eye) {
    Frame frame;
    frame.casters = std::uint32_t(world.size());
    std::vector<hello::Triangle> snapped;  // what is drawn has the same vertices as what casts
    frame.low = {1, 1, 1};
    frame.high = {-1, -1, -1};
    for (const hello::Triangle& triangle : world) {
        hello::Triangle onGrid;
        for (int corner = 0; corner < 3; ++corner) {
            const gno::Float3 p = grid.snap({triangle[corner][0], triangle[corner][1], triangle[corner][2]});
            for (int axis = 0; axis < 3; ++axis) {
                frame.vertices.push_back(p[axis]);
                onGrid[corner][axis] = p[axis];
                frame.low[axis] = std::min(frame.low[axis], p[axis]);
                frame.high[axis] = std::max(frame.high[axis], p[axis]);
            }
        }
        snapped.push_back(onGrid);
    }
    frame.viewer = grid.snap({eye[0], eye[1], eye[2]});
    const hello::Point from{frame.viewer[0], frame.viewer[1], frame.viewer[2]};
    const hello::Point forward = hello::unit(from * -1.0);
    const hello::Point right = hello::unit(hello::cross(forward, {0, 1, 0})),
                       up = hello::cross(right, forward);
    for (std::uint32_t y = 0; y < kHeight; ++y)
        for (std::uint32_t x = 0; x < kWidth; ++x) {
            const double across = (x + 0.5) / kWidth - 0.5,
                         down = ((y + 0.5) / kHeight - 0.5) * kHeight / kWidth;
            hello::Point where{};
            hello::Hit hit{};
            hit.primitive = hello::firstHit(snapped, from, forward + right * across + up * -down, where);
            for (int axis = 0; axis < 3; ++axis) hit.position[axis] = float(where[axis]);
            frame.hits.push_back(hit);
        }
    return frame;
}

enum class Ask { top, forest, bruteForce };

/// Builds, asks, and gives back one GNO_VISIBILITY_* per pixel.
std::vector<std::uint32_t> shade(const Gpu& gpu, const Frame& frame, Light light, Ask ask,
                                 const std::string& spirv) {
    Buffers buffers;
    const gno::LightCells cells{.casters = frame.casters,
                                .resolution = 32,
                                .faces = gno::forestFaces(light),
                                .viewCull = false};  // so no pass reads an image of view samples
    gno::ArrayList arrays = gno::casterArrays(frame.casters);
    gno::PassList passes = gno::casterStatePasses(frame.casters);
    const auto add = [&](const gno::ArrayList& more, const gno::PassList& list) {
        arrays.insert(arrays.end(), more.begin(), more.end());
        passes.insert(passes.end(), list.begin(), list.end());
    };
    if (ask == Ask::top) {
        add(gno::topArrays(frame.casters), gno::topBuildPasses(frame.casters, {}));
    } else if (ask == Ask::forest) {
        add(gno::forestArrays(cells, gno::forestFirstPool(frame.casters), {}),
            gno::forestBuildPasses(cells, {}));
    }
    makeArrays(gpu, arrays, buffers);
    buffers.at("gnoCasters").write(frame.vertices);
    if (ask == Ask::forest) {
        const gno::ForestGrid grid = gno::forestGrid(light, frame.low, frame.high, cells.resolution);
        std::memcpy(buffers.at("gnoForestGrid").data, &grid, sizeof grid);
    }
    ExamplePush push{};
    std::copy(light.begin(), light.end(), push.light);
    std::copy(frame.viewer.begin(), frame.viewer.end(), push.viewer);
    push.viewer[3] = 1;
    push.count = frame.casters;
    push.seed = 1;

    Buffer hits(gpu, sizeof(hello::Hit) * frame.hits.size(), gno::bufferUsage(gno::kUsageStorage));
    hits.write(frame.hits);
    Buffer mask(gpu, 4 * frame.hits.size(), gno::bufferUsage(gno::kUsageStorage));

    std::vector<Place> building;
    append(building, arrays, buffers);
    const Bound bound(gpu, building, sizeof(ExamplePush));
    std::vector<Place> asking{
        {0, 0, kStorage, &buffers.at("gnoCasters")}, {0, 1, kStorage, &hits}, {0, 2, kStorage, &mask}};
    const auto bind = [&](std::uint32_t binding, std::string_view name, vk::DescriptorType type = kStorage) {
        asking.push_back({0, binding, type, &buffers.at(name)});
    };
    if (ask != Ask::bruteForce) {
        bind(3, "gnoTopPlanes");
        bind(4, "gnoTopLinks");
        bind(5, "gnoTopHeader");
    }
    if (ask == Ask::forest) {
        bind(6, "gnoForestGrid", vk::DescriptorType::eUniformBuffer);
        bind(7, "gnoForestCells");
        bind(8, "gnoForestPairs");
    }
    struct AskPush {
        float light[4], viewer[4];
        std::uint32_t hits, casters;
    } question{};
    std::copy(light.begin(), light.end(), question.light);
    std::copy(push.viewer, push.viewer + 4, question.viewer);
    question.hits = std::uint32_t(frame.hits.size());
    question.casters = frame.casters;
    const Bound asked(gpu, asking, sizeof question);
    constexpr const char* names[] = {"ask_top", "ask_forest", "ask_brute_force"};
    const vk::raii::Pipeline query =
        makePipeline(gpu, asked, spirv + "/hello/" + names[int(ask)] + ".spv", {});

    const vk::raii::CommandBuffer commands = std::move(
        vk::raii::CommandBuffers(gpu.device, {*gpu.pool, vk::CommandBufferLevel::ePrimary, 1}).front());
    std::vector<vk::raii::Pipeline> alive;
    commands.begin(vk::CommandBufferBeginInfo());
    recordPasses(gpu, commands, passes, bound, buffers, spirv, push, alive);
    barrier(commands, gno::barrierBefore(gno::Pass{.before = gno::kBeforeShaders}));
    commands.bindPipeline(vk::PipelineBindPoint::eCompute, *query);
    commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *asked.layout, 0, asked.sets, {});
    commands.pushConstants<AskPush>(*asked.layout, vk::ShaderStageFlagBits::eCompute, 0, question);
    commands.dispatch(gno::groupsFor(frame.hits.size(), 64), 1, 1);
    const vk::MemoryBarrier toHost(vk::AccessFlagBits::eShaderWrite, vk::AccessFlagBits::eHostRead);
    commands.pipelineBarrier(vk::PipelineStageFlagBits::eComputeShader, vk::PipelineStageFlagBits::eHost, {},
                             toHost, {}, {});
    commands.end();
    gpu.queue.submit(vk::SubmitInfo({}, {}, *commands));
    gpu.queue.waitIdle();
    std::vector<std::uint32_t> result(frame.hits.size());
    std::memcpy(result.data(), mask.data, 4 * result.size());
    return result;
}

void print(const std::vector<std::uint32_t>& mask) {
    constexpr std::uint32_t columns = 80, rows = 25;
    for (std::uint32_t row = 0; row < rows; ++row) {
        std::string line;
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t x = column * kWidth / columns, y = row * kHeight / rows;
            line +=
                "#.- ?"[std::min(mask[y * kWidth + x], 4u)];  // shadow, lit, facing away, background, unknown
        }
        std::puts(line.c_str());
    }
}

void writePicture(const char* path, const std::vector<std::uint32_t>& mask) {
    constexpr unsigned char grey[] = {40, 235, 95, 150, 0};
    std::vector<unsigned char> pixels;
    for (const std::uint32_t answer : mask) pixels.push_back(grey[std::min(answer, 4u)]);
    if (!stbi_write_png(path, kWidth, kHeight, 1, pixels.data(), kWidth))
        throw std::runtime_error(std::string("cannot write ") + path);
}

int run(const std::string& spirv, const char* picture) {
    const Gpu gpu;
    const auto triangles = hello::makeScene();
    const gno::Double3 lamp{3.5, 6, 2.5};
    const hello::Point eye{2.5, 4.5, 7};
    const gno::Grid grid = gno::gridAround({-7, -2, -7}, {7, 8, 8});  // holds triangles, lamp and eye
    const Frame frame = makeFrame(grid, triangles, eye);
    const gno::Float3 at = grid.snap(lamp), sun = gno::snapDirection({-0.5, 0.8, 0.4});
    const Light lights[] = {{at[0], at[1], at[2], 1}, {sun[0], sun[1], sun[2], 0}};
    std::size_t different = 0;
    for (const Light& light : lights) {
        const auto truth = shade(gpu, frame, light, Ask::bruteForce, spirv);
        for (const auto& [name, ask] : {std::pair("d-hybrid", Ask::top), std::pair("forest", Ask::forest)}) {
            const auto mask = shade(gpu, frame, light, ask, spirv);
            std::size_t wrong = 0, dark = 0;
            for (std::size_t i = 0; i < mask.size(); ++i) {
                wrong += mask[i] != truth[i];
                dark += mask[i] == 0;
            }
            different += wrong;
            std::printf("%s, %s light: %u casters, %zu pixels, %zu in shadow, %zu differ from brute force\n",
                        name, light[3] == 0 ? "directional" : "point", frame.casters, mask.size(), dark,
                        wrong);
            if (&light == lights && ask == Ask::forest) {
                print(mask);
                writePicture(picture, mask);
            }
        }
    }
    return different == 0 ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
    if (count < 2 || count > 3) {
        std::fprintf(stderr, "usage: hello SPIRV_FOLDER [OUT.png]\n");
        return 2;
    }
    try {
        return run(arguments[1], count == 3 ? arguments[2] : "hello.png");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "hello: %s\n", error.what());
        return 2;
    }
}
