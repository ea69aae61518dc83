// SPDX-License-Identifier: MIT
#include "validation/support/shader_rights.hpp"

#include <map>
#include <stdexcept>

namespace gno::test {
namespace {

// Of the SPIR-V specification.
enum Op : uint32_t {
    kName = 5,
    kTypeImage = 25,
    kTypeArray = 28,
    kTypeRuntimeArray = 29,
    kTypeStruct = 30,
    kTypePointer = 32,
    kVariable = 59,
    kImageTexelPointer = 60,
    kLoad = 61,
    kStore = 62,
    kAccessChain = 65,
    kInBoundsAccessChain = 66,
    kDecorate = 71,
    kMemberDecorate = 72,
    kImageWrite = 99,
    kAtomicStore = 228,
    kAtomicExchange = 229,
    kAtomicXor = 242  // and all atomics between
};
enum Decoration : uint32_t { kBufferBlock = 3, kNonWritable = 24 };
enum StorageClass : uint32_t { kUniformConstant = 0, kUniform = 2, kStorageBuffer = 12 };

struct Type {
    Op op;
    uint32_t inner = 0;    ///< of a pointer or an array
    uint32_t members = 0;  ///< of a structure
    bool storage = false;  ///< of an image: it has no sampler
};

struct Module {
    std::map<uint32_t, std::string> names;
    std::map<uint32_t, Type> types;
    std::map<uint32_t, std::set<uint32_t>> decorations;           ///< of a variable or a type
    std::map<uint32_t, std::set<uint32_t>> constantMembers;       ///< of a structure: the members that are NonWritable
    std::map<uint32_t, std::pair<uint32_t, uint32_t>> variables;  ///< pointer type, storage class
    std::map<uint32_t, uint32_t> origins;                         ///< of a pointer or an image: the variable it comes from
    std::set<uint32_t> stored;                                    ///< variables that are written

    explicit Module(std::span<const uint32_t> spirv) {
        if (spirv.size() < 5 || spirv[0] != 0x07230203u) throw std::runtime_error("this is no SPIR-V");
        for (size_t at = 5; at < spirv.size();) {
            const uint32_t length = spirv[at] >> 16;
            if (length == 0 || at + length > spirv.size()) throw std::runtime_error("a broken SPIR-V module");
            read(spirv[at] & 0xFFFFu, spirv.subspan(at + 1, length - 1));
            at += length;
        }
    }

    /// What it points to, out of all arrays.
    [[nodiscard]] uint32_t pointee(uint32_t pointer) const {
        uint32_t id = types.at(pointer).inner;
        for (auto at = types.find(id); at != types.end() && (at->second.op == kTypeArray || at->second.op == kTypeRuntimeArray); at = types.find(id))
            id = at->second.inner;
        return id;
    }
    [[nodiscard]] bool has(uint32_t id, uint32_t decoration) const {
        const auto found = decorations.find(id);
        return found != decorations.end() && found->second.contains(decoration);
    }

private:
    [[nodiscard]] uint32_t origin(uint32_t pointer) const {
        const auto found = origins.find(pointer);
        return found == origins.end() ? pointer : found->second;
    }
    void read(uint32_t op, std::span<const uint32_t> words) {
        switch (op) {
            case kName:
                names[words[0]] = reinterpret_cast<const char*>(&words[1]);
                break;
            case kDecorate:
                decorations[words[0]].insert(words[1]);
                break;
            case kMemberDecorate:
                if (words[2] == kNonWritable) constantMembers[words[0]].insert(words[1]);
                break;
            case kTypeImage:
                types[words[0]] = {Op(op), 0, 0, words[6] == 2};
                break;
            case kTypeArray:
            case kTypeRuntimeArray:
                types[words[0]] = {Op(op), words[1]};
                break;
            case kTypeStruct:
                types[words[0]] = {Op(op), 0, uint32_t(words.size() - 1)};
                break;
            case kTypePointer:
                types[words[0]] = {Op(op), words[2]};
                break;
            case kVariable:
                variables[words[1]] = {words[0], words[2]};
                break;
            case kLoad:
            case kAccessChain:
            case kInBoundsAccessChain:
            case kImageTexelPointer:
                origins[words[1]] = origin(words[2]);
                break;
            case kStore:
            case kAtomicStore:
            case kImageWrite:
                stored.insert(origin(words[0]));
                break;
            default:
                if (op >= kAtomicExchange && op <= kAtomicXor) stored.insert(origin(words[2]));
                break;
        }
    }
};

std::string nameOf(const Module& module, uint32_t variable, uint32_t type) {
    for (const uint32_t id : {variable, type}) {  // a block without an instance name has the block's
        const auto found = module.names.find(id);
        if (found != module.names.end() && !found->second.empty()) return found->second;
    }
    throw std::runtime_error("a buffer or an image without a name");
}

using Names = std::set<std::string>;

/// Storage buffers and storage images that `wanted` picks, by name.
template <class Wanted>
Names pick(const Module& module, Wanted wanted) {
    Names found;
    for (const auto& [variable, what] : module.variables) {
        const auto [pointer, storage] = what;
        if (storage != kUniformConstant && storage != kUniform && storage != kStorageBuffer) continue;
        const uint32_t id = module.pointee(pointer);
        const auto known = module.types.find(id);
        if (known == module.types.end()) continue;  // a sampled image, an acceleration structure
        const Type& type = known->second;
        const bool buffer = type.op == kTypeStruct && (storage == kStorageBuffer || (storage == kUniform && module.has(id, kBufferBlock)));
        const bool image = type.op == kTypeImage && type.storage && storage == kUniformConstant;
        if ((buffer || image) && wanted(variable, id, type)) found.insert(nameOf(module, variable, id));
    }
    return found;
}

}  // namespace

Names writable(std::span<const uint32_t> spirv) {
    const Module module(spirv);
    return pick(module, [&](uint32_t variable, uint32_t id, const Type& type) {
        if (module.has(variable, kNonWritable)) return false;
        const auto constant = module.constantMembers.find(id);
        return type.op != kTypeStruct || constant == module.constantMembers.end() || constant->second.size() < type.members;
    });
}

Names stored(std::span<const uint32_t> spirv) {
    const Module module(spirv);
    return pick(module, [&](uint32_t variable, uint32_t, const Type&) { return module.stored.contains(variable); });
}

}  // namespace gno::test
