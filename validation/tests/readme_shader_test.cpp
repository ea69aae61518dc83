// SPDX-License-Identifier: MIT
// The shader that README.md shows first is a whole one: taken out of it and compiled against a copy of glsl/.
#include <gtest/gtest.h>

#include "validation/support/shader_compile.hpp"

namespace gno::test {
namespace {

const std::filesystem::path kRoot = GNOMON_SOURCE_DIR;

/// The first block of code that begins with #version.
std::string shaderOf(const std::string& document) {
    const std::string fence = "```glsl\n";
    const size_t begin = document.find(fence + "#version");
    if (begin == std::string::npos) return {};
    const size_t first = begin + fence.size();
    return document.substr(first, document.find("```", first) - first);
}

TEST(ReadmeShader, Compiles) {
    const std::string shader = shaderOf(readText(kRoot / "README.md"));
    ASSERT_FALSE(shader.empty());
    EXPECT_LE(std::count(shader.begin(), shader.end(), '\n'), 18);
    const Mount mount(kRoot / "glsl");
    const Mount::Compiled good = mount.compile(mount.put("readme.frag", shader), "vulkan1.1", false);
    EXPECT_TRUE(good.good) << good.output;

    std::string broken = shader;  // and the check can fail
    broken.replace(broken.find("gnoTopHybridAnswer"), 18, "gnoTopHybridReply_");
    EXPECT_FALSE(mount.compile(mount.put("broken.frag", broken), "vulkan1.1", false).good);
    EXPECT_TRUE(shaderOf("```\nno shader\n```").empty());
}

}  // namespace
}  // namespace gno::test
