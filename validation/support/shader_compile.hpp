// SPDX-License-Identifier: MIT
// For tests that compile shaders as a user would: glsl/ copied under a temporary folder, glslangValidator and spirv-val run on what includes it.
#pragma once
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "validation/support/source_tree.hpp"

namespace gno::test {

struct Ran {
    int status = -1;     ///< exit code
    std::string output;  ///< both streams
};

inline Ran runCommand(const std::string& command) {
    FILE* const pipe = popen((command + " 2>&1").c_str(), "r");
    if (!pipe) throw std::runtime_error("cannot run " + command);
    Ran ran;
    char part[4096];
    while (const size_t bytes = fread(part, 1, sizeof part, pipe)) ran.output.append(part, bytes);
    const int status = pclose(pipe);
    ran.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return ran;
}

/// A temporary include folder with a copy of what shaders include of glsl/ (not a link: nothing outside the copied folder can be reached through
/// ".."), under the name `place`; `examples`: with what the examples share. Removed at the end.
class Mount {
public:
    explicit Mount(const std::filesystem::path& glsl, const std::filesystem::path& place = "gnomon", bool examples = false) {
        namespace fs = std::filesystem;
        std::string name = (fs::temp_directory_path() / "gnomon-drop-in-XXXXXX").string();
        if (!mkdtemp(name.data())) throw std::runtime_error("cannot make a temporary folder");
        folder_ = name;
        for (auto i = fs::recursive_directory_iterator(glsl); i != fs::recursive_directory_iterator(); ++i) {
            if (!examples && i->is_directory() && i->path().filename() == "examples") i.disable_recursion_pending();
            if (i->path().extension() != ".glsl" && i->path().extension() != ".h") continue;
            const fs::path copy = folder_ / place / fs::relative(i->path(), glsl);
            fs::create_directories(copy.parent_path());
            fs::copy_file(i->path(), copy);
        }
    }
    Mount(const Mount&) = delete;
    Mount& operator=(const Mount&) = delete;
    ~Mount() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }

    /// A shader outside the copies, for compile.
    [[nodiscard]] std::filesystem::path put(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name, std::ios::binary) << text;
        return folder_ / name;
    }

    struct Compiled {
        bool good = false;            ///< glslangValidator and spirv-val both agree
        std::string output;           ///< what they said
        std::vector<uint32_t> spirv;  ///< when good
    };
    [[nodiscard]] Compiled compile(const std::filesystem::path& shader, const std::string& environment, bool counters) const {
        const std::filesystem::path spirv = folder_ / "out.spv";
        Ran ran = runCommand(std::string(GNOMON_GLSLANG " -V --quiet --target-env ") + environment + " -I'" + folder_.string() +
                             "' -DGNO_COUNTERS=" + (counters ? "1" : "0") + " -o '" + spirv.string() + "' '" + shader.string() + "'");
        if (ran.status == 0) ran = runCommand(std::string(GNOMON_SPIRV_VAL " --target-env ") + environment + " '" + spirv.string() + "'");
        Compiled result{ran.status == 0, std::move(ran.output), {}};
        if (result.good) {
            const std::string bytes = readText(spirv);
            result.spirv.resize(bytes.size() / 4);
            bytes.copy(reinterpret_cast<char*>(result.spirv.data()), result.spirv.size() * 4);
        }
        return result;
    }

private:
    std::filesystem::path folder_;
};

}  // namespace gno::test
