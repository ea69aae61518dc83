// SPDX-License-Identifier: MIT
// Every pass of a tree's list has its compiled shader in the installed folder; prints what an engine would allocate.
#include <cstdio>
#include <filesystem>
#include <string>

#include "gnomon/core/grid.hpp"
#include "gnomon/core/passes.hpp"
#include "gnomon/top/passes.hpp"

int main() {
    constexpr std::uint32_t casters = 1000;
    std::uint64_t bytes = 0;
    for (const gno::Array& array : gno::topArrays(casters)) bytes += array.bytes;
    int missing = 0;
    for (const gno::PassList& list : {gno::casterStatePasses(casters), gno::topBuildPasses(casters, {}), gno::topQueryPasses(64, 64, {})})
        for (const gno::Pass& pass : list) {
            const std::string file = std::string(GNOMON_SPIRV) + "/" + std::string(pass.shader) + ".spv";
            if (!std::filesystem::exists(file)) missing += std::printf("missing: %s\n", file.c_str()) > 0;
        }
    const gno::Grid grid = gno::gridAround({0, 0, 0}, {10, 10, 10});
    std::printf("%llu bytes for %u casters, grid exponent %d, %d shaders missing\n", static_cast<unsigned long long>(bytes), casters, grid.exponent,
                missing);
    return missing != 0 || bytes != 128016 || grid.exponent != 3;
}
