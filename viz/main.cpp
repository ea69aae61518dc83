// SPDX-License-Identifier: MIT
// The `gnomon-viz` program: one line and an exit code for everything that can go wrong (0 done, 2 bad input or no display, 1 anything else).
#include <csignal>

#include "host_min/error.hpp"
#include "host_min/output/guarded.hpp"
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
        case Command::Kind::tree:
            viewTree(command.options);
            break;
        case Command::Kind::clusters:
            viewClusters(command.options);
            break;
        case Command::Kind::samples:
            viewSamples(command.options);
            break;
        case Command::Kind::forest:
            viewForest(command.options);
            break;
        case Command::Kind::none:
            break;
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN);  // a file size limit or a closed pipe is an error, and no sudden death
    std::signal(SIGPIPE, SIG_IGN);
    return gno::host::guarded("gnomon-viz", "use a smaller --limit", [&] { return run(argc, argv); });
}
