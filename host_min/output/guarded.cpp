// SPDX-License-Identifier: MIT
#include "host_min/output/guarded.hpp"

#include <cstdio>
#include <new>
#include <string>

#include "host_min/error.hpp"

namespace gno::host {
namespace {

constexpr const char* kNoStandardOutput = "cannot write to standard output: is the disk full, or the reader gone?";

int fail(const char* program, std::string line, int code) {
    for (char& c : line)
        if (c == '\n' || c == '\r') c = ' ';
    std::fprintf(stderr, "%s: %s\n", program, line.c_str());
    return code;
}

}  // namespace

int guarded(const char* program, const char* lessMemory, const std::function<int()>& run) {
    try {
        const int code = run();
        if (std::fflush(stdout) != 0 || std::ferror(stdout)) return fail(program, kNoStandardOutput, 1);
        return code;
    } catch (const InputError& error) {
        return fail(program, error.what(), 2);
    } catch (const std::bad_alloc&) {
        return fail(program, std::string("out of memory: ") + lessMemory, 1);
    } catch (const std::exception& error) {  // fmt throws when its buffer does not go out
        return fail(program, std::ferror(stdout) ? kNoStandardOutput : error.what(), 1);
    }
}

}  // namespace gno::host
