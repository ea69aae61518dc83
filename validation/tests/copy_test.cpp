// SPDX-License-Identifier: MIT
// glsl/MODULES.md lists files for each technique. A copy of exactly these, in an empty folder, is enough: its headers compile, every pass of the
// lists compiles to the SPIR-V that this project runs, byte by byte, and so does a shader of the user's.
#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include <unistd.h>

#include "glsl/core/passes.hpp"
#include "host_min/vulkan/shader.hpp"
#include "validation/support/module_lists.hpp"

namespace gno::test {
namespace {

namespace fs = std::filesystem;
const fs::path kGlsl = GNOMON_SOURCE_DIR "/glsl";

std::string textOf(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// The list under "Copy, ..." of a technique's section.
std::set<std::string> filesInPage(const std::string& technique) {
    const std::string page = textOf(kGlsl / "MODULES.md");
    const size_t from = page.find("<!-- " + technique + ": begin -->");
    const size_t open = page.find("```\n", from), close = page.find("```", open + 4);
    if (from == std::string::npos || close == std::string::npos) return {};
    std::istringstream words(page.substr(open + 4, close - open - 4));
    std::set<std::string> files;
    for (std::string file; words >> file;) files.insert(file);
    return files;
}

class Copy : public testing::TestWithParam<ModuleLists> {
protected:
    void SetUp() override {
        folder_ = fs::path(testing::TempDir()) / ("gnomon_copy_" + GetParam().technique + "_" + std::to_string(getpid()));
        fs::remove_all(folder_);
        for (const std::string& file : filesInPage(GetParam().technique)) {
            fs::create_directories((folder_ / "gnomon" / file).parent_path());
            fs::copy_file(kGlsl / file, folder_ / "gnomon" / file);
        }
    }
    void TearDown() override { fs::remove_all(folder_); }

    /// Exit status of a command whose output goes to log.txt.
    int run(const std::string& command) const { return std::system(("cd '" + folder_.string() + "' && " + command + " > log.txt 2>&1").c_str()); }
    std::string log() const { return textOf(folder_ / "log.txt"); }

    fs::path folder_;
};

TEST_P(Copy, IsWhatThePageLists) {
    const auto listed = filesInPage(GetParam().technique);
    const auto needed = filesToCopy(GetParam(), kGlsl);
    EXPECT_EQ(listed, std::set<std::string>(needed.begin(), needed.end()));
    EXPECT_TRUE(listed.contains("LICENSE"));
}

TEST_P(Copy, EveryPassCompilesToWhatThisProjectRuns) {
    size_t passes = 0;
    std::set<std::string> done;
    for (const PassList& list : {casterStatePasses(1), viewSamplePasses(1, 1), GetParam().build, GetParam().query})
        for (const Pass& pass : list) {
            const std::string shader(pass.shader);
            if (pass.kind == PassKind::command || !done.insert(shader).second) continue;
            ++passes;
            ASSERT_EQ(run(GNOMON_GLSLANG " -V --target-env vulkan1.2 --quiet -DGNO_COUNTERS=0 -o out.spv gnomon/" + shader), 0) << shader << "\n"
                                                                                                                                << log();
            const std::string words = textOf(folder_ / "out.spv");
            const auto ours = host::embeddedShader(shader);
            EXPECT_TRUE(words.size() == ours.size_bytes() && std::memcmp(words.data(), ours.data(), words.size()) == 0) << shader;
        }
    EXPECT_GE(passes, 4u);
}

TEST_P(Copy, HeadersAndAShaderOfTheUsersCompile) {
    std::ofstream(folder_ / "host.cpp") << "#include \"gnomon/core/grid.hpp\"\n#include \"gnomon/core/passes.hpp\"\n#include \"gnomon/"
                                        << GetParam().header << "\"\nint main() {}\n";
    EXPECT_EQ(run(GNOMON_CXX " -std=c++20 -Wall -Wextra -Werror -fsyntax-only -I. host.cpp"), 0) << log();
    std::ofstream user(folder_ / "user.frag");
    user << "#version 460\n#extension GL_GOOGLE_include_directive : require\n"
         << (GetParam().technique == "ray-query" ? "#extension GL_EXT_ray_query : require\n" : "")
         << "layout(push_constant) uniform Frame { vec4 light; } frame;\nlayout(location = 0) in vec3 position;\n"
            "layout(location = 1) flat in uint primitive;\nlayout(location = 0) out vec4 color;\n#define GNO_LIGHT frame.light\n";
    for (const std::string& line : GetParam().defines) user << line << "\n";
    for (const std::string& file : GetParam().includes) user << "#include \"gnomon/" << file << "\"\n";
    user << "void main() {\n    GnoViewSample s = GnoViewSample(position, primitive);\n    color = vec4(" << GetParam().question
         << " ? 0.0 : 1.0);\n}\n";
    user.close();
    EXPECT_EQ(run(GNOMON_GLSLANG " -V --target-env vulkan1.2 -I. -o user.spv user.frag"), 0) << log();
}

TEST_P(Copy, OneFileLessIsNoticed) {
    const std::string victim = GetParam().includes.back();
    fs::remove(folder_ / "gnomon" / victim);
    EXPECT_NE(run(GNOMON_GLSLANG " -V --target-env vulkan1.2 --quiet -o out.spv gnomon/" + std::string(GetParam().query.back().shader)), 0);
}

INSTANTIATE_TEST_SUITE_P(Techniques, Copy, testing::ValuesIn(moduleLists()), [](const testing::TestParamInfo<ModuleLists>& given) {
    std::string name = given.param.technique;
    for (char& c : name)
        if (c == '-') c = '_';
    return name;
});

}  // namespace
}  // namespace gno::test
