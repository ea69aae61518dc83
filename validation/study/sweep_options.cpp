// SPDX-License-Identifier: MIT
#include "validation/study/sweep_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <sstream>

#include "host_min/error.hpp"

namespace gno::study {
namespace {

uint32_t number(const std::string& option, const std::string& text, const std::string& part) {
    constexpr uint32_t kMost = 1000000;
    uint32_t value = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    if (part.empty() || error != std::errc{} || end != part.data() + part.size() || value > kMost)
        throw host::InputError(fmt::format("{} {}: '{}' must be a whole number of 0 to {}", option, text, part, kMost));
    return value;
}

}  // namespace

std::string quoted(const std::string& word) {
    constexpr std::string_view harmless = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/%@";
    if (!word.empty() && word.find_first_not_of(harmless) == std::string::npos) return word;
    std::string result = "'";
    for (const char c : word) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

std::string stableHash(const std::string& text) {
    uint64_t hash = 14695981039346656037ull;
    for (const char c : text) hash = (hash ^ uint8_t(c)) * 1099511628211ull;
    return fmt::format("{:016x}", hash);
}

std::vector<std::string> splitAt(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::stringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);)
        if (!part.empty()) parts.push_back(part);
    return parts;
}

void addSweepOptions(CLI::App& command, SweepOptions& options) {
    command.add_option("SCENES", options.scenes, ".gltf or .glb files, or NAME[:TRIANGLES] of gnomon-scenes");
    command.add_option("--technique", options.techniques, "names, or all; peers are among them")->delimiter(',')->capture_default_str();
    command.add_option("--precision", options.precisions, "their precisions, or all")->delimiter(',')->capture_default_str();
    command.add_option("--size", options.sizes, "WIDTHxHEIGHT, one or more")->delimiter(',')->capture_default_str();
    command.add_option("--camera", options.camera, "index of the camera")->capture_default_str();
    command.add_option("--light", options.light, "index of the light, or all")->capture_default_str();
    command.add_option("--frame", options.frame, "A, A..B or A..B..STEP; time = frame / 30 s")->capture_default_str();
    command.add_option("--cull", options.culls, "none, front, hull, all; one or more")->delimiter(',')->capture_default_str();
    command.add_option("--set", options.set, "KEY=VALUE for the techniques that know the key; may be repeated")->allow_extra_args(false);
    command
        .add_option(
            "--vary", options.vary,
            "KEY=V1,V2,... beside the default; K1=V1,V2:K2=V3,V4 for all combinations; for the techniques that know the keys; may be repeated")
        ->allow_extra_args(false);
    command.add_option("--best", options.best, "KEY: one more row with the value that has the fewest wrong samples")->delimiter(',');
    command.add_option("--vary-scene", options.series, "NAME=TRIANGLES,TRIANGLES,... of gnomon-scenes")->allow_extra_args(false);
    command.add_option("--repeat", options.repeat, "times each variant is timed, in turns")->capture_default_str()->check(CLI::Range(1, 1000));
}

SweepOptions parseSweepLine(const std::string& line) {
    SweepOptions options;
    CLI::App app("a sweep");
    addSweepOptions(app, options);
    try {
        app.parse(line);
    } catch (const CLI::ParseError& error) {
        throw host::InputError(fmt::format("'{}': {}", line, error.what()));
    }
    return options;
}

std::string commandWords(const SweepOptions& options) {
    std::vector<std::string> words;
    for (const std::string& scene : options.scenes) words.push_back(quoted(scene));
    const auto add = [&](const char* option, const std::string& value) { words.push_back(fmt::format("{} {}", option, quoted(value))); };
    for (const std::string& entry : options.series) add("--vary-scene", entry);
    add("--technique", fmt::format("{}", fmt::join(options.techniques, ",")));
    add("--precision", fmt::format("{}", fmt::join(options.precisions, ",")));
    add("--size", fmt::format("{}", fmt::join(options.sizes, ",")));
    add("--camera", std::to_string(options.camera));
    add("--light", options.light);
    add("--frame", options.frame);
    add("--cull", fmt::format("{}", fmt::join(options.culls, ",")));
    for (const std::string& entry : options.set) add("--set", entry);
    for (const std::string& entry : options.vary) add("--vary", entry);
    for (const std::string& key : options.best) add("--best", key);
    add("--repeat", std::to_string(options.repeat));
    return fmt::format("{}", fmt::join(words, " "));
}

std::vector<uint32_t> framesOf(const std::string& text) {
    std::vector<std::string> parts;
    size_t begin = 0;
    for (size_t at = text.find(".."); at != std::string::npos; at = text.find("..", begin)) {
        parts.push_back(text.substr(begin, at - begin));
        begin = at + 2;
    }
    parts.push_back(text.substr(begin));
    if (parts.size() > 3) throw host::InputError(fmt::format("--frame {}: write A, A..B or A..B..STEP", text));
    const uint32_t first = number("--frame", text, parts[0]), last = parts.size() > 1 ? number("--frame", text, parts[1]) : first;
    const uint32_t step = parts.size() > 2 ? number("--frame", text, parts[2]) : 1;
    if (last < first) throw host::InputError(fmt::format("--frame {}: the last frame is before the first", text));
    if (step == 0) throw host::InputError(fmt::format("--frame {}: a step of 0 never arrives", text));
    std::vector<uint32_t> frames;
    for (uint32_t frame = first; frame <= last; frame += step) frames.push_back(frame);
    return frames;
}

std::pair<uint32_t, uint32_t> sizeOf(const std::string& text) {
    const std::vector<std::string> parts = splitAt(text, 'x');
    if (parts.size() != 2) throw host::InputError(fmt::format("--size {}: write WIDTHxHEIGHT, for example 640x360", text));
    return {number("--size", text, parts[0]), number("--size", text, parts[1])};
}

std::optional<uint32_t> lightOf(const std::string& text) {
    if (text == "all") return std::nullopt;
    return number("--light", text, text);
}

}  // namespace gno::study
