// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace gno::test {

/// A SPIR-V module that the build wrote to a file, for tests that run shaders of their own.
inline std::vector<uint32_t> readSpirv(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (!stream || bytes.size() < 20 || bytes.size() % 4 != 0) throw std::runtime_error("no SPIR-V in " + file);
    std::vector<uint32_t> words(bytes.size() / 4);
    bytes.copy(reinterpret_cast<char*>(words.data()), bytes.size());
    return words;
}

}  // namespace gno::test
