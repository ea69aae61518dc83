// SPDX-License-Identifier: MIT
#include "validation/support/shader_access.hpp"

#include <spirv_cross/spirv_cross.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

namespace gno::test {
namespace {

struct Instruction {
    uint32_t op;
    std::span<const uint32_t> words;  ///< all of it; 0 is the opcode
};

/// Instructions of each function, and of what stands before the first one (0).
std::map<uint32_t, std::vector<Instruction>> functionsOf(std::span<const uint32_t> spirv) {
    std::map<uint32_t, std::vector<Instruction>> functions;
    uint32_t function = 0;
    for (size_t at = 5; at < spirv.size();) {
        const Instruction instruction{spirv[at] & 0xFFFF, spirv.subspan(at, spirv[at] >> 16)};
        if (instruction.op == spv::OpFunction) function = instruction.words[2];
        functions[function].push_back(instruction);
        if (instruction.op == spv::OpFunctionEnd) function = 0;
        at += instruction.words.size();
    }
    return functions;
}

bool isAtomic(uint32_t op) { return op >= spv::OpAtomicExchange && op <= spv::OpAtomicXor; }

}  // namespace

std::map<std::string, Access> accessesOf(std::span<const uint32_t> spirv) {
    const spirv_cross::Compiler compiler(spirv.data(), spirv.size());
    std::map<std::string, Access> result;
    std::map<uint32_t, Access*> variables;
    const spirv_cross::ShaderResources resources = compiler.get_shader_resources();
    const auto add = [&](const auto& list, bool storage, bool uniform, bool readOnly) {
        for (const spirv_cross::Resource& resource : list) {
            std::string name = compiler.get_name(resource.id);
            if (name.empty()) name = resource.name;
            Access& access = result[name];
            access.set = compiler.get_decoration(resource.id, spv::DecorationDescriptorSet);
            access.binding = compiler.get_decoration(resource.id, spv::DecorationBinding);
            access.isStorageBuffer = storage;
            access.isUniformBuffer = uniform;
            access.isNonWritable = readOnly || compiler.has_decoration(resource.id, spv::DecorationNonWritable) ||
                                   (storage && compiler.get_buffer_block_flags(resource.id).get(spv::DecorationNonWritable));
            variables[resource.id] = &access;
        }
    };
    add(resources.storage_buffers, true, false, false);
    add(resources.uniform_buffers, false, true, true);
    add(resources.storage_images, false, false, false);
    add(resources.sampled_images, false, false, true);
    add(resources.acceleration_structures, false, false, true);

    auto functions = functionsOf(spirv);
    std::vector<uint32_t> reached;
    for (const Instruction& instruction : functions[0])
        if (instruction.op == spv::OpEntryPoint) reached.push_back(instruction.words[2]);
    std::map<uint32_t, Access*> pointers = variables, images;  // by id: into which variable it points, from which it was loaded
    const auto of = [](const std::map<uint32_t, Access*>& ids, uint32_t id) {
        const auto found = ids.find(id);
        return found == ids.end() ? nullptr : found->second;
    };
    for (size_t next = 0; next < reached.size(); ++next)
        for (const Instruction& i : functions.at(reached[next])) {
            Access* access = nullptr;
            if (i.op == spv::OpFunctionCall) {
                if (std::find(reached.begin(), reached.end(), i.words[3]) == reached.end()) reached.push_back(i.words[3]);
                for (size_t k = 4; k < i.words.size(); ++k)
                    if (of(pointers, i.words[k])) throw std::logic_error("a function is handed a pointer to a binding: its accesses are not known");
            } else if (i.op == spv::OpAccessChain || i.op == spv::OpInBoundsAccessChain || i.op == spv::OpCopyObject ||
                       i.op == spv::OpImageTexelPointer) {
                if ((access = of(pointers, i.words[3]))) pointers[i.words[2]] = access;
            } else if (i.op == spv::OpLoad) {
                if (!(access = of(pointers, i.words[3]))) continue;
                images[i.words[2]] = access;
                if (access->isStorageBuffer || access->isUniformBuffer || access->isNonWritable) access->reads = true;
            } else if (i.op == spv::OpImageRead || i.op == spv::OpImageFetch) {
                if ((access = of(images, i.words[3]))) access->reads = true;
            } else if (i.op == spv::OpImageWrite) {
                if ((access = of(images, i.words[1]))) access->stores = true;
            } else if (i.op == spv::OpStore || i.op == spv::OpCopyMemory || i.op == spv::OpAtomicStore) {
                if ((access = of(pointers, i.words[1]))) access->stores = true;
            } else if (isAtomic(i.op)) {
                if ((access = of(pointers, i.words[3]))) access->reads = access->atomics = true;
            }
        }
    return result;
}

}  // namespace gno::test
