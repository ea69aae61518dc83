// SPDX-License-Identifier: MIT
// One version: the one of glsl/core/version.h, of the changelog's latest entry, and of the programs.
#include <gtest/gtest.h>

#include <regex>

#include "glsl/core/version.h"
#include "validation/support/shader_compile.hpp"

namespace gno::test {
namespace {

const std::string kVersion = std::to_string(GNO_VERSION_MAJOR) + "." + std::to_string(GNO_VERSION_MINOR) + "." + std::to_string(GNO_VERSION_PATCH);

/// Headings "## 1.2.3" of a changelog, in order.
std::vector<std::string> versionsOf(const std::string& changelog) {
    std::vector<std::string> found;
    const std::regex heading("(^|\n)## ([^\n]*)");
    for (std::sregex_iterator i(changelog.begin(), changelog.end(), heading), end; i != end; ++i) found.push_back((*i)[2]);
    return found;
}

/// Headings "### ..." of the latest entry.
std::vector<std::string> sectionsOf(const std::string& changelog) {
    const size_t first = changelog.find("\n## "), next = changelog.find("\n## ", first + 1);
    const std::string entry = changelog.substr(first, next - first);
    std::vector<std::string> found;
    const std::regex heading("\n### ([^\n]*)");
    for (std::sregex_iterator i(entry.begin(), entry.end(), heading), end; i != end; ++i) found.push_back((*i)[1]);
    return found;
}

TEST(Version, OneWordHoldsThreeNumbersInOrder) {
    EXPECT_EQ(uint32_t(GNO_VERSION) >> 22, uint32_t(GNO_VERSION_MAJOR));
    EXPECT_EQ(uint32_t(GNO_VERSION) >> 12 & 0x3FFu, uint32_t(GNO_VERSION_MINOR));
    EXPECT_EQ(uint32_t(GNO_VERSION) & 0xFFFu, uint32_t(GNO_VERSION_PATCH));
}

TEST(Version, GlslReadsTheSameWord) {
    const auto compiles = [](int wanted) {
        const Mount mount(GNOMON_SOURCE_DIR "/glsl");
        const std::filesystem::path shader = std::filesystem::path(testing::TempDir()) / ("gnomon-version-" + std::to_string(getpid()) + ".comp");
        std::ofstream(shader) << "#version 450\n#extension GL_GOOGLE_include_directive : require\n#include \"gnomon/core/light.glsl\"\n"
                              << "#if GNO_VERSION != " << wanted
                              << "\n#error another version\n#endif\nlayout(local_size_x = 1) in;\nvoid main() {}\n";
        const bool good = mount.compile(shader, "vulkan1.0", false).good;
        std::filesystem::remove(shader);
        return good;
    };
    EXPECT_TRUE(compiles(GNO_VERSION));
    EXPECT_FALSE(compiles(GNO_VERSION + 1));
}

TEST(Version, TheChangelogsLatestEntryIsThisVersion) {
    const std::string changelog = readText(GNOMON_SOURCE_DIR "/glsl/CHANGELOG.md");
    ASSERT_FALSE(versionsOf(changelog).empty());
    EXPECT_EQ(versionsOf(changelog).front(), kVersion);
    EXPECT_EQ(sectionsOf(changelog), (std::vector<std::string>{"Added", "Fixed", "Breaking for shader users"}));
}

TEST(Version, AChangelogOfAnotherVersionIsSeen) {
    const std::string changelog = "# Changelog\n\n## 9.8.7\n\n### Added\n- x\n\n### Fixed\n\n## 0.1.0\n\n### Added\n";
    EXPECT_EQ(versionsOf(changelog), (std::vector<std::string>{"9.8.7", "0.1.0"}));
    EXPECT_EQ(sectionsOf(changelog), (std::vector<std::string>{"Added", "Fixed"}));
}

TEST(Version, ProgramsSayIt) {
    const Ran ran = runCommand(std::string("'") + GNOMON_PROGRAM + "' --version");
    EXPECT_EQ(ran.status, 0);
    EXPECT_EQ(ran.output, "gnomon " + kVersion + "\n");
#ifdef GNOMON_VIZ_PROGRAM
    const Ran viz = runCommand(std::string("'") + GNOMON_VIZ_PROGRAM + "' --version");
    EXPECT_EQ(viz.status, 0);
    EXPECT_EQ(viz.output, "gnomon-viz " + kVersion + "\n");
#endif
}

}  // namespace
}  // namespace gno::test
