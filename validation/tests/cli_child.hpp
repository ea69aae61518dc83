// SPDX-License-Identifier: MIT
// Runs the program (GNOMON_PROGRAM) as a child process. Its folder, with the files that it is given and leaves, lives as long as the Stage.
#pragma once
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>
#include <thread>

#include "validation/tests/scene_builder.hpp"

namespace gno::test {

using host::test::Builder;

inline std::string readFile(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

struct Outcome {
    int code = -1;  ///< exit code; 128 + the signal that ended it
    std::string out, err;
};

struct ChildOptions {
    std::map<std::string, std::string> environment;  ///< on top of ours
    std::string standardOutput;                      ///< a file; empty: kept in Outcome::out
    std::string program = GNOMON_PROGRAM;
};

/// One run of the program; begins in the constructor.
class Child {
public:
    Child(const std::filesystem::path& folder, const std::vector<std::string>& arguments, const ChildOptions& options = {}) {
        static int count = 0;
        out_ = options.standardOutput.empty() ? (folder / ("stdout." + std::to_string(count))).string() : options.standardOutput;
        err_ = (folder / ("stderr." + std::to_string(count++))).string();
        std::vector<std::string> words{options.program};
        words.insert(words.end(), arguments.begin(), arguments.end());
        std::vector<char*> argv;
        for (std::string& word : words) argv.push_back(word.data());
        argv.push_back(nullptr);
        id_ = fork();
        if (id_ < 0) throw std::runtime_error("cannot fork");
        if (id_ > 0) return;
        const int out = ::open(out_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644), err = ::open(err_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
        if (out < 0 || err < 0 || dup2(out, STDOUT_FILENO) < 0 || dup2(err, STDERR_FILENO) < 0 || chdir(folder.c_str()) != 0) _exit(126);
        setenv("GNOMON_VALIDATE", "0", 1);
        for (const auto& [name, value] : options.environment) setenv(name.c_str(), value.c_str(), 1);
        execv(argv[0], argv.data());
        _exit(127);
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child() {
        if (id_ > 0) {
            ::kill(id_, SIGKILL);
            waitpid(id_, nullptr, 0);
        }
    }

    [[nodiscard]] pid_t id() const { return id_; }
    /// From now on no file of its may grow beyond: as on a full disk. (From its start on, lavapipe's memory, which is files too, would be limited as
    /// well.)
    void limitFileSize(rlim_t bytes) const {
        const rlimit limit{bytes, bytes};
        if (prlimit(id_, RLIMIT_FSIZE, &limit, nullptr) != 0) throw std::runtime_error("cannot limit the program's files");
    }
    void signal(int number) const { ::kill(id_, number); }

    [[nodiscard]] Outcome wait() {
        int status = 0;
        if (waitpid(id_, &status, 0) != id_) throw std::runtime_error("cannot wait for the program");
        id_ = -1;
        const bool isKept = std::filesystem::is_regular_file(out_);  // /dev/full has no end
        return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), isKept ? readFile(out_) : std::string(), readFile(err_)};
    }

private:
    pid_t id_ = -1;
    std::string out_, err_;
};

/// A temporary folder with an empty folder "out" in it.
class Stage {
public:
    Stage() { std::filesystem::create_directory(out()); }

    [[nodiscard]] std::filesystem::path path() const { return folder_.path(); }
    [[nodiscard]] std::filesystem::path out() const { return folder_.path() / "out"; }
    std::string write(const std::string& name, const std::string& bytes) const { return folder_.write(name, bytes).string(); }

    [[nodiscard]] Outcome run(const std::vector<std::string>& arguments, const ChildOptions& options = {}) const {
        return Child(folder_.path(), arguments, options).wait();
    }
    /// `gnomon shade` into out().
    [[nodiscard]] Outcome shade(std::vector<std::string> arguments, const ChildOptions& options = {}) const {
        arguments.insert(arguments.begin(), "shade");
        arguments.insert(arguments.end(), {"--out", out().string()});
        return run(arguments, options);
    }
    /// Names of all that is in out(), hidden files included.
    [[nodiscard]] std::set<std::string> left() const {
        std::set<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(out())) names.insert(entry.path().filename().string());
        return names;
    }

private:
    host::test::TemporaryFolder folder_;
};

inline std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::stringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        if (line.find_first_not_of(" \t\r") != std::string::npos) lines.push_back(line);
    return lines;
}

/// This exit code, one line on stderr that holds `part`, nothing in the folder.
inline void expectRefusal(const Stage& stage, const Outcome& outcome, int code, const std::string& part = {}) {
    EXPECT_EQ(outcome.code, code) << outcome.err;
    const auto lines = linesOf(outcome.err);
    EXPECT_EQ(lines.size(), 1u) << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with("gnomon: ")) << outcome.err;
    EXPECT_NE(outcome.err.find(part), std::string::npos) << "not said: " << part << "\nsaid: " << outcome.err;
    EXPECT_EQ(stage.left(), std::set<std::string>());
}

inline void expectDone(const Outcome& outcome) {
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
}

inline std::string sceneFile(const std::string& name) { return std::string(GNOMON_SCENES_DIR) + "/" + name + "/" + name + ".glb"; }

/// A floor with a cube above it: some hundred samples of each kind at any size from 16 x 16 on.
inline Builder smallScene() {
    Builder builder;
    builder.meshNode({-2, -0.5f, -2, 3, -0.5f, -2, 3, -0.5f, 3, -2, -0.5f, 3}, {0, 2, 1, 0, 3, 2});
    builder.meshNode(host::test::kCube, host::test::kCubeIndices);
    return builder;
}

}  // namespace gno::test
