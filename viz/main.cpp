// SPDX-License-Identifier: MIT
// The `gnomon-viz` program: one line and an exit code for everything that can go wrong (0 done, 2 bad input or no display, 1 anything else).
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "host_min/error.hpp"
#include "viz/display.hpp"
#include "viz/views.hpp"

namespace {

int run(int argc, const char* const* argv) {
    using namespace gno::viz;
    const Command command = parseCommandLine(argc, argv);
    if (command.kind == Command::Kind::none) return 0;
    for (const auto& dump : command.options.dumps) (void)Dump::load(dump);  // before a display is started
    const Display display;
    if (command.options.interactive && !display.isUsers()) throw gno::host::InputError("--interactive: there is no display that shows it");
    switch (command.kind) {
        case Command::Kind::tree: viewTree(command.options); break;
        case Command::Kind::clusters: viewClusters(command.options); break;
        case Command::Kind::samples: viewSamples(command.options); break;
        case Command::Kind::none: break;
    }
    if (std::fflush(stdout) != 0) throw gno::host::WorkError("cannot write to standard output: is the disk full, or the reader gone?");
    return 0;
}

int fail(const std::string& text, int code) {
    std::string line = text;
    for (char& c : line)
        if (c == '\n' || c == '\r') c = ' ';
    std::fprintf(stderr, "gnomon-viz: %s\n", line.c_str());
    return code;
}

}  // namespace

int main(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN);  // a file size limit or a closed pipe is an error, and no sudden death
    std::signal(SIGPIPE, SIG_IGN);
    try {
        return run(argc, argv);
    } catch (const gno::host::InputError& error) {
        return fail(error.what(), 2);
    } catch (const std::bad_alloc&) {
        return fail("out of memory: use a smaller --limit", 1);
    } catch (const std::exception& error) {
        return fail(error.what(), 1);
    }
}
