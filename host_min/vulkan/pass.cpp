// SPDX-License-Identifier: MIT
#include "host_min/vulkan/pass.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>

#include "host_min/vulkan/acceleration_structure.hpp"
#include "host_min/vulkan/buffer.hpp"
#include "host_min/vulkan/device.hpp"
#include "host_min/vulkan/image.hpp"
#include "host_min/vulkan/recording.hpp"

namespace gno::host {
namespace {

/// One stage's module and specialization, kept alive until its pipeline exists.
struct Stage {
    ShaderInterface interface;
    vk::raii::ShaderModule module;
    std::vector<vk::SpecializationMapEntry> entries;
    std::vector<uint32_t> values;
    vk::SpecializationInfo specialization;

    Stage(const Device& device, std::span<const uint32_t> spirv, const Specialization& constants)
        : interface(reflect(spirv)), module(device.handle(), vk::ShaderModuleCreateInfo({}, spirv.size_bytes(), spirv.data())) {
        for (const auto& [id, value] : constants) {
            if (!interface.specialization.contains(id)) continue;
            entries.emplace_back(id, uint32_t(4 * values.size()), 4);
            values.push_back(value);
        }
        specialization = vk::SpecializationInfo(uint32_t(entries.size()), entries.data(), 4 * values.size(), values.data());
    }
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    [[nodiscard]] vk::PipelineShaderStageCreateInfo info() const { return {{}, interface.stage, *module, "main", &specialization}; }
};

std::vector<ShaderInterface> interfacesOf(std::string_view vertex, std::string_view fragment) {
    std::vector<ShaderInterface> result{reflect(embeddedShader(vertex))};
    if (!fragment.empty()) result.push_back(reflect(embeddedShader(fragment)));
    return result;
}

}  // namespace

PassLayout::PassLayout(const Device& device, std::span<const ShaderInterface> stages) : device_(&device) {
    std::map<std::pair<uint32_t, uint32_t>, vk::DescriptorSetLayoutBinding> byPlace;
    for (const ShaderInterface& stage : stages) {
        for (const ShaderBinding& binding : stage.bindings) {
            auto [at, isNew] = byPlace.try_emplace({binding.set, binding.binding}, binding.binding, binding.type, 1, stage.stage);
            if (isNew)
                bindings_.push_back(binding);
            else if (at->second.descriptorType != binding.type)
                throw std::logic_error("two stages disagree about the binding of " + binding.name);
            else
                at->second.stageFlags |= stage.stage;
        }
        if (stage.pushConstantBytes > 0) pushStages_ |= stage.stage;
        pushBytes_ = std::max(pushBytes_, stage.pushConstantBytes);
    }
    for (auto& [place, binding] : byPlace) {
        if (binding.descriptorType != vk::DescriptorType::eCombinedImageSampler) continue;
        if (!*nearest_) nearest_ = vk::raii::Sampler(device.handle(), vk::SamplerCreateInfo());
        binding.setImmutableSamplers(*nearest_);
    }
    const uint32_t setCount = byPlace.empty() ? 0 : byPlace.rbegin()->first.first + 1;
    std::vector<vk::DescriptorSetLayout> handles;
    for (uint32_t set = 0; set < setCount; ++set) {
        std::vector<vk::DescriptorSetLayoutBinding> list;
        for (const auto& [place, binding] : byPlace)
            if (place.first == set) list.push_back(binding);
        sets_.emplace_back(device.handle(), vk::DescriptorSetLayoutCreateInfo({}, list));
        handles.push_back(*sets_.back());
    }
    const vk::PushConstantRange range(pushStages_, 0, pushBytes_);
    vk::PipelineLayoutCreateInfo info({}, handles);
    if (pushBytes_ > 0) info.setPushConstantRanges(range);
    layout_ = vk::raii::PipelineLayout(device.handle(), info);
}

BoundSets PassLayout::bound(std::span<const Binding> resources) const {
    BoundSets result;
    if (sets_.empty()) return result;
    std::map<vk::DescriptorType, uint32_t> counts;
    for (const ShaderBinding& binding : bindings_) ++counts[binding.type];
    std::vector<vk::DescriptorPoolSize> sizes;
    for (const auto& [type, count] : counts) sizes.emplace_back(type, count);
    if (sizes.empty()) sizes.emplace_back(vk::DescriptorType::eStorageBuffer, 1);  // empty sets, but sets
    result.pool_ = vk::raii::DescriptorPool(device_->handle(), vk::DescriptorPoolCreateInfo({}, uint32_t(sets_.size()), sizes));
    std::vector<vk::DescriptorSetLayout> layouts;
    for (const auto& layout : sets_) layouts.push_back(*layout);
    const vk::DescriptorSetAllocateInfo info(*result.pool_, layouts);
    result.sets_ = (*device_->handle()).allocateDescriptorSets(info, *device_->handle().getDispatcher());  // freed with their pool

    std::vector<vk::DescriptorBufferInfo> buffers(bindings_.size());
    std::vector<vk::DescriptorImageInfo> images(bindings_.size());
    std::vector<vk::AccelerationStructureKHR> structures(bindings_.size());
    std::vector<vk::WriteDescriptorSetAccelerationStructureKHR> structureWrites(bindings_.size());
    std::vector<vk::WriteDescriptorSet> writes;
    for (size_t i = 0; i < bindings_.size(); ++i) {
        const ShaderBinding& wanted = bindings_[i];
        const auto given = std::find_if(resources.begin(), resources.end(), [&](const Binding& b) { return b.name == wanted.name; });
        if (given == resources.end()) throw std::logic_error("nothing bound to " + wanted.name);
        vk::WriteDescriptorSet write(result.sets_[wanted.set], wanted.binding, 0, 1, wanted.type);
        if (const auto* buffer = std::get_if<const Buffer*>(&given->resource)) {
            buffers[i] = vk::DescriptorBufferInfo((*buffer)->handle(), 0, VK_WHOLE_SIZE);
            write.pBufferInfo = &buffers[i];
        } else if (const auto* part = std::get_if<BufferPart>(&given->resource)) {
            buffers[i] = vk::DescriptorBufferInfo(part->buffer->handle(), part->offset, part->bytes);
            write.pBufferInfo = &buffers[i];
        } else if (const auto* structure = std::get_if<const AccelerationStructure*>(&given->resource)) {
            structures[i] = (*structure)->handle();
            structureWrites[i] = vk::WriteDescriptorSetAccelerationStructureKHR(1, &structures[i]);
            write.pNext = &structureWrites[i];
        } else {
            images[i] = vk::DescriptorImageInfo({}, std::get<const Image*>(given->resource)->view(), vk::ImageLayout::eGeneral);
            write.pImageInfo = &images[i];
        }
        writes.push_back(write);
    }
    device_->handle().updateDescriptorSets(writes, {});
    return result;
}

void PassLayout::bind(Recording& recording, vk::PipelineBindPoint point, const BoundSets& sets, std::span<const std::byte> push) const {
    if (!sets.sets_.empty()) recording.commands().bindDescriptorSets(point, *layout_, 0, sets.sets_, {});
    if (pushBytes_ == 0) return;
    if (push.size() < pushBytes_) throw std::logic_error("push constants are smaller than the shader's block");
    recording.commands().pushConstants(*layout_, pushStages_, 0, pushBytes_, push.data());
}

void PassLayout::bind(Recording& recording, vk::PipelineBindPoint point, std::span<const Binding> resources, std::span<const std::byte> push) const {
    BoundSets sets = bound(resources);
    bind(recording, point, sets, push);
    keep(recording, std::move(sets));
}

void PassLayout::keep(Recording& recording, BoundSets sets) const { recording.keep(std::move(sets.pool_)); }

Specialization specialize(std::span<const std::string_view> shaders, std::span<const Constant> constants) {
    std::map<std::string, uint32_t, std::less<>> ids;
    for (const std::string_view shader : shaders)
        for (const auto& [id, name] : reflect(embeddedShader(shader)).specialization) ids[name] = id;
    Specialization result;
    for (const Constant& constant : constants) {
        const auto found = ids.find(constant.name);
        if (found == ids.end()) throw std::logic_error(std::string(shaders.front()) + " has no constant " + std::string(constant.name));
        result[found->second] = constant.value;
    }
    return result;
}

ComputePass::ComputePass(const Device& device, std::string_view shader, const Specialization& constants)
    : ComputePass(device, embeddedShader(shader), constants) {}

ComputePass::ComputePass(const Device& device, std::span<const uint32_t> spirv, const Specialization& constants)
    : layout_(device, std::array{reflect(spirv)}) {
    const Stage stage(device, spirv, constants);
    pipeline_ = vk::raii::Pipeline(device.handle(), nullptr, vk::ComputePipelineCreateInfo({}, stage.info(), layout_.handle()));
}

void ComputePass::dispatch(Recording& recording, std::span<const Binding> resources, std::span<const std::byte> push, uint32_t groupsX,
                           uint32_t groupsY) const {
    recording.commands().bindPipeline(vk::PipelineBindPoint::eCompute, *pipeline_);
    layout_.bind(recording, vk::PipelineBindPoint::eCompute, resources, push);
    recording.commands().dispatch(groupsX, groupsY, 1);
}

void ComputePass::dispatchIndirect(Recording& recording, std::span<const Binding> resources, std::span<const std::byte> push,
                                   const Buffer& arguments, uint64_t offset) const {
    recording.commands().bindPipeline(vk::PipelineBindPoint::eCompute, *pipeline_);
    layout_.bind(recording, vk::PipelineBindPoint::eCompute, resources, push);
    recording.commands().dispatchIndirect(arguments.handle(), offset);
}

RasterPass::RasterPass(const Device& device, std::string_view vertex, std::string_view fragment, std::span<const vk::Format> colors, bool depth,
                       const Specialization& constants)
    : layout_(device, interfacesOf(vertex, fragment)), depthOnly_(fragment.empty()) {
    const Stage vertexStage(device, embeddedShader(vertex), constants);
    std::optional<Stage> fragmentStage;
    std::vector stages{vertexStage.info()};
    if (!depthOnly_) stages.push_back(fragmentStage.emplace(device, embeddedShader(fragment), constants).info());
    const vk::PipelineVertexInputStateCreateInfo vertexInput;
    const vk::PipelineInputAssemblyStateCreateInfo assembly({}, vk::PrimitiveTopology::eTriangleList);
    const vk::PipelineViewportStateCreateInfo viewport({}, 1, nullptr, 1, nullptr);
    vk::PipelineRasterizationStateCreateInfo raster;
    raster.lineWidth = 1;
    raster.depthBiasEnable = depthOnly_;
    const vk::PipelineMultisampleStateCreateInfo multisample;
    const vk::PipelineDepthStencilStateCreateInfo depthState({}, depth, depth, vk::CompareOp::eGreater);
    vk::PipelineColorBlendAttachmentState opaque;
    using Write = vk::ColorComponentFlagBits;
    opaque.colorWriteMask = Write::eR | Write::eG | Write::eB | Write::eA;
    const std::vector<vk::PipelineColorBlendAttachmentState> attachments(colors.size(), opaque);
    const vk::PipelineColorBlendStateCreateInfo blend({}, VK_FALSE, {}, attachments);
    std::vector dynamic{vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    if (depthOnly_) dynamic.push_back(vk::DynamicState::eDepthBias);
    const vk::PipelineDynamicStateCreateInfo dynamicState({}, dynamic);
    vk::PipelineRenderingCreateInfo rendering(0, colors);
    if (depth) rendering.depthAttachmentFormat = vk::Format::eD32Sfloat;
    vk::GraphicsPipelineCreateInfo info({}, stages, &vertexInput, &assembly, nullptr, &viewport, &raster, &multisample, &depthState, &blend,
                                        &dynamicState, layout_.handle());
    info.pNext = &rendering;
    pipeline_ = vk::raii::Pipeline(device.handle(), nullptr, info);
}

void RasterPass::draw(Recording& recording, std::span<const Target> colors, const Image* depth, std::span<const Binding> resources,
                      std::span<const std::byte> push, uint32_t vertices) const {
    BoundSets sets = layout_.bound(resources);
    draw(recording, colors, depth, sets, push, vertices);
    layout_.keep(recording, std::move(sets));
}

void RasterPass::drawDepth(Recording& recording, const Image& depth, uint32_t layer, float slopeBias, std::span<const Binding> resources,
                           std::span<const std::byte> push, uint32_t vertices) const {
    BoundSets sets = layout_.bound(resources);
    drawDepth(recording, depth, layer, slopeBias, sets, push, vertices);
    layout_.keep(recording, std::move(sets));
}

void RasterPass::draw(Recording& recording, std::span<const Target> colors, const Image* depth, const BoundSets& sets,
                      std::span<const std::byte> push, uint32_t vertices) const {
    std::vector<vk::RenderingAttachmentInfo> attachments;
    for (const Target& target : colors)
        attachments.emplace_back(target.image->view(), vk::ImageLayout::eGeneral, vk::ResolveModeFlagBits::eNone, nullptr,
                                 vk::ImageLayout::eUndefined, vk::AttachmentLoadOp::eClear, vk::AttachmentStoreOp::eStore,
                                 vk::ClearValue(target.clear));
    const vk::Extent2D extent = colors.front().image->extent();
    vk::RenderingInfo rendering({}, vk::Rect2D({0, 0}, extent), 1, 0, attachments);
    vk::RenderingAttachmentInfo depthAttachment;
    if (depth) {
        depthAttachment = vk::RenderingAttachmentInfo(depth->view(), vk::ImageLayout::eGeneral, vk::ResolveModeFlagBits::eNone, nullptr,
                                                      vk::ImageLayout::eUndefined, vk::AttachmentLoadOp::eClear, vk::AttachmentStoreOp::eDontCare,
                                                      vk::ClearValue(vk::ClearDepthStencilValue(0.0f, 0)));
        rendering.pDepthAttachment = &depthAttachment;
    }
    drawInto(recording, rendering, 0, sets, push, vertices, 0);
}

void RasterPass::drawDepth(Recording& recording, const Image& depth, uint32_t layer, float slopeBias, const BoundSets& sets,
                           std::span<const std::byte> push, uint32_t vertices) const {
    const vk::RenderingAttachmentInfo attachment(depth.layer(layer), vk::ImageLayout::eGeneral, vk::ResolveModeFlagBits::eNone, nullptr,
                                                 vk::ImageLayout::eUndefined, vk::AttachmentLoadOp::eClear, vk::AttachmentStoreOp::eStore,
                                                 vk::ClearValue(vk::ClearDepthStencilValue(0.0f, 0)));
    vk::RenderingInfo rendering({}, vk::Rect2D({0, 0}, depth.extent()), 1, 0);
    rendering.pDepthAttachment = &attachment;
    drawInto(recording, rendering, slopeBias, sets, push, vertices, layer);
}

void RasterPass::drawInto(Recording& recording, const vk::RenderingInfo& rendering, float slopeBias, const BoundSets& sets,
                          std::span<const std::byte> push, uint32_t vertices, uint32_t instance) const {
    const vk::Extent2D extent = rendering.renderArea.extent;
    const vk::CommandBuffer commands = recording.commands();
    commands.beginRendering(rendering);
    commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline_);
    commands.setViewport(0, vk::Viewport(0, 0, float(extent.width), float(extent.height), 0, 1));
    commands.setScissor(0, vk::Rect2D({0, 0}, extent));
    if (depthOnly_) commands.setDepthBias(0, 0, slopeBias);
    layout_.bind(recording, vk::PipelineBindPoint::eGraphics, sets, push);
    commands.draw(vertices, 1, 0, instance);
    commands.endRendering();
}

}  // namespace gno::host
