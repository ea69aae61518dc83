// SPDX-License-Identifier: MIT
// gnomon-fuzz [--seconds N] [--seed S] [--corpus FOLDER] [--keep FILE] [--variant NAME]: a fuzzer that needs no compiler of its own.
// First every file of the corpus, then N seconds of mutated ones. An input whose scene did something new joins the pool. At the first finding it
// prints the scene, writes the bytes to FILE (default fuzz-finding.bin) and ends with exit code 1; 2 is a wrong command line or an empty corpus
// folder.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <set>
#include <stdexcept>

#include "validation/fuzz/finding.hpp"

namespace {

using Bytes = std::vector<uint8_t>;

struct Options {
    double seconds = 10;
    uint64_t seed = 1;
    std::string corpus, keep = "fuzz-finding.bin", variant;
};

Options parse(int argc, char** argv) {
    Options options;
    for (int i = 1; i < argc; i += 2) {
        const std::string name = argv[i];
        if (i + 1 >= argc) throw std::invalid_argument("'" + name + "' needs a value");
        const std::string value = argv[i + 1];
        if (name == "--seconds")
            options.seconds = std::stod(value);
        else if (name == "--seed")
            options.seed = std::stoull(value);
        else if (name == "--corpus")
            options.corpus = value;
        else if (name == "--keep")
            options.keep = value;
        else if (name == "--variant")
            options.variant = value;
        else
            throw std::invalid_argument("'" + name + "' is none of --seconds, --seed, --corpus, --keep, --variant");
    }
    return options;
}

std::vector<std::filesystem::path> filesOf(const std::string& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.is_regular_file()) files.push_back(entry.path());
    }
    if (files.empty()) throw std::invalid_argument("no file in corpus folder '" + folder + "'");
    std::sort(files.begin(), files.end());
    return files;
}

class Fuzzer {
public:
    explicit Fuzzer(const Options& options) : options_(options), random_(options.seed) {}

    /// False: a finding, printed and kept.
    bool run() {
        if (!options_.corpus.empty()) {
            for (const auto& file : filesOf(options_.corpus)) {
                std::ifstream stream(file, std::ios::binary);
                const Bytes bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
                if (!examine(bytes, file.filename().string())) return false;
            }
            std::printf("corpus: %llu files, nothing wrong\n", count());
        }
        const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(options_.seconds);
        while (std::chrono::steady_clock::now() < end) {
            if (!examine(next(), "a new input")) return false;
        }
        std::printf("%llu inputs, %zu kinds, nothing wrong (seed %llu)\n", count(), seen_.size(), static_cast<unsigned long long>(options_.seed));
        return true;
    }

private:
    [[nodiscard]] unsigned long long count() const { return static_cast<unsigned long long>(executions_); }
    size_t below(size_t n) { return size_t(random_() % n); }

    bool examine(const Bytes& bytes, const std::string& name) {
        ++executions_;
        const gno::fuzz::Finding finding = gno::fuzz::examine(bytes, options_.variant);
        if (!finding.what.empty()) {
            std::ofstream(options_.keep, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
            std::printf("input %llu (%s), kept as %s\n%s", count(), name.c_str(), options_.keep.c_str(), finding.what.c_str());
            return false;
        }
        if (seen_.insert(finding.signature).second && pool_.size() < 4096) pool_.push_back(bytes);
        return true;
    }

    Bytes next() {
        if (pool_.empty() || below(4) == 0) {
            Bytes bytes(20 + below(500));
            for (uint8_t& b : bytes) b = uint8_t(random_());
            return bytes;
        }
        Bytes bytes = pool_[below(pool_.size())];
        for (size_t changes = 1 + below(4); changes > 0; --changes) {
            if (bytes.empty()) bytes.push_back(0);
            const size_t at = below(bytes.size());
            const Bytes& other = pool_[below(pool_.size())];
            switch (below(5)) {
                case 0:
                    bytes[at] = uint8_t(random_());
                    break;
                case 1:
                    bytes[at] = uint8_t(bytes[at] ^ (1u << below(8)));
                    break;
                case 2:
                    bytes.insert(bytes.begin() + std::ptrdiff_t(at), uint8_t(random_()));
                    break;
                case 3:
                    bytes.erase(bytes.begin() + std::ptrdiff_t(at));
                    break;
                default:
                    std::copy(other.begin(), other.begin() + std::ptrdiff_t(std::min(other.size(), bytes.size() - at) / 2),
                              bytes.begin() + std::ptrdiff_t(at));
            }
        }
        bytes.resize(std::min<size_t>(bytes.size(), 1024));
        return bytes;
    }

    Options options_;
    std::mt19937_64 random_;
    std::vector<Bytes> pool_;
    std::set<uint64_t> seen_;
    uint64_t executions_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
    try {
        return Fuzzer(parse(argc, argv)).run() ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "gnomon-fuzz: %s\n", error.what());
        return 2;
    }
}
