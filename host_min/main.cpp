// SPDX-License-Identifier: MIT
// The `gnomon` program: one line and an exit code for everything that can go wrong (0 done, 2 bad input or device, 1 anything else).
#include "host_min/app/effects.hpp"
#include "host_min/app/lists.hpp"
#include "host_min/app/options.hpp"
#include "host_min/app/shade.hpp"
#include "host_min/error.hpp"
#include "host_min/interrupt.hpp"
#include "host_min/output/atomic_file.hpp"
#include "host_min/output/guarded.hpp"
#include "host_min/vulkan/faults.hpp"

namespace {

int run(int argc, const char* const* argv) {
    using namespace gno::host;
    const Command command = parseCommandLine(argc, argv);
    switch (command.kind) {
        case Command::Kind::none:
            break;
        case Command::Kind::shade:
            withVulkanFaults([&] {
                if (!shade(command.shade)) throw WorkError("the validation layer had something to say (see above)");
            });
            break;
        case Command::Kind::effects: {
            const SceneFile file = SceneFile::load(command.scene, command.animation);
            printEffects(file, file.evaluate(command.frame, 0), command.quiet);
            break;
        }
        case Command::Kind::techniques:
            printTechniques();
            break;
        case Command::Kind::device:
            printDevices();
            break;
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    gno::host::catchInterrupts("gnomon", gno::host::removeUnfinishedFiles);
    return gno::host::guarded("gnomon", "use a smaller --size or scene", [&] { return run(argc, argv); });
}
