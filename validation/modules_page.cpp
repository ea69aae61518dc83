// SPDX-License-Identifier: MIT
// gnomon-modules: the tables of glsl/MODULES.md, from the lists themselves. `gnomon-modules --update FILE` writes them between the marks
// <!-- TECHNIQUE: begin --> and <!-- TECHNIQUE: end -->; without --update it only looks, exit status 1 when the file says something else.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "host_min/error.hpp"
#include "host_min/output/atomic_file.hpp"
#include "host_min/output/guarded.hpp"
#include "validation/support/module_lists.hpp"

namespace gno::test {
namespace {

/// Words, wrapped to lines of 149 columns.
std::string wrapped(const std::vector<std::string>& words) {
    std::string text, line;
    for (const std::string& word : words) {
        if (!line.empty() && line.size() + 1 + word.size() > 149) {
            text += line + "\n";
            line.clear();
        }
        line += (line.empty() ? "" : " ") + word;
    }
    return text + line + "\n";
}

std::string waitsFor(uint32_t before) {
    std::vector<std::string> words;
    for (const auto& [bit, word] : {std::pair(kBeforeShaders, "shaders"), std::pair(kBeforeIndirect, "indirect"),
                                    std::pair(kBeforeTransfer, "transfer"), std::pair(kBeforeDepth, "depth"), std::pair(kBeforeRays, "rays")})
        if (before & bit) words.push_back(word);
    return words.empty() ? "nothing" : fmt::format("{}", fmt::join(words, ", "));
}

std::string groupsOf(const Pass& pass) {
    if (pass.kind == PassKind::command) return "command";
    if (pass.kind == PassKind::fullscreen) return "full screen";
    if (pass.kind == PassKind::depth) return "draw";
    if (!pass.indirect.empty()) return fmt::format("{} + {}", pass.indirect, pass.indirectOffset);
    std::string text = std::to_string(pass.groups[0]);
    for (const uint32_t more : {pass.groups[1], pass.groups[2]})
        if (more > 1 || (more == pass.groups[1] && pass.groups[2] > 1)) text += fmt::format(" x {}", more);
    return text;
}

std::string constantsOf(const Pass& pass) {
    std::vector<std::string> words;
    for (const Constant& constant : pass.constants) words.push_back(fmt::format("{} {}", constant.name, constant.value));
    return fmt::format("{}", fmt::join(words, ", "));
}

std::string writesOf(const Pass& pass) {
    return fmt::format("{}", fmt::join(std::vector<std::string>(pass.writes.begin(), pass.writes.end()), ", "));
}

/// A row for passes of one shader and the same constants; how many follow each other, and their numbers.
std::string passTable(const PassList& list) {
    std::string text = "| pass | times | work groups | waits for | writes | constants |\n| --- | --- | --- | --- | --- | --- |\n";
    std::vector<bool> told(list.size(), false);
    for (size_t i = 0; i < list.size(); ++i) {
        if (told[i]) continue;
        uint32_t times = 0, least = list[i].number, most = list[i].number;
        for (size_t k = i; k < list.size(); ++k) {
            if (list[k].shader != list[i].shader || constantsOf(list[k]) != constantsOf(list[i])) continue;
            told[k] = true;
            ++times;
            least = std::min(least, list[k].number);
            most = std::max(most, list[k].number);
        }
        const std::string numbers = most > least ? fmt::format(", number {} .. {}", least, most) : "";
        text += fmt::format("| `{}` | {}{} | {} | {} | {} | {} |\n", list[i].shader, times, numbers, groupsOf(list[i]), waitsFor(list[i].before),
                            writesOf(list[i]), constantsOf(list[i]));
    }
    return text;
}

std::string arrayTable(const ArrayList& arrays) {
    std::string text = "| array | set, binding | holds | bytes | use | at first | kept for |\n| --- | --- | --- | --- | --- | --- | --- |\n";
    for (const Array& array : arrays) {
        std::vector<std::string> uses;
        for (const auto& [bit, word] : {std::pair(kUsageStorage, "storage"), std::pair(kUsageUniform, "uniform"),
                                        std::pair(kUsageIndirect, "indirect"), std::pair(kUsageRayInput, "build input")})
            if (array.usage & bit) uses.push_back(word);
        text += fmt::format("| `{}` | {}, {} | {} | {} | {} | {} | {} |\n", array.name, array.set, array.binding, array.element, array.bytes,
                            fmt::join(uses, ", "),
                            array.first == First::host   ? "yours"
                            : array.first == First::zero ? "zero"
                                                         : "anything",
                            array.kept == Kept::forQuery ? "queries" : "the build");
    }
    return text;
}

std::string block(const ModuleLists& lists) {
    std::string text =
        "Copy, into a folder that your `-I` knows as `gnomon`:\n```\n" + wrapped(filesToCopy(lists, GNOMON_SOURCE_DIR "/glsl")) + "```\n";
    text += "In your shader:\n```glsl\n#define GNO_LIGHT frame.light\n";
    for (const std::string& line : lists.defines) text += line + "\n";
    for (const std::string& file : lists.includes) text += "#include \"gnomon/" + file + "\"\n";
    text += "... bool dark = " + lists.question + ";   // GnoViewSample s = GnoViewSample(position, primitive)\n```\n";
    const std::string query = fmt::format("query, {}x{} samples:\n\n", kListWidth, kListHeight) + passTable(lists.query);
    if (!lists.asks.empty()) return text + "Buffers and build are those of " + lists.asks + "; " + query;
    text += fmt::format("Buffers, for {} casters:\n\n", kListCasters) + arrayTable(lists.arrays);
    text += "\nPasses, from `" + lists.header + "`, build:\n\n" + passTable(lists.build) + "\nand " + query;
    return text;
}

std::string updated(std::string page) {
    for (const ModuleLists& lists : moduleLists()) {
        const std::string begin = "<!-- " + lists.technique + ": begin -->\n", end = "<!-- " + lists.technique + ": end -->";
        const size_t from = page.find(begin), to = page.find(end);
        if (from == std::string::npos || to == std::string::npos || to < from)
            throw host::InputError("no marks for " + lists.technique + " in the page");
        page = page.substr(0, from + begin.size()) + block(lists) + page.substr(to);
    }
    return page;
}

int run(int count, char** arguments) {
    const bool update = count == 3 && std::string(arguments[1]) == "--update";
    if (count != 2 && !update) throw host::InputError("usage: gnomon-modules [--update] FILE");
    const std::string path = arguments[count - 1];
    std::ifstream stream(path);
    if (!stream) throw host::InputError("cannot read " + path);
    const std::string page((std::istreambuf_iterator<char>(stream)), {}), wanted = updated(page);
    if (page == wanted) return 0;
    if (!update) {
        fmt::print("{} differs from the lists of passes: run gnomon-modules --update {}\n", path, path);
        return 1;
    }
    host::AtomicFile file(path);
    file.stream() << wanted;
    file.commit();
    return 0;
}

}  // namespace
}  // namespace gno::test

int main(int count, char** arguments) {
    return gno::host::guarded("gnomon-modules", "", [&] { return gno::test::run(count, arguments); });
}
