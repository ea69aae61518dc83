// SPDX-License-Identifier: MIT
#include "viz/options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdio>

#include "host_min/error.hpp"

#ifndef GNOMON_VERSION
#error "the build defines GNOMON_VERSION"
#endif

namespace gno::viz {
namespace {

using host::InputError;

struct Texts {
    std::string size = "1600x1000", view = "overview", limit, closeAfter = "0", color, cell;
    std::vector<std::string> dumps;
    std::string out = "out";
};

uint32_t number(const std::string& option, std::string_view text, uint32_t least, uint32_t most) {
    uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || error != std::errc{} || end != text.data() + text.size() || value < least || value > most)
        throw InputError(fmt::format("{} {}: must be a whole number of {} to {}", option, text, least, most));
    return value;
}

void parseSize(const std::string& text, PictureSize& size) {
    constexpr uint32_t kLeast = 200, kMost = 8192;
    const size_t at = text.find('x');
    if (at == std::string::npos) throw InputError(fmt::format("--size {}: write WIDTHxHEIGHT, for example 1600x1000", text));
    size.width = int(number("--size", std::string_view(text).substr(0, at), kLeast, kMost));
    size.height = int(number("--size", std::string_view(text).substr(at + 1), kLeast, kMost));
}

Options optionsOf(const Texts& texts, bool interactive) {
    Options options;
    for (const std::string& dump : texts.dumps) options.dumps.emplace_back(dump);
    options.out = texts.out;
    options.color = texts.color;
    options.interactive = interactive;
    parseSize(texts.size, options.size);
    options.view = texts.view == "camera" ? View::camera : View::overview;
    options.limit = number("--limit", texts.limit, 1, 10000000);
    if (!texts.cell.empty()) options.cell = number("--cell", texts.cell, 0, 0xFFFFFFFFu);
    options.closeAfter = number("--close-after", texts.closeAfter, 0, 86400);
    if (options.closeAfter > 0 && !interactive) throw InputError("--close-after: only together with --interactive");
    return options;
}

}  // namespace

Command parseCommandLine(int argc, const char* const* argv) {
    CLI::App app("gnomon-viz: pictures and VTK files of what `gnomon shade --dump` wrote: TOP trees, cluster hierarchies, forests, wrong samples.");
    app.set_version_flag("--version", std::string("gnomon-viz ") + GNOMON_VERSION);
    app.require_subcommand(1);
    bool interactive = false;
    struct Sub {
        Command::Kind kind;
        const char *name, *help, *limit, *primitives;
        std::vector<std::string> colors;
        Texts texts{};
        CLI::App* app = nullptr;
    };
    std::vector<Sub> subs{
        {Command::Kind::tree,
         "tree",
         "the shadow volumes of a TOP tree, a query's way through it, and its statistics",
         "1000",
         "shadow volumes",
         {"depth", "kind", "distance", "visits"}},
        {Command::Kind::clusters,
         "clusters",
         "the occupied nodes of a cluster hierarchy by level, and the tests of each pixel",
         "20000",
         "boxes of a level",
         {"accepted", "distance"}},
        {Command::Kind::samples, "samples", "wrong samples with the caster and the plane that decided them", "2000", "samples", {"error", "plane"}},
        {Command::Kind::forest,
         "forest",
         "the cells of a forest by casters and by visited nodes, and one cell's tree in the scene",
         "100000",
         "casters of the cell's tree",
         {"depth", "kind", "distance"}}};
    for (Sub& sub : subs) {
        sub.texts.limit = sub.limit;
        sub.texts.color = sub.colors.front();
        sub.app = app.add_subcommand(sub.name, sub.help);
        sub.app->add_option("DUMP", sub.texts.dumps, "SCENE-lN-fNNN-TECHNIQUE.PRECISION-dump.json")->required();
        sub.app->add_option("--color", sub.texts.color, fmt::format("what colours tell: {}", CLI::detail::join(sub.colors, ", ")))
            ->capture_default_str();
        sub.app->add_option("--view", sub.texts.view, "camera or overview")->capture_default_str();
        sub.app->add_option("--limit", sub.texts.limit, fmt::format("most {} that are drawn", sub.primitives))->capture_default_str();
        sub.app->add_option("--size", sub.texts.size, "WIDTHxHEIGHT of the pictures, in pixels")->capture_default_str();
        sub.app->add_option("--out", sub.texts.out, "folder for everything that is written")->capture_default_str();
        if (sub.kind == Command::Kind::forest)
            sub.app->add_option("--cell", sub.texts.cell, "whose tree is drawn; without it, the one with most casters");
        sub.app->add_flag("--interactive", interactive, "show it, with a slider, instead of writing files");
        sub.app->add_option("--close-after", sub.texts.closeAfter, "with --interactive: seconds until the window closes by itself, 0: never")
            ->capture_default_str();
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        std::fputs((app.get_subcommands().empty() ? app.help() : app.get_subcommands().front()->help()).c_str(), stdout);
        return {};
    } catch (const CLI::CallForVersion&) {
        std::puts(app.version().c_str());
        return {};
    } catch (const CLI::ParseError& error) {
        std::string text = error.what();
        std::replace(text.begin(), text.end(), '\n', ' ');
        throw InputError(text + "; `gnomon-viz --help` and `gnomon-viz COMMAND --help` tell what there is");
    }
    for (const Sub& sub : subs) {
        if (!*sub.app) continue;
        if (std::find(sub.colors.begin(), sub.colors.end(), sub.texts.color) == sub.colors.end())
            throw InputError(fmt::format("--color {}: {} knows {}", sub.texts.color, sub.name, CLI::detail::join(sub.colors, ", ")));
        if (sub.texts.view != "camera" && sub.texts.view != "overview")
            throw InputError(fmt::format("--view {}: camera or overview", sub.texts.view));
        return {sub.kind, optionsOf(sub.texts, interactive)};
    }
    return {};
}

}  // namespace gno::viz
