// SPDX-License-Identifier: MIT
#include "host_min/output/guarded.hpp"

#include <cerrno>
#include <cstdio>
#include <new>
#include <string>
#include <system_error>

#include "host_min/error.hpp"

namespace gno::host {
namespace {

constexpr const char* kNoStandardOutput = "cannot write to standard output: is the disk full, or the reader gone?";

/// A full disk is cured by the user.
int codeOfWriting(int error) { return error == ENOSPC || error == EDQUOT || error == EFBIG ? 2 : 1; }

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
        errno = 0;
        if (std::fflush(stdout) != 0 || std::ferror(stdout)) return fail(program, kNoStandardOutput, codeOfWriting(errno));
        return code;
    } catch (const InputError& error) {
        return fail(program, error.what(), 2);
    } catch (const RoomError& error) {
        return fail(program, error.what(), 2);
    } catch (const std::bad_alloc&) {
        return fail(program, std::string("out of memory: ") + lessMemory, 2);
    } catch (const std::system_error& error) {  // fmt throws when its buffer does not go out
        return fail(program, std::ferror(stdout) ? kNoStandardOutput : error.what(), std::ferror(stdout) ? codeOfWriting(error.code().value()) : 1);
    } catch (const std::exception& error) {
        return fail(program, std::ferror(stdout) ? kNoStandardOutput : error.what(), 1);
    }
}

}  // namespace gno::host
