// SPDX-License-Identifier: MIT
// The project's Markdown against its files: links lead somewhere, host_min/README.md names every source file and no other, the index of measured
// tables is complete. Each check is fed something broken as well.
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "validation/support/source_tree.hpp"

namespace gno::test {
namespace {

namespace fs = std::filesystem;
const fs::path kRoot = GNOMON_SOURCE_DIR;

/// Text without fenced blocks and inline code.
std::string withoutCode(const std::string& text) {
    std::string prose;
    std::istringstream lines(text);
    bool fenced = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("```"))
            fenced = !fenced;
        else if (!fenced)
            prose += line + "\n";
    }
    return std::regex_replace(prose, std::regex("`[^`]*`"), "x");
}

/// What a heading is called in a link.
std::string anchorOf(const std::string& heading) {
    std::string anchor;
    for (const char c : heading) {
        if (isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_')
            anchor += char(tolower(c));
        else if (c == ' ')
            anchor += '-';
    }
    return anchor;
}

std::set<std::string> anchorsOf(const std::string& text) {
    std::set<std::string> anchors;
    std::istringstream lines(text);
    bool fenced = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("```")) fenced = !fenced;
        const size_t level = line.find_first_not_of('#');
        if (!fenced && level != 0 && level != std::string::npos && line[level] == ' ') anchors.insert(anchorOf(line.substr(level + 1)));
    }
    return anchors;
}

/// Links of a document at `file` (relative to `root`) that lead to no file, or to no heading of it.
std::vector<std::string> deadLinks(const fs::path& root, const fs::path& file, const std::string& text) {
    std::vector<std::string> dead;
    const std::string prose = withoutCode(text);
    const std::regex link("\\]\\(([^) ]+)\\)");
    for (std::sregex_iterator i(prose.begin(), prose.end(), link), end; i != end; ++i) {
        const std::string target = (*i)[1];
        if (target.find("://") != std::string::npos) continue;
        const size_t hash = target.find('#');
        const fs::path path = hash == 0 ? root / file : root / file.parent_path() / target.substr(0, hash);
        const bool there = hash == 0 || fs::exists(path);
        if (!there || (hash != std::string::npos && !anchorsOf(hash == 0 ? text : readText(path)).contains(target.substr(hash + 1))))
            dead.push_back(target);
    }
    return dead;
}

TEST(Documents, LinksLeadSomewhere) {
    size_t documents = 0;
    for (const fs::path& file : sourceFiles(kRoot)) {
        if (file.extension() != ".md") continue;
        ++documents;
        for (const std::string& link : deadLinks(kRoot, file, readText(kRoot / file))) ADD_FAILURE() << file.string() << " links to " << link;
    }
    EXPECT_GE(documents, 10u);
}

TEST(Documents, ADeadLinkIsFound) {
    const std::string good = "# A b\n[x](README.md) [y](glsl/README.md#conventions) [z](#a-b) [w](https://example.org/a.md) `[v](no.md)`\n";
    EXPECT_TRUE(deadLinks(kRoot, "here.md", good).empty());
    EXPECT_EQ(deadLinks(kRoot, "here.md", good + "[a](no.md) [b](glsl/README.md#nothing) [c](#a-c)\n"),
              (std::vector<std::string>{"no.md", "glsl/README.md#nothing", "#a-c"}));
}

/// Names in backticks in the first column of the table that begins with `head`.
std::vector<std::string> firstColumn(const std::string& text, const std::string& head) {
    std::vector<std::string> names;
    std::istringstream lines(text.substr(std::min(text.size(), text.find(head))));
    const std::regex name("`([^`]+)`");
    for (std::string line; std::getline(lines, line) && line.starts_with("|");) {
        const std::string cell = line.substr(1, line.find('|', 1) - 1);
        for (std::sregex_iterator i(cell.begin(), cell.end(), name), end; i != end; ++i) names.push_back((*i)[1]);
    }
    return names;
}

bool matches(const std::string& file, const std::string& pattern) {
    const size_t star = pattern.find('*');
    if (star == std::string::npos) return file == pattern;
    return file.size() >= star && file.starts_with(pattern.substr(0, star)) && file.find('/', star) == std::string::npos;
}

/// What a table names that is not there, and what is there and is not named.
std::vector<std::string> differences(const std::vector<std::string>& files, const std::vector<std::string>& named) {
    std::vector<std::string> found;
    for (const std::string& pattern : named)
        if (std::none_of(files.begin(), files.end(), [&](const std::string& file) { return matches(file, pattern); }))
            found.push_back("gone: " + pattern);
    for (const std::string& file : files)
        if (std::none_of(named.begin(), named.end(), [&](const std::string& pattern) { return matches(file, pattern); }))
            found.push_back("not named: " + file);
    return found;
}

TEST(Documents, TheHostsTableNamesItsFiles) {
    std::vector<std::string> files;
    for (const fs::path& file : sourceFiles(kRoot / "host_min"))
        for (const char* kind : {".cpp", ".hpp", ".sh", ".cmake"})
            if (file.extension() == kind) files.push_back(file.string());
    const std::vector<std::string> named = firstColumn(readText(kRoot / "host_min/README.md"), "| file | what |");
    EXPECT_GE(named.size(), 30u);
    for (const std::string& difference : differences(files, named)) ADD_FAILURE() << "host_min/README.md, " << difference;
}

TEST(Documents, ATableThatDriftedIsFound) {
    const std::string text =
        "| x |\n\n| file | what |\n| --- | --- |\n| `main.cpp`, `app/options.*` | `app/none.hpp` |\n| `gone.cpp` | a |\n\n| `y.cpp` |\n";
    const std::vector<std::string> named = firstColumn(text, "| file | what |");
    EXPECT_EQ(named, (std::vector<std::string>{"main.cpp", "app/options.*", "gone.cpp"}));
    EXPECT_EQ(differences({"main.cpp", "app/options.cpp", "app/options.hpp", "app/new.cpp", "app/options.d/x.cpp"}, named),
              (std::vector<std::string>{"gone: gone.cpp", "not named: app/new.cpp", "not named: app/options.d/x.cpp"}));
    EXPECT_TRUE(firstColumn("no table", "| file | what |").empty());
}

TEST(Documents, TheIndexOfMeasuredTablesIsComplete) {
    const std::string index = readText(kRoot / "validation/measured/README.md");
    size_t tables = 0;
    for (const fs::path& file : sourceFiles(kRoot / "validation/measured")) {
        if (file == "README.md") continue;
        ++tables;
        EXPECT_NE(index.find("](" + file.string() + ")"), std::string::npos) << file.string();
        EXPECT_NE(readText(kRoot / "validation/measured" / file).find("gnomon"), std::string::npos) << file.string() << " names no command";
    }
    EXPECT_GE(tables, 8u);
}

}  // namespace
}  // namespace gno::test
