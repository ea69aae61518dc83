// SPDX-License-Identifier: MIT
// glsl/ as a user takes it: copied under another folder, included from shaders that are not ours. Every file of validation/drop_in is one case:
// SPIR-V for Vulkan 1.0 (with subgroup operations 1.1) with GNO_COUNTERS 0, for Vulkan 1.2 with GNO_COUNTERS 1, valid, and with no capability but
// Shader, except where clusters/traverse.glsl asks for subgroup operations and ballots, and where rivals/ray_query.glsl asks for ray queries
// (GLSL 4.60, Vulkan 1.2). NAME.expect_fail.comp must fail, with the #error that its comment names.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>

#include "validation/support/shader_compile.hpp"

namespace gno::test {
namespace {

namespace fs = std::filesystem;
const fs::path kDropIn = GNOMON_SOURCE_DIR "/validation/drop_in";
const fs::path kGlsl = GNOMON_SOURCE_DIR "/glsl";

std::vector<fs::path> shaders(bool mustFail) {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(kDropIn)) {
        const std::string extension = entry.path().extension();
        if (extension != ".comp" && extension != ".frag") continue;
        if ((entry.path().filename().string().find(".expect_fail.") != std::string::npos) == mustFail) found.push_back(entry.path());
    }
    std::sort(found.begin(), found.end());
    return found;
}

std::string caseName(const testing::TestParamInfo<fs::path>& info) {
    return std::regex_replace(info.param.filename().string(), std::regex("[^A-Za-z0-9]"), "_");
}

std::set<std::string> extensionsOf(const std::string& text) {
    std::set<std::string> found;
    const std::regex line("(^|\n) *# *extension +([A-Za-z0-9_]+)");
    for (std::sregex_iterator i(text.begin(), text.end(), line), end; i != end; ++i) found.insert((*i)[2]);
    return found;
}

/// Operands of all instructions of this kind in a SPIR-V module.
std::set<uint32_t> firstOperands(const std::vector<uint32_t>& spirv, uint32_t opcode) {
    std::set<uint32_t> found;
    for (size_t at = 5; at < spirv.size() && (spirv[at] >> 16) != 0; at += spirv[at] >> 16)
        if ((spirv[at] & 0xFFFFu) == opcode) found.insert(spirv[at + 1]);
    return found;
}

class DropIn : public testing::TestWithParam<fs::path> {};

TEST_P(DropIn, CompilesAndNeedsNoDeviceFeature) {
    const std::string text = readText(GetParam());
    const bool rays = text.find("/rivals/ray_query.glsl\"") != std::string::npos;  // the only module that says so
    ASSERT_EQ(text.rfind(rays ? "#version 460\n" : "#version 450\n", 0), 0u) << "the modules claim that this is enough";
    std::set<std::string> extensions = extensionsOf(text);
    EXPECT_EQ(extensions.erase("GL_GOOGLE_include_directive"), 1u);
    const bool byAddress = extensions.erase("GL_EXT_buffer_reference") == 1;  // the user's own wish
    EXPECT_EQ(byAddress, GetParam().filename().string().find("buffer_reference") != std::string::npos);
    const bool subgroups = text.find("/clusters/traverse.glsl\"") != std::string::npos;  // the only module that says so
    for (const char* of : {"GL_KHR_shader_subgroup_basic", "GL_KHR_shader_subgroup_ballot"})
        EXPECT_EQ(extensions.erase(of), subgroups ? 1u : 0u) << of;
    EXPECT_EQ(extensions.erase("GL_EXT_ray_query"), rays ? 1u : 0u);
    EXPECT_TRUE(extensions.empty()) << "the other modules claim to need no extension beyond include";

    const Mount mount(kGlsl);
    for (const bool counters : {false, true}) {
        const Mount::Compiled compiled = mount.compile(GetParam(), counters || rays ? "vulkan1.2" : subgroups ? "vulkan1.1" : "vulkan1.0", counters);
        ASSERT_TRUE(compiled.good) << "GNO_COUNTERS " << counters << "\n" << compiled.output;
        std::set<uint32_t> capabilities = firstOperands(compiled.spirv, 17);                                // OpCapability
        EXPECT_EQ(capabilities.erase(1), 1u);                                                               // Shader
        EXPECT_EQ(capabilities.erase(5347), byAddress ? 1u : 0u);                                           // PhysicalStorageBufferAddresses
        for (const uint32_t of : {61u, 64u}) EXPECT_EQ(capabilities.erase(of), subgroups ? 1u : 0u) << of;  // GroupNonUniform, GroupNonUniformBallot
        EXPECT_EQ(capabilities.erase(4472), rays ? 1u : 0u);                                                // RayQueryKHR
        EXPECT_TRUE(capabilities.empty()) << "capability " << *capabilities.begin();
    }
}

INSTANTIATE_TEST_SUITE_P(, DropIn, testing::ValuesIn(shaders(false)), caseName);

struct Expected {
    std::string file, macro;  ///< "top/build.glsl", "GNO_LIGHT"
};

Expected expectedOf(const fs::path& shader) {
    const std::string text = readText(shader);
    std::smatch match;
    if (!std::regex_search(text, match, std::regex("// Must fail with the #error of ([a-z0-9_/.]+) that names ([A-Z0-9_]+)\\.\n")))
        throw std::runtime_error(shader.string() + ": which #error is expected?");
    return {match[1], match[2]};
}

class DropInFails : public testing::TestWithParam<fs::path> {};

TEST_P(DropInFails, WithTheModulesOwnWords) {
    const Expected expected = expectedOf(GetParam());
    const Mount mount(kGlsl);
    const Mount::Compiled compiled = mount.compile(GetParam(), "vulkan1.0", false);
    ASSERT_FALSE(compiled.good);
    const std::regex error("'#error' : " + expected.file + " *: .*" + expected.macro + "\\b");
    EXPECT_TRUE(std::regex_search(compiled.output, error)) << "no #error of " << expected.file << " that names " << expected.macro << "\n"
                                                           << compiled.output;
}

INSTANTIATE_TEST_SUITE_P(, DropInFails, testing::ValuesIn(shaders(true)), caseName);

/// Lines "#error ..." of the library, and for each of the macros they name whether a must-fail case asks for it.
TEST(DropInCoverage, EveryErrorHasACase) {
    std::set<std::string> asked;
    for (const fs::path& shader : shaders(true)) {
        const Expected expected = expectedOf(shader);
        asked.insert(expected.file + " " + expected.macro);
    }
    size_t errors = 0;
    const std::regex macro("GNO_[A-Z0-9_]+");
    for (const auto& entry : fs::recursive_directory_iterator(kGlsl)) {
        if (!entry.is_regular_file()) continue;
        std::istringstream lines(readText(entry.path()));
        for (std::string line; std::getline(lines, line);) {
            if (line.rfind("#error", 0) != 0) continue;
            ++errors;
            const std::string wanted = line.substr(0, line.find(" or include "));
            std::sregex_iterator i(wanted.begin(), wanted.end(), macro);
            EXPECT_NE(i, std::sregex_iterator()) << line;
            for (; i != std::sregex_iterator(); ++i)
                EXPECT_TRUE(asked.contains(fs::relative(entry.path(), kGlsl).string() + " " + i->str())) << "no *.expect_fail.comp for " << line;
        }
    }
    EXPECT_GE(errors, 6u);
}

/// Every module is in the three shaders that include all of them (those that need ray queries in one of their own); every module that a user calls
/// has a shader of its own in both stages.
TEST(DropInCoverage, EveryModuleIsIncluded) {
    const std::set<std::string> parts{"core/int128.glsl",
                                      "core/portable.h",
                                      "core/shared_types.h",
                                      "core/bindings.glsl",
                                      "core/material.h",
                                      "core/material_bindings.glsl",
                                      "top/node.h",
                                      "top/plane.glsl",
                                      "top/visit.glsl",
                                      "top/bindings.glsl",
                                      "clusters/cluster.h",
                                      "clusters/bindings.glsl",
                                      "rivals/ray_query_bindings.glsl",
                                      "rivals/light_grid.h",
                                      "rivals/light_grid_bindings.glsl",
                                      "rivals/light_bvh.h",
                                      "rivals/light_bvh_bindings.glsl",
                                      "core/radix_sort.h",
                                      "shadow_map/view.h",
                                      "shadow_map/bindings.glsl",
                                      "shadow_map/map_bindings.glsl",
                                      "forest/cells.h",
                                      "forest/bindings.glsl"};
    const std::set<std::string> rays{"rivals/ray_query.glsl", "rivals/ray_query_bindings.glsl"};
    const std::set<std::string> computeOnly{
        "clusters/build.glsl",  "clusters/traverse.glsl", "rivals/light_grid_sort.glsl",
        "core/prefix_sum.glsl", "core/radix_sort.glsl",   "rivals/light_bvh_build.glsl"};  // shared memory; a whole subgroup that calls together
    for (const auto& entry : fs::recursive_directory_iterator(kGlsl)) {
        const std::string module = fs::relative(entry.path(), kGlsl).string();
        const std::string extension = entry.path().extension();
        if ((extension != ".glsl" && extension != ".h") || module.find("examples/") != std::string::npos) continue;
        std::set<std::string> inclusive{"rivals_ray_query.all_modules.comp"};
        if (!rays.contains(module)) inclusive.insert({"all_modules.comp", "all_modules_reversed.comp", "all_modules_twice.comp"});
        for (const std::string& all : inclusive)
            EXPECT_NE(readText(kDropIn / all).find("#include \"gnomon/" + module + "\"\n"), std::string::npos) << all << " lacks " << module;
        std::string own = module.substr(0, module.rfind('.'));
        std::replace(own.begin(), own.end(), '/', '_');
        if (parts.contains(module)) continue;
        EXPECT_TRUE(fs::exists(kDropIn / (own + ".comp"))) << module;
        EXPECT_NE(fs::exists(kDropIn / (own + ".frag")), computeOnly.contains(module)) << module;
    }
}

/// The cases above see a module that is broken for a user: each of these shaders has one thing wrong with it.
TEST(DropInCases, CanFail) {
    const Mount mount(kGlsl);
    const fs::path shader = fs::path(testing::TempDir()) / ("gnomon-drop-in-" + std::to_string(getpid()) + ".comp");
    const auto compiles = [&](const std::string& text) {
        std::ofstream(shader) << "#version 450\n#extension GL_GOOGLE_include_directive : require\n" << text << "\nlayout(local_size_x = 1) in;\n";
        return mount.compile(shader, "vulkan1.0", false).good;
    };
    const std::string light =
        "vec4 l() { return vec4(0.0); }\n#define GNO_LIGHT l()\n#include \"gnomon/core/bindings.glsl\"\n#include \"gnomon/top/bindings.glsl\"\n";
    EXPECT_TRUE(compiles(light + "#include \"gnomon/top/query_stack.glsl\"\nvoid main() {}"));
    EXPECT_FALSE(compiles(light + "#include \"gnomon/top/query_no_such.glsl\"\nvoid main() {}"));
    EXPECT_FALSE(compiles(
        light + "int gnoSign_(uvec4 v);\nfloat gnoSign_(uvec4 v) { return 0.0; }\n#include \"gnomon/top/query_stack.glsl\"\nvoid main() {}"));
    // A trap of drop_in/*.own_storage.comp does spring when a module's local has its name.
    const std::string trap = "struct Trap { mat4x3 m; };\nTrap index;\nfloat keep(Trap t) { return t.m[0][0]; }\n#define LOAD(number) keep(index)\n";
    EXPECT_TRUE(compiles(trap + "float module(uint index_) { return LOAD(index_); }\nvoid main() {}"));
    EXPECT_FALSE(compiles(trap + "float module(uint index) { return LOAD(index); }\nvoid main() {}"));
    fs::remove(shader);
}

}  // namespace
}  // namespace gno::test
