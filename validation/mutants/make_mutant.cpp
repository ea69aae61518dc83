// SPDX-License-Identifier: MIT
// make_mutant DESCRIPTION GLSL_FOLDER OUT_FOLDER: copies the modules to OUT_FOLDER/glsl and puts the described fault in. Each text to be replaced
// has to occur exactly once in its file, however it is broken into lines; if not, the modules have changed: exit code 1 and one line, so that the
// build stops until the description is brought up to date.
//
// A description (NAME.expect_fail) starts with lines of prose. Then, once or several times:
//   file: top/plane.glsl
//   replace:
//   (lines, without the last line end)
//   by:
//   (lines)
//   end
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

std::string readText(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream) throw std::runtime_error("cannot read " + path.string());
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
}

std::string linesUntil(std::istream& in, const std::string& last) {
    std::string text, line;
    while (std::getline(in, line)) {
        if (line == last) return text.empty() ? text : text.substr(0, text.size() - 1);
        text += line + "\n";
    }
    throw std::runtime_error("the line '" + last + "' is missing");
}

/// A text without its white space, so that line breaks may move, and where each of its letters stands.
struct Letters {
    std::string all;
    std::vector<size_t> at;

    explicit Letters(const std::string& text) {
        for (size_t i = 0; i < text.size(); ++i) {
            if (std::isspace(static_cast<unsigned char>(text[i]))) continue;
            all += text[i];
            at.push_back(i);
        }
    }
};

void replaceOnce(std::string& text, const std::string& from, const std::string& to, const std::string& file) {
    const Letters in(text), what(from);
    const size_t first = in.all.find(what.all);
    if (what.all.empty() || first == std::string::npos)
        throw std::runtime_error(file + " does not contain '" + from + "': the module has changed, change the mutant");
    if (in.all.find(what.all, first + 1) != std::string::npos)
        throw std::runtime_error(file + " contains '" + from + "' more than once: give more of it");
    if (what.all == Letters(to).all) throw std::runtime_error("'" + from + "' is replaced by itself");
    const size_t start = in.at[first], end = in.at[first + what.all.size() - 1] + 1;
    text.replace(start, end - start, to);
}

void make(const fs::path& description, const fs::path& glsl, const fs::path& out) {
    std::map<std::string, std::string> files;
    for (const char* folder : {"core", "top", "clusters", "forest", "rivals", "shadow_map"}) {
        for (const auto& entry : fs::directory_iterator(glsl / folder)) {
            if (entry.is_regular_file()) files[std::string(folder) + "/" + entry.path().filename().string()] = readText(entry.path());
        }
    }
    std::istringstream in(readText(description));
    std::string line;
    int edits = 0;
    while (std::getline(in, line)) {
        if (line.rfind("file: ", 0) != 0) continue;
        const std::string file = line.substr(6);
        if (!files.contains(file)) throw std::runtime_error("there is no " + file);
        linesUntil(in, "replace:");
        const std::string from = linesUntil(in, "by:"), to = linesUntil(in, "end");
        replaceOnce(files[file], from, to, file);
        ++edits;
    }
    if (edits == 0) throw std::runtime_error("no line 'file: ...'");
    for (const auto& [name, text] : files) {
        fs::create_directories((out / "glsl" / name).parent_path());
        std::ofstream(out / "glsl" / name, std::ios::binary) << text;
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        std::fprintf(stderr, "make_mutant DESCRIPTION GLSL_FOLDER OUT_FOLDER\n");
        return 2;
    }
    try {
        make(argv[1], argv[2], argv[3]);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "mutant %s: %s\n", fs::path(argv[1]).stem().string().c_str(), error.what());
        return 1;
    }
}
