// SPDX-License-Identifier: MIT
// A shader that was compiled into this program at build time, and what its SPIR-V says of its interface.
#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host_min/vulkan/vulkan.hpp"

namespace gno::host {

/// The SPIR-V of glsl/NAME ("top/examples/build.comp", with ".counters" behind it for the instrumented variant). Throws std::logic_error
/// when the build has no such shader.
std::span<const uint32_t> embeddedShader(std::string_view name);
std::vector<std::string> embeddedShaderNames();

struct ShaderBinding {
    std::string name;  ///< of the instance: gnoTopPlanes
    uint32_t set, binding;
    vk::DescriptorType type;
};

struct ShaderInterface {
    vk::ShaderStageFlagBits stage;
    std::vector<ShaderBinding> bindings;
    uint32_t pushConstantBytes = 0;
    std::map<uint32_t, std::string> specialization;  ///< constant id -> name
};

ShaderInterface reflect(std::span<const uint32_t> spirv);

}  // namespace gno::host
