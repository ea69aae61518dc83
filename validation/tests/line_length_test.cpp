// SPDX-License-Identifier: MIT
// No line of the project is longer than 149 columns: code, comments, prose. Tables in Markdown may be wider, and so may measured tables, licences
// and data.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

#include "validation/support/source_tree.hpp"

namespace gno::test {
namespace {

constexpr size_t kColumns = 149;
constexpr std::array<std::string_view, 18> kChecked{".glsl", ".h",     ".comp", ".frag", ".vert",    ".hpp",         ".cpp", ".in", ".py",
                                                    ".sh",   ".cmake", ".json", ".md",   ".variant", ".expect_fail", ".css", ".js", ".yml"};

bool isChecked(const std::filesystem::path& file) {
    if (file.filename() == "CMakeLists.txt" || *file.begin() == ".ci") return true;
    if (file.string().starts_with("validation/measured/")) return false;
    return std::find(kChecked.begin(), kChecked.end(), file.extension().string()) != kChecked.end();
}

/// Columns of a line of UTF-8: its bytes without those that go on with a character.
size_t columnsOf(const std::string& line) {
    return size_t(std::count_if(line.begin(), line.end(), [](char byte) { return (uint8_t(byte) & 0xC0u) != 0x80u; }));
}

/// Numbers of the lines that are too long.
std::vector<size_t> longLines(const std::string& text, bool markdown) {
    std::vector<size_t> found;
    std::istringstream lines(text);
    size_t number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        const size_t first = line.find_first_not_of(' ');
        const bool row = markdown && first != std::string::npos && line[first] == '|';
        if (!row && columnsOf(line) > kColumns) found.push_back(number);
    }
    return found;
}

TEST(LineLength, NoLineIsLongerThan149Columns) {
    const std::filesystem::path root = GNOMON_SOURCE_DIR;
    size_t files = 0;
    for (const auto& file : sourceFiles(root)) {
        if (!isChecked(file)) continue;
        ++files;
        for (const size_t line : longLines(readText(root / file), file.extension() == ".md"))
            ADD_FAILURE() << file.string() << ":" << line << " has more than " << kColumns << " columns";
    }
    EXPECT_GE(files, 500u) << "the project is larger than this";
}

TEST(LineLength, OneColumnTooManyIsFound) {
    const std::string fits(149, 'x'), longer(150, 'x');
    EXPECT_TRUE(longLines(fits + "\n" + fits, false).empty());
    EXPECT_EQ(longLines("short\n" + longer + "\n" + fits + "\n" + longer, false), (std::vector<size_t>{2, 4}));
    EXPECT_EQ(longLines("// " + longer, true), std::vector<size_t>{1});
}

TEST(LineLength, CharactersCountNotBytes) {
    std::string dashes;
    for (int i = 0; i < 149; ++i) dashes += "\u2014";
    EXPECT_TRUE(longLines(dashes, false).empty());
    EXPECT_EQ(longLines(dashes + "\u2014", false), std::vector<size_t>{1});
}

TEST(LineLength, OnlyTablesOfMarkdownMayBeWider) {
    const std::string row = "| " + std::string(200, 'x') + " |";
    EXPECT_TRUE(longLines(row, true).empty());
    EXPECT_TRUE(longLines("  " + row, true).empty());
    EXPECT_EQ(longLines(row, false), std::vector<size_t>{1});
    EXPECT_EQ(longLines("text " + row, true), std::vector<size_t>{1});
}

TEST(LineLength, EveryKindOfTextIsChecked) {
    for (const char* file : {"glsl/top/node.h", "glsl/top/build.glsl", "glsl/README.md", "host_min/main.cpp", "host_min/setup.sh", ".ci/run",
                             "CMakeLists.txt", "host_min/shaders.cmake", "validation/drop_in/core_light.frag", "validation/mutants/a.expect_fail"})
        EXPECT_TRUE(isChecked(file)) << file;
    for (const char* file : {"validation/measured/top.md", "scenes/show_garden.glb", "LICENSE", "validation/fuzz/corpus/0a1b"})
        EXPECT_FALSE(isChecked(file)) << file;
}

}  // namespace
}  // namespace gno::test
