// SPDX-License-Identifier: MIT
// What a shader may write: storage buffers and storage images of a SPIR-V module that are not NonWritable. In a fragment shader each needs the
// device feature fragmentStoresAndAtomics, in a vertex shader vertexPipelineStoresAndAtomics (VUID-RuntimeSpirv-NonWritable-06340 and -06341).
#pragma once
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <string_view>

namespace gno::test {

/// By the names of the variables ("gnoTopLinks"). Throws std::runtime_error when this is no SPIR-V, or where a variable has no name.
std::set<std::string> writable(std::span<const uint32_t> spirv);

/// Those that some instruction of the module stores to or changes by an atomic. What is writable and not stored to has a right too many.
std::set<std::string> stored(std::span<const uint32_t> spirv);

/// What the passes that run this example ("top/examples/build.comp", or that with ".counters") write, all of it: no right beyond that is needed.
/// From the lists of module_lists.hpp (Pass::writes); a few shaders that no list has are in written_by.cpp.
std::set<std::string> writtenBy(std::string_view shader);

}  // namespace gno::test
