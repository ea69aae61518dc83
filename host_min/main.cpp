// SPDX-License-Identifier: MIT
// The `gnomon` program: one line and an exit code for everything that can go wrong (0 done, 2 bad input or device, 1 anything else).
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "host_min/app/effects.hpp"
#include "host_min/app/lists.hpp"
#include "host_min/app/options.hpp"
#include "host_min/app/shade.hpp"
#include "host_min/error.hpp"
#include "host_min/interrupt.hpp"

namespace {

constexpr const char* kNoStandardOutput = "cannot write to standard output: is the disk full, or the reader gone?";

int run(int argc, const char* const* argv) {
    using namespace gno::host;
    const Command command = parseCommandLine(argc, argv);
    switch (command.kind) {
        case Command::Kind::none:
            break;
        case Command::Kind::shade:
            if (!shade(command.shade)) throw WorkError("the validation layer had something to say (see above)");
            break;
        case Command::Kind::effects: {
            const SceneFile file = SceneFile::load(command.scene);
            printEffects(file, file.evaluate(command.frame, 0));
            break;
        }
        case Command::Kind::techniques:
            printTechniques();
            break;
        case Command::Kind::device:
            printDevices();
            break;
    }
    if (std::fflush(stdout) != 0) throw WorkError(kNoStandardOutput);
    return 0;
}

int fail(const std::string& text, int code) {
    std::string line = text;
    for (char& c : line)
        if (c == '\n' || c == '\r') c = ' ';
    std::fprintf(stderr, "gnomon: %s\n", line.c_str());
    return code;
}

}  // namespace

int main(int argc, char** argv) {
    gno::host::catchInterrupts();
    try {
        return run(argc, argv);
    } catch (const gno::host::InputError& error) {
        return fail(error.what(), 2);
    } catch (const std::bad_alloc&) {
        return fail("out of memory: use a smaller --size or scene", 1);
    } catch (const std::exception& error) {  // fmt throws when its buffer does not go out
        return fail(std::ferror(stdout) ? kNoStandardOutput : error.what(), 1);
    }
}
