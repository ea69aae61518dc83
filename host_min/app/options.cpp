// SPDX-License-Identifier: MIT
#include "host_min/app/options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <sstream>

#include "host_min/error.hpp"
#include "host_min/scene/one_line.hpp"

#ifndef GNOMON_VERSION
#error "the build defines GNOMON_VERSION"
#endif

namespace gno::host {
namespace {

uint32_t number(const std::string& option, std::string_view text, uint32_t maximum = 4294967295u) {
    uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || error != std::errc{} || end != text.data() + text.size() || value > maximum)
        throw InputError(fmt::format("{} {}: must be a whole number of 0 to {}", option, oneLine(text), maximum));
    return value;
}

void parseSize(const std::string& text, ShadeOptions& options) {
    const size_t at = text.find('x');
    if (at == std::string::npos) throw InputError(fmt::format("--size {}: write WIDTHxHEIGHT, for example 1024x1024", oneLine(text)));
    try {
        options.width = number("--size", std::string_view(text).substr(0, at));
        options.height = number("--size", std::string_view(text).substr(at + 1));
    } catch (const InputError&) {
        throw InputError(fmt::format("--size {}: write WIDTHxHEIGHT, for example 1024x1024", oneLine(text)));
    }
    checkSize({}, options.width, options.height);
}

void parseFrames(const std::string& text, ShadeOptions& options) {
    constexpr uint32_t kLastFrame = 1000000;
    const size_t at = text.find("..");
    try {
        options.firstFrame = number("--frame", text.substr(0, at), kLastFrame);
        options.lastFrame = at == std::string::npos ? options.firstFrame : number("--frame", text.substr(at + 2), kLastFrame);
    } catch (const InputError&) {
        throw InputError(fmt::format("--frame {}: write A or A..B, whole numbers of 0 to {}", oneLine(text), kLastFrame));
    }
    if (options.lastFrame < options.firstFrame) throw InputError(fmt::format("--frame {}: the last frame is before the first", text));
}

void parseTrace(const std::string& text, ShadeOptions& options) {
    const size_t at = text.find(',');
    if (at == std::string::npos) throw InputError(fmt::format("--trace {}: write X,Y, a pixel counted from the upper left corner", oneLine(text)));
    if (!options.dump) throw InputError("--trace: only together with --dump, which writes what is logged");
    options.trace = {number("--trace", text.substr(0, at), options.width - 1), number("--trace", text.substr(at + 1), options.height - 1)};
}

std::vector<std::string> splitList(const std::string& text) {
    std::vector<std::string> parts;
    std::stringstream stream(text);
    for (std::string part; std::getline(stream, part, ',');)
        if (!part.empty()) parts.push_back(part);
    return parts;
}

/// For a word that would be said as a key of --set; nothing without one.
std::string hintAtSet(const std::vector<std::string>& words) {
    std::vector<std::span<const SettingInfo>> all{frameSettings()};
    for (const auto& technique : techniques()) all.emplace_back(technique->info().settings);
    for (size_t i = 0; i < words.size(); ++i) {
        if (!words[i].starts_with("--")) continue;
        const size_t sign = words[i].find('=');
        const std::string key = words[i].substr(2, sign == std::string::npos ? sign : sign - 2);
        for (const auto& settings : all)
            for (const SettingInfo& setting : settings) {
                if (setting.key != key) continue;
                const bool hasNext = i + 1 < words.size() && !words[i + 1].starts_with("-");
                const std::string value = sign != std::string::npos ? words[i].substr(sign + 1) : hasNext ? words[i + 1] : "VALUE";
                return fmt::format("; {} is a key of --set: write --set {}={}", key, key, oneLine(value));
            }
    }
    return {};
}

}  // namespace

Command parseCommandLine(int argc, const char* const* argv) {
    Command command;
    ShadeOptions& shade = command.shade;
    CLI::App app("gnomon: which view samples are in shadow? Pixel-exact answers from GLSL modules, on any Vulkan device.");
    app.set_version_flag("--version", std::string("gnomon ") + GNOMON_VERSION);
    app.require_subcommand(1);

    std::string technique = "auto", precision = "certified", size = "1024x1024", light = "0", frame = "0", scene, out = "out", json, trace;
    std::string camera = "0", repeat = "1", effectsFrame = "0";
    CLI::App* shadeCommand = app.add_subcommand("shade", "shade frames of a glTF scene; write pictures, EXR layers and a record");
    shadeCommand->add_option("SCENE", scene, ".gltf or .glb file")->required();
    shadeCommand->add_option("--technique", technique, "names separated by commas, all, or auto")->capture_default_str();
    shadeCommand->add_option("--precision", precision, "published, conservative or certified")->capture_default_str();
    shadeCommand->add_option("--size", size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    shadeCommand->add_option("--camera", camera, "index of the camera")->capture_default_str();
    shadeCommand->add_option("--light", light, "index of the light, or all")->capture_default_str();
    shadeCommand->add_option("--frame", frame, "A or A..B; time = frame / 30 s")->capture_default_str();
    const char* animationHelp = "number or name of the animation to apply, or all (a later one wins); default: the first one";
    shadeCommand->add_option("--animation", shade.animation, animationHelp);
    shadeCommand->add_option("--set", shade.settings, "KEY=VALUE, may be repeated; `gnomon techniques` lists the keys")->allow_extra_args(false);
    shadeCommand->add_flag("--check", shade.check, "compare with the exact oracle");
    shadeCommand->add_option("--repeat", repeat, "timed runs; the median is told")->capture_default_str();
    shadeCommand->add_flag("--dump", shade.dump, "write the techniques' buffers");
    const CLI::Option* traceOption = shadeCommand->add_option("--trace", trace, "X,Y: with --dump, log the nodes that this pixel's query visits");
    bool noPictures = false;
    shadeCommand->add_flag("--no-pictures", noPictures, "write no PNG and no EXR");
    shadeCommand->add_option("--out", out, "folder for everything that is written")->capture_default_str();
    shadeCommand->add_option("--json", json, "file for the record (JSON Lines); what it held before is replaced");
    const char* quietHelp = "do not tell what of the file is not used";
    shadeCommand->add_flag("--quiet", shade.quiet, quietHelp);
    CLI::App* effectsCommand = app.add_subcommand("effects", "what a scene calls for, what is therefore built, and why");
    effectsCommand->add_option("SCENE", scene, ".gltf or .glb file")->required();
    effectsCommand->add_option("--frame", effectsFrame, "time = frame / 30 s")->capture_default_str();
    effectsCommand->add_option("--animation", command.animation, animationHelp);
    effectsCommand->add_flag("--quiet", command.quiet, quietHelp);
    CLI::App* techniquesCommand = app.add_subcommand("techniques", "what this device can run, what is missing for the rest, and every key of --set");
    CLI::App* deviceCommand = app.add_subcommand("device", "the device, its limits, the subgroup width");

    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        std::fputs((app.get_subcommands().empty() ? app.help() : app.get_subcommands().front()->help()).c_str(), stdout);
        return command;
    } catch (const CLI::CallForVersion&) {
        std::puts(app.version().c_str());
        return command;
    } catch (const CLI::ParseError& error) {
        std::string text = error.what();
        std::replace(text.begin(), text.end(), '\n', ' ');
        const std::string hint = *shadeCommand ? hintAtSet({argv, argv + argc}) : std::string();
        throw InputError(oneLine(text) + hint + "; `gnomon --help` and `gnomon COMMAND --help` tell what there is");
    }

    if (*shadeCommand) {
        command.kind = Command::Kind::shade;
        shade.scene = scene;
        shade.out = out;
        shade.json = json;
        shade.pictures = !noPictures;
        shade.precision = precisionByName(precision);
        parseSize(size, shade);
        parseFrames(frame, shade);
        if (*traceOption) parseTrace(trace, shade);
        shade.camera = number("--camera", camera);
        shade.repeat = number("--repeat", repeat, 1000);
        if (shade.repeat == 0) throw InputError("--repeat 0: at least one timed run is needed");
        if (light == "all")
            shade.light.reset();
        else
            shade.light = number("--light", light);
        if (technique == "all")
            shade.allTechniques = true;
        else if (technique != "auto") {
            shade.techniques = splitList(technique);
            if (shade.techniques.empty()) throw InputError("--technique: no name was given");
        }
    } else if (*effectsCommand) {
        command.kind = Command::Kind::effects;
        command.scene = scene;
        command.frame = number("--frame", effectsFrame, 1000000);
    } else if (*techniquesCommand) {
        command.kind = Command::Kind::techniques;
    } else if (*deviceCommand) {
        command.kind = Command::Kind::device;
    }
    return command;
}

std::vector<Technique*> chooseTechniques(const ShadeOptions& options, std::string& leftOut,
                                         const std::vector<std::unique_ptr<Technique>>& available) {
    std::vector<Technique*> chosen;
    const auto has = [&](const Technique& technique) {
        const auto& rungs = technique.info().precisions;
        return std::find(rungs.begin(), rungs.end(), options.precision) != rungs.end();
    };
    if (options.allTechniques) {
        std::vector<std::string> without;
        for (const auto& technique : available) {
            if (has(*technique))
                chosen.push_back(technique.get());
            else
                without.push_back(technique->info().name);
        }
        if (chosen.empty()) throw InputError(fmt::format("no technique has precision {}", name(options.precision)));
        if (!without.empty()) leftOut = fmt::format("left out, no precision {}: {}", name(options.precision), fmt::join(without, ", "));
    }
    for (const std::string& wanted : options.techniques) {
        const auto at = std::find_if(available.begin(), available.end(), [&](const auto& technique) { return technique->info().name == wanted; });
        Technique& technique = at != available.end() ? **at : techniqueByName(wanted);  // which tells what there is
        if (!has(technique)) throw InputError(fmt::format("technique {} has no precision {}", wanted, name(options.precision)));
        if (std::find(chosen.begin(), chosen.end(), &technique) == chosen.end()) chosen.push_back(&technique);
    }
    std::vector<std::span<const SettingInfo>> known{frameSettings()};
    const auto add = [&](const Technique& technique) {
        known.emplace_back(technique.info().settings);
        Settings(technique.info().settings, options.settings);  // throws when a value is out of range
    };
    if (chosen.empty())
        for (const auto& technique : available) add(*technique);
    for (const Technique* technique : chosen) add(*technique);
    checkSettings(known, options.settings);
    Settings(frameSettings(), options.settings);
    return chosen;
}

}  // namespace gno::host
