// SPDX-License-Identifier: MIT
// What a shader does with what is bound to it, read from its SPIR-V: which bindings it loads from, stores to, changes by atomics, asks for their
// length.
#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <string>

namespace gno::test {

struct Access {
    uint32_t set = 0, binding = 0;
    bool isStorageBuffer = false, isUniformBuffer = false;  ///< neither: an image or an acceleration structure
    bool isNonWritable = false;                             ///< by decoration; uniform buffers and sampled images are
    bool reads = false;                                     ///< loads, atomics, fetches; a length alone is none
    bool stores = false, atomics = false;
    [[nodiscard]] bool writes() const { return stores || atomics; }
};

/// By the instance's name, every binding that the module declares; accesses in functions that main() reaches.
std::map<std::string, Access> accessesOf(std::span<const uint32_t> spirv);

}  // namespace gno::test
