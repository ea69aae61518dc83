// SPDX-License-Identifier: MIT
// Compute and graphics passes. Pipeline layouts come from the SPIR-V, resources are given by their names in the shader, so a module whose
// binding numbers were overridden needs no change here. The caller records and submits; a pass adds no barrier of its own.
#pragma once
#include <initializer_list>
#include <map>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "glsl/core/pass.hpp"
#include "host_min/vulkan/shader.hpp"

namespace gno::host {

class AccelerationStructure;
class Buffer;
class Device;
class Image;
class Recording;

/// Some bytes of a buffer; the offset is a multiple of the device's minStorageBufferOffsetAlignment (256 is, everywhere).
struct BufferPart {
    const Buffer* buffer;
    uint64_t offset, bytes;
};

struct Binding {
    std::string_view name;
    std::variant<const Buffer*, const Image*, const AccelerationStructure*, BufferPart> resource;
};

using Specialization = std::map<uint32_t, uint32_t>;  ///< constant id -> 32-bit value; ids that the shader lacks are ignored

/// The same by the constants' names in the shaders (all stages), kGroupSize: the size of the work group. Throws std::logic_error for a name that
/// none of them has.
Specialization specialize(std::span<const std::string_view> shaders, std::span<const Constant> constants);

/// Descriptor sets of one pass, written once. What they hold must outlive them.
class BoundSets {
public:
    BoundSets() = default;

private:
    friend class PassLayout;
    vk::raii::DescriptorPool pool_{nullptr};
    std::vector<vk::DescriptorSet> sets_;
};

/// Descriptor set layouts and pipeline layout of one or two shader stages.
class PassLayout {
public:
    PassLayout(const Device& device, std::span<const ShaderInterface> stages);
    [[nodiscard]] vk::PipelineLayout handle() const { return *layout_; }
    /// Allocates and fills all sets. Every binding of the shader must be given; others are ignored.
    [[nodiscard]] BoundSets bound(std::span<const Binding> resources) const;
    /// Binds and pushes, no more.
    void bind(Recording& recording, vk::PipelineBindPoint point, const BoundSets& sets, std::span<const std::byte> push) const;
    /// The sets live as long as the recording.
    void keep(Recording& recording, BoundSets sets) const;
    /// bind() with sets that live as long as the recording.
    void bind(Recording& recording, vk::PipelineBindPoint point, std::span<const Binding> resources, std::span<const std::byte> push) const;

private:
    const Device* device_;
    std::vector<ShaderBinding> bindings_;
    vk::ShaderStageFlags pushStages_;
    uint32_t pushBytes_ = 0;
    vk::raii::Sampler nearest_{nullptr};  // of every combined image sampler: shaders fetch texels
    std::vector<vk::raii::DescriptorSetLayout> sets_;
    vk::raii::PipelineLayout layout_{nullptr};
};

class ComputePass {
public:
    ComputePass(const Device& device, std::string_view shader, const Specialization& constants = {});
    ComputePass(const Device& device, std::span<const uint32_t> spirv, const Specialization& constants = {});
    void dispatch(Recording& recording, std::span<const Binding> resources, std::span<const std::byte> push, uint32_t groupsX,
                  uint32_t groupsY = 1) const;
    /// The group counts are three words of `arguments` at `offset`, written by an earlier dispatch.
    void dispatchIndirect(Recording& recording, std::span<const Binding> resources, std::span<const std::byte> push, const Buffer& arguments,
                          uint64_t offset) const;

    [[nodiscard]] const PassLayout& layout() const { return layout_; }
    [[nodiscard]] vk::Pipeline pipeline() const { return *pipeline_; }

private:
    PassLayout layout_;
    vk::raii::Pipeline pipeline_{nullptr};
};

/// A vertex and a fragment shader over colour attachments and, with depth, a reversed depth buffer (clear 0, greater passes); without a fragment
/// shader a depth buffer alone. Triangles, no culling.
class RasterPass {
public:
    RasterPass(const Device& device, std::string_view vertex, std::string_view fragment, std::span<const vk::Format> colors, bool depth,
               const Specialization& constants = {});
    struct Target {
        const Image* image;
        vk::ClearColorValue clear;
    };
    /// Clears the attachments (in the general layout) and draws `vertices` vertices.
    void draw(Recording& recording, std::span<const Target> colors, const Image* depth, std::span<const Binding> resources,
              std::span<const std::byte> push, uint32_t vertices) const;
    /// Without a fragment shader: clears one layer of a depth array (in the general layout) and draws into it; the instance index is the layer's.
    /// `slopeBias` is Vulkan's depthBiasSlopeFactor.
    void drawDepth(Recording& recording, const Image& depth, uint32_t layer, float slopeBias, std::span<const Binding> resources,
                   std::span<const std::byte> push, uint32_t vertices) const;

    /// The same two with sets that were made before.
    void draw(Recording& recording, std::span<const Target> colors, const Image* depth, const BoundSets& sets, std::span<const std::byte> push,
              uint32_t vertices) const;
    void drawDepth(Recording& recording, const Image& depth, uint32_t layer, float slopeBias, const BoundSets& sets, std::span<const std::byte> push,
                   uint32_t vertices) const;
    [[nodiscard]] const PassLayout& layout() const { return layout_; }

private:
    void drawInto(Recording& recording, const vk::RenderingInfo& rendering, float slopeBias, const BoundSets& sets, std::span<const std::byte> push,
                  uint32_t vertices, uint32_t instance) const;

    PassLayout layout_;
    vk::raii::Pipeline pipeline_{nullptr};
    bool depthOnly_;
};

}  // namespace gno::host
