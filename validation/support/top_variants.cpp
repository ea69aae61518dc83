// SPDX-License-Identifier: MIT
#include <numeric>
#include <stdexcept>

#include "validation/support/glsl_as_cpp.hpp"
#include "validation/support/top_on_cpu.hpp"

#include "glsl/core/permutation.glsl"

namespace gno::cpu {

std::vector<uint> insertionOrder(uint count, uint seed) {
    std::vector<uint> order(count);
    for (uint i = 0; i < count; ++i) order[i] = gnoPermute(i, count, seed);
    return order;
}

std::unique_ptr<TopTree> makeTopTree(const std::string& variant) {
    for (const TopVariant& v : topVariants()) {
        if (v.name == variant) return v.make();
    }
    throw std::runtime_error("no variant '" + variant + "' of the TOP tree in this program: link its object file");
}

}  // namespace gno::cpu
