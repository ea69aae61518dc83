// SPDX-License-Identifier: MIT
// glsl/ as a user takes it: copied under another folder, included from shaders that are not ours. Every file of validation/drop_in is one case, and
// what support/drop_in_cases.hpp makes of it others: the same body in a fragment shader, and copies that lack a required macro.
// SPIR-V for Vulkan 1.0 (with subgroup operations 1.1) with GNO_COUNTERS 0, for Vulkan 1.2 with GNO_COUNTERS 1, valid, and with no capability but
// Shader, except where clusters/traverse.glsl asks for subgroup operations and ballots, and where rivals/ray_query.glsl asks for ray queries
// (GLSL 4.60, Vulkan 1.2). What lacks a macro must fail with the module's #error that names it; so must what is refused for another reason
// (support/drop_in_refusals.cpp): a name of an earlier version, a forgotten switch, bindings that are included twice.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>

#include "validation/support/drop_in_cases.hpp"
#include "validation/support/shader_compile.hpp"
#include "validation/support/shader_rights.hpp"

namespace gno::test {
namespace {

namespace fs = std::filesystem;
const fs::path kDropIn = GNOMON_SOURCE_DIR "/validation/drop_in";
const fs::path kGlsl = GNOMON_SOURCE_DIR "/glsl";

Texts readTexts(const fs::path& folder, const std::set<std::string>& extensions) {
    Texts texts;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (extensions.contains(entry.path().extension())) texts[fs::relative(entry.path(), folder).string()] = readText(entry.path());
    }
    return texts;
}

const Texts& library() {
    static const Texts texts = [] {
        Texts all = readTexts(kGlsl, {".glsl", ".h"});
        std::erase_if(all, [](const auto& file) { return file.first.find("examples/") != std::string::npos; });
        return all;
    }();
    return texts;
}

const Texts& shaders() {
    static const Texts texts = readTexts(kDropIn, {".comp", ".frag"});
    return texts;
}

const std::vector<DropIn>& goodCases() {
    static const std::vector<DropIn> cases = mustCompile(library(), shaders());
    return cases;
}

const std::vector<MustFail>& badCases() {
    static const std::vector<MustFail> cases = [] {
        std::vector<MustFail> all = mustFail(library(), shaders());
        const std::vector<MustFail> more = refused(library());
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }();
    return cases;
}

template <class Case>
std::string caseName(const testing::TestParamInfo<Case>& info) {
    return std::regex_replace(info.param.name, std::regex("[^A-Za-z0-9]"), "_");
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

class DropInCompiles : public testing::TestWithParam<DropIn> {};

TEST_P(DropInCompiles, AndNeedsNoDeviceFeature) {
    const std::string& text = GetParam().text;
    const bool rays = text.find("/rivals/ray_query.glsl\"") != std::string::npos;  // the only module that says so
    ASSERT_EQ(text.rfind(rays ? "#version 460\n" : "#version 450\n", 0), 0u) << "the modules claim that this is enough";
    std::set<std::string> extensions = extensionsOf(text);
    EXPECT_EQ(extensions.erase("GL_GOOGLE_include_directive"), 1u);
    const bool byAddress = extensions.erase("GL_EXT_buffer_reference") == 1;  // the user's own wish
    EXPECT_EQ(byAddress, GetParam().name.find("buffer_reference") != std::string::npos);
    const bool subgroups = text.find("/clusters/traverse.glsl\"") != std::string::npos;  // the only module that says so
    for (const char* of : {"GL_KHR_shader_subgroup_basic", "GL_KHR_shader_subgroup_ballot"})
        EXPECT_EQ(extensions.erase(of), subgroups ? 1u : 0u) << of;
    EXPECT_EQ(extensions.erase("GL_EXT_ray_query"), rays ? 1u : 0u);
    EXPECT_TRUE(extensions.empty()) << "the other modules claim to need no extension beyond include";

    const std::string elsewhere = "third_party/light and shade";  // deeper, and with a space in its name
    const Mount mount(kGlsl, text.find(elsewhere + "/") == std::string::npos ? "gnomon" : elsewhere);
    const fs::path shader = mount.put(GetParam().name, text);
    for (const bool counters : {false, true}) {
        const Mount::Compiled compiled = mount.compile(shader, counters || rays ? "vulkan1.2" : subgroups ? "vulkan1.1" : "vulkan1.0", counters);
        ASSERT_TRUE(compiled.good) << "GNO_COUNTERS " << counters << "\n" << compiled.output << text;
        std::set<uint32_t> capabilities = firstOperands(compiled.spirv, 17);                                // OpCapability
        EXPECT_EQ(capabilities.erase(1), 1u);                                                               // Shader
        EXPECT_EQ(capabilities.erase(5347), byAddress ? 1u : 0u);                                           // PhysicalStorageBufferAddresses
        for (const uint32_t of : {61u, 64u}) EXPECT_EQ(capabilities.erase(of), subgroups ? 1u : 0u) << of;  // GroupNonUniform, GroupNonUniformBallot
        EXPECT_EQ(capabilities.erase(4472), rays ? 1u : 0u);                                                // RayQueryKHR
        EXPECT_TRUE(capabilities.empty()) << "capability " << *capabilities.begin();
        if (!GetParam().name.ends_with(".frag")) continue;
        const std::set<std::string> writes = stored(compiled.spirv);  // these need fragmentStoresAndAtomics
        if (text.find("_BUILDS 1\n") == std::string::npos) {          // which means: all passes
            for (const std::string& buffer : writable(compiled.spirv))
                EXPECT_TRUE(!buffer.starts_with("gno") || writes.contains(buffer)) << buffer << " is writable for nothing";
        }
        bool asks = true;
        for (const char* builds : {"_BUILDS ", "GNO_TRANSMITTANCE_ADDS ", "GNO_SHADOW_MAP_MEASURES ", " buffer "})
            asks = asks && text.find(builds) == std::string::npos;
        EXPECT_TRUE(!asks || writes.empty()) << "what only asks, writes";
    }
}

INSTANTIATE_TEST_SUITE_P(, DropInCompiles, testing::ValuesIn(goodCases()), caseName<DropIn>);

class DropInFails : public testing::TestWithParam<MustFail> {};

TEST_P(DropInFails, WithTheModulesOwnWords) {
    const Mount mount(kGlsl);
    const Mount::Compiled compiled = mount.compile(mount.put(GetParam().name, GetParam().text), "vulkan1.0", false);
    ASSERT_FALSE(compiled.good);
    const std::regex error("'#error' : " + GetParam().file + " *: .*" + GetParam().macro + "\\b");
    EXPECT_TRUE(std::regex_search(compiled.output, error)) << "no #error of " << GetParam().file << " that names " << GetParam().macro << "\n"
                                                           << compiled.output << GetParam().text;
}

INSTANTIATE_TEST_SUITE_P(, DropInFails, testing::ValuesIn(badCases()), caseName<MustFail>);

/// Lines "#error ..." of the library, and for each of the macros they name whether a must-fail case asks for it.
TEST(DropInCoverage, EveryErrorHasACase) {
    std::set<std::string> asked;
    for (const MustFail& one : badCases()) asked.insert(one.file + " " + one.macro);
    size_t errors = 0;
    const std::regex macro("GNO_[A-Z0-9_]+");
    for (const auto& [path, text] : library()) {
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) {
            if (line.rfind("#error", 0) != 0) continue;
            ++errors;
            const std::string wanted = line.substr(0, line.find(" or include "));
            std::sregex_iterator i(wanted.begin(), wanted.end(), macro);
            EXPECT_NE(i, std::sregex_iterator()) << line;
            for (; i != std::sregex_iterator(); ++i)
                EXPECT_TRUE(asked.contains(path + " " + i->str())) << i->str() << ": no skeleton defines it, no refusal is for " << line;
        }
    }
    EXPECT_GE(errors, 46u);
}

/// Every module stops with an #error for every macro that it or what it includes requires.
TEST(DropInCoverage, EveryModuleIsBrokenByEveryMacroItRequires) {
    std::set<std::string> names;
    for (const MustFail& one : badCases()) names.insert(moduleStem(one.name) + " " + one.file + " " + one.macro);
    for (const auto& [path, text] : library()) {
        if (!shaders().contains(moduleStem(path) + ".comp")) continue;  // a part of others
        for (const auto& [macro, file] : requiredBy(library(), text, path))
            EXPECT_TRUE(names.contains(moduleStem(path) + " " + file + " " + macro))
                << "no shader " << moduleStem(path) << ".*.comp defines " << macro << ", which " << file << " requires";
    }
}

/// Every module is in the three shaders that include all of them (those that need ray queries in one of their own); every module that a user calls
/// has a shader of its own in both stages.
TEST(DropInCoverage, EveryModuleIsIncluded) {
    const std::set<std::string> parts{"core/int128.glsl",
                                      "core/portable.h",
                                      "core/state.h",
                                      "core/version.h",
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
                                      "core/version.h",
                                      "core/constant_ids.h",
                                      "shadow_map/view.h",
                                      "shadow_map/bindings.glsl",
                                      "shadow_map/map_bindings.glsl",
                                      "forest/cells.h",
                                      "forest/bindings.glsl"};
    const std::set<std::string> rays{"rivals/ray_query.glsl", "rivals/ray_query_bindings.glsl"};
    const std::set<std::string> computeOnly{
        "clusters/build.glsl",  "clusters/traverse.glsl", "rivals/light_grid_sort.glsl",
        "core/prefix_sum.glsl", "core/radix_sort.glsl",   "rivals/light_bvh_build.glsl"};  // shared memory; a whole subgroup that calls together
    std::set<std::string> cases;
    for (const DropIn& one : goodCases()) cases.insert(one.name);
    for (const auto& [module, text] : library()) {
        std::set<std::string> inclusive{"rivals_ray_query.all_modules.comp"};
        if (!rays.contains(module)) inclusive.insert({"all_modules.comp", "all_modules_reversed.comp", "all_modules_twice.comp"});
        for (const std::string& all : inclusive)
            EXPECT_NE(shaders().at(all).find("#include \"gnomon/" + module + "\"\n"), std::string::npos) << all << " lacks " << module;
        if (parts.contains(module)) continue;
        EXPECT_TRUE(cases.contains(moduleStem(module) + ".comp")) << module;
        EXPECT_NE(cases.contains(moduleStem(module) + ".frag"), computeOnly.contains(module)) << module;
    }
}

/// At least as many cases as when each of them was a file (141 that compile, 49 of them fragment shaders, and 109 that must not).
TEST(DropInCoverage, NoFewerCasesThanTheFilesTheyReplace) {
    const auto fragments = std::count_if(goodCases().begin(), goodCases().end(), [](const DropIn& one) { return one.name.ends_with(".frag"); });
    EXPECT_GE(goodCases().size(), 141u);
    EXPECT_GE(fragments, 49);
    EXPECT_GE(badCases().size(), 109u);
}

const std::string kShader = R"(#version 450
#define GNO_SIZE_LOG 3
#define GNO_SIZE \
    8
#include "gnomon/a/part.glsl"
#include "gnomon/a/whole.glsl"
layout(local_size_x = 64) in;
layout(set = 3, binding = 0, std430) writeonly buffer Results { vec4 v[]; } results;

void main() {
    uint at = gl_GlobalInvocationID.x;
    vec4 result;
    result = vec4(GNO_SIZE + at);
    results.v[at] = result;
}
)";
const Texts kLibrary{
    {"a/part.glsl", "// Stages     any\n#ifndef GNO_OTHER\n#define GNO_OTHER 1\n#endif\n"},
    {"a/whole.glsl",
     "// Stages     any\n#include \"deep.glsl\"\n#if !defined(GNO_SIZE) || \\\n    !(defined(GNO_LIGHT) || defined(GNO_OTHER))\n#error "
     "\"a/whole.glsl: define "
     "GNO_SIZE and GNO_LIGHT\"\n#endif\n"},
    {"a/deep.glsl", "// Stages     any\n#ifndef GNO_LIGHT\n#error \"a/deep.glsl: define GNO_LIGHT\"\n#endif\n"},
};

TEST(DropInGenerator, MakesTheFragmentTwin) {
    const std::vector<DropIn> cases = mustCompile(kLibrary, {{"a_whole.comp", kShader}});
    ASSERT_EQ(cases.size(), 2u);
    EXPECT_EQ(cases[0].text, kShader);
    EXPECT_EQ(cases[1].name, "a_whole.frag");
    EXPECT_EQ(cases[1].text, kShader.substr(0, kShader.find("layout(local")) +
                                 "layout(location = 0) out vec4 result;\n\nvoid main() {\n    uint at = uint(gl_FragCoord.x);\n"
                                 "    result = vec4(GNO_SIZE + at);\n}\n");
    for (const char* line : {"layout(local_size_x = 64) in;\n", "{ vec4 v[]; }", "    results.v[at] = result;\n"})
        EXPECT_THROW(fragmentTwin(std::string(kShader).erase(kShader.find(line), std::string(line).size())), std::invalid_argument) << line;

    Texts compute = kLibrary;
    compute["a/part.glsl"] = "\n// Stages     compute; holds barriers\n";
    EXPECT_FALSE(hasFragmentTwin(compute, kShader));
    EXPECT_FALSE(hasFragmentTwin(kLibrary, "void main() {}"));
}

TEST(DropInGenerator, BreaksOneMacroAtATime) {
    const std::map<std::string, std::string> required{{"GNO_LIGHT", "a/deep.glsl"}, {"GNO_SIZE", "a/whole.glsl"}};
    EXPECT_EQ(requiredBy(kLibrary, kShader), required);
    EXPECT_EQ(requiredBy(kLibrary, kLibrary.at("a/whole.glsl"), "a/whole.glsl"), required);

    // GNO_LIGHT is not defined by the shader itself; GNO_OTHER and GNO_SIZE_LOG are no macros that it must define.
    const std::vector<MustFail> cases = mustFail(kLibrary, {{"a_whole.comp", kShader}, {"other.comp", kShader}});
    ASSERT_EQ(cases.size(), 1u);
    EXPECT_EQ(cases[0].name, "a_whole.missing_size.comp");
    EXPECT_EQ(cases[0].file, "a/whole.glsl");
    EXPECT_EQ(cases[0].macro, "GNO_SIZE");
    const std::string definition = "#define GNO_SIZE \\\n    8";
    EXPECT_EQ(cases[0].text, std::string(kShader).erase(kShader.find(definition), definition.size()));

    // The module's own storage comes first.
    const std::string own = "#define GNO_LIGHT l\n" + kShader;
    const std::vector<MustFail> both = mustFail(kLibrary, {{"a_whole.comp", kShader}, {"a_whole.own_storage.comp", own}});
    ASSERT_EQ(both.size(), 2u);
    EXPECT_EQ(both[0].text, "\n" + kShader);
    EXPECT_EQ(both[0].file, "a/deep.glsl");
    EXPECT_EQ(both[1].text, withoutMacro(own, "GNO_SIZE"));

    EXPECT_THROW(withoutMacro(kShader, "GNO_LIGHT"), std::invalid_argument);
    EXPECT_THROW((void)refused({{"a/bindings.glsl", "\n#ifndef GNO_A_BINDINGS_GLSL\n#define GNO_A_BINDINGS_GLSL\n#endif\n"}}),
                 std::invalid_argument);
    EXPECT_THROW(withoutMacro("#define GNO_SIZE_LOG 1\n", "GNO_SIZE"), std::invalid_argument);
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
