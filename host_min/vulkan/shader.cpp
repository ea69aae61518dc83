// SPDX-License-Identifier: MIT
#include "host_min/vulkan/shader.hpp"

#include <algorithm>
#include <spirv_cross/spirv_cross.hpp>
#include <stdexcept>

namespace gno::host {

// Written by the build (host_min/shaders.cmake): one entry per shader, sorted by name.
struct EmbeddedShader {
    const char* name;
    const uint32_t* first;
    const uint32_t* last;
};
extern const EmbeddedShader kEmbeddedShaders[];
extern const size_t kEmbeddedShaderCount;

std::span<const uint32_t> embeddedShader(std::string_view name) {
    for (size_t i = 0; i < kEmbeddedShaderCount; ++i)
        if (kEmbeddedShaders[i].name == name) return {kEmbeddedShaders[i].first, kEmbeddedShaders[i].last};
    throw std::logic_error("no shader of this name was built in: " + std::string(name));
}

std::vector<std::string> embeddedShaderNames() {
    std::vector<std::string> names;
    for (size_t i = 0; i < kEmbeddedShaderCount; ++i) names.emplace_back(kEmbeddedShaders[i].name);
    return names;
}

ShaderInterface reflect(std::span<const uint32_t> spirv) {
    const spirv_cross::Compiler compiler(spirv.data(), spirv.size());
    ShaderInterface result{};
    switch (compiler.get_execution_model()) {
        case spv::ExecutionModelGLCompute:
            result.stage = vk::ShaderStageFlagBits::eCompute;
            break;
        case spv::ExecutionModelVertex:
            result.stage = vk::ShaderStageFlagBits::eVertex;
            break;
        case spv::ExecutionModelFragment:
            result.stage = vk::ShaderStageFlagBits::eFragment;
            break;
        case spv::ExecutionModelGeometry:
            result.stage = vk::ShaderStageFlagBits::eGeometry;
            break;
        default:
            throw std::logic_error("a shader stage that is not in use here");
    }
    const spirv_cross::ShaderResources resources = compiler.get_shader_resources();
    const auto add = [&](const auto& list, vk::DescriptorType type) {
        for (const spirv_cross::Resource& resource : list) {
            std::string name = compiler.get_name(resource.id);
            if (name.empty()) name = resource.name;
            result.bindings.push_back({std::move(name), compiler.get_decoration(resource.id, spv::DecorationDescriptorSet),
                                       compiler.get_decoration(resource.id, spv::DecorationBinding), type});
        }
    };
    add(resources.storage_buffers, vk::DescriptorType::eStorageBuffer);
    add(resources.uniform_buffers, vk::DescriptorType::eUniformBuffer);
    add(resources.storage_images, vk::DescriptorType::eStorageImage);
    add(resources.acceleration_structures, vk::DescriptorType::eAccelerationStructureKHR);
    add(resources.sampled_images, vk::DescriptorType::eCombinedImageSampler);
    for (const spirv_cross::Resource& resource : resources.push_constant_buffers)
        result.pushConstantBytes = uint32_t(compiler.get_declared_struct_size(compiler.get_type(resource.base_type_id)));
    for (const spirv_cross::SpecializationConstant& constant : compiler.get_specialization_constants())
        result.specialization[constant.constant_id] = compiler.get_name(constant.id);
    spirv_cross::SpecializationConstant size[3];
    compiler.get_work_group_size_specialization_constants(size[0], size[1], size[2]);
    if (size[0].id != 0) result.specialization[size[0].constant_id] = "kGroupSize";  // the language gives it no name
    return result;
}

}  // namespace gno::host
