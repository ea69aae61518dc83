// SPDX-License-Identifier: MIT
// gnomon-scenes: makes the scenes that are computed instead of shipped. Exit codes: 0 done, 2 bad arguments, 1 anything else.
#include <CLI/CLI.hpp>

#include <cstdio>

#include "host_min/error.hpp"
#include "host_min/output/guarded.hpp"
#include "scenes/generator/catalogue.hpp"
#include "scenes/generator/glb.hpp"

namespace gno::scenes {
namespace {

struct Arguments {
    std::string name;
    std::optional<size_t> size;
    uint64_t seed = 1;
    std::filesystem::path out = "scenes/generated";
    std::filesystem::path models = "scenes";
};

void printList() {
    std::printf("%-13s %10s  %-6s  %s\n", "name", "triangles", "closed", "stands for");
    for (const Kind& kind : catalogue())
        std::printf("%-13s %10zu  %-6s  %s\n", kind.name, kind.defaultSize, kind.closed ? "yes" : "no", kind.standsFor);
}

void make(const Kind& kind, const Arguments& arguments) {
    const Draft draft = makeScene(kind, arguments.size, arguments.seed, arguments.models);
    const std::filesystem::path path = arguments.out / (std::string(kind.name) + ".glb");
    const std::string bytes = encodeGlb(draft, kind.name);
    writeFile(path, bytes);
    std::printf("%s: %zu triangles, %zu nodes, %zu bytes, seed %llu\n", path.string().c_str(), draft.triangleCount(), draft.nodes.size(),
                bytes.size(), static_cast<unsigned long long>(arguments.seed));
}

int run(int argc, char** argv) {
    CLI::App app("Makes the procedural scenes and shows of gnomon as GLB files", "gnomon-scenes");
    app.require_subcommand(1);
    CLI::App* list = app.add_subcommand("list", "Names, triangles at the default size, what each scene stands for");
    CLI::App* maker = app.add_subcommand("make", "Writes a scene");
    Arguments arguments;
    maker->add_option("name", arguments.name, "A name from the list, or all")->required();
    maker->add_option("--size", arguments.size, "About how many triangles; procedural scenes only");
    maker->add_option("--seed", arguments.seed, "Same arguments, same bytes")->capture_default_str();
    maker->add_option("--out", arguments.out, "Folder of the files")->capture_default_str();
    maker->add_option("--models", arguments.models, "Folder of the shipped models, read by the shows")->capture_default_str();
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error);
        throw host::InputError(std::string(error.what()) + " (see gnomon-scenes --help)");
    }
    if (*list) {
        printList();
        return 0;
    }
    if (arguments.name != "all") {
        make(findKind(arguments.name), arguments);
        return 0;
    }
    if (arguments.size) throw host::InputError("--size goes with one scene: name it instead of all");
    for (const Kind& kind : catalogue()) make(kind, arguments);
    return 0;
}

}  // namespace
}  // namespace gno::scenes

int main(int argc, char** argv) {
    return gno::host::guarded("gnomon-scenes", "use a smaller --size", [&] { return gno::scenes::run(argc, argv); });
}
