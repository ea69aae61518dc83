// SPDX-License-Identifier: MIT
// The project's own files, for tests that read its text: what lies in the source folder, without build folders, output and hidden folders.
#pragma once
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace gno::test {

inline std::string readText(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw std::runtime_error("cannot read " + file.string());
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// Paths relative to `root`, sorted. Left out: hidden folders but .ci, build folders, out/, generated scenes, Python's caches.
inline std::vector<std::filesystem::path> sourceFiles(const std::filesystem::path& root) {
    namespace fs = std::filesystem;
    std::vector<fs::path> files;
    for (fs::recursive_directory_iterator i(root), end; i != end; ++i) {
        const std::string name = i->path().filename();
        const fs::path path = fs::relative(i->path(), root);
        const bool top = path.begin() == --path.end();
        const bool output = top && (name.starts_with("build") || name == "out");
        const bool hidden = name.starts_with(".") && name != ".ci";
        if (i->is_directory() && (hidden || output || name == "__pycache__" || path == "scenes/generated")) i.disable_recursion_pending();
        if (i->is_regular_file()) files.push_back(path);
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace gno::test
