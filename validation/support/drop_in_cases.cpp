// SPDX-License-Identifier: MIT
#include "validation/support/drop_in_cases.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace gno::test {
namespace {

const std::string kMount = "gnomon/";

/// Where `word` stands and no longer name begins with it.
size_t findWord(const std::string& text, const std::string& word) {
    for (size_t from = text.find(word); from != std::string::npos; from = text.find(word, from + 1)) {
        const size_t behind = from + word.size();
        if (behind == text.size() || !(std::isalnum(static_cast<unsigned char>(text[behind])) || text[behind] == '_')) return from;
    }
    return std::string::npos;
}

/// "gnomon/top/build.glsl" of `#include "gnomon/top/build.glsl"`; empty for another line.
std::string includedBy(const std::string& line) {
    if (line.rfind("#include \"", 0) != 0) return {};
    const size_t from = line.find('"') + 1;
    return line.substr(from, line.find('"', from) - from);
}

/// Path inside the library of what a file includes; `path` of that file, empty for a shader outside.
std::string libraryPath(const std::string& included, const std::string& path) {
    if (path.empty()) return included.rfind(kMount, 0) == 0 ? included.substr(kMount.size()) : std::string();
    return (std::filesystem::path(path).parent_path() / included).lexically_normal().string();
}

void collectRequired(const Texts& library, const std::string& text, const std::string& path, std::set<std::string>& visited,
                     std::map<std::string, std::string>& required) {
    static const std::regex absent("(?:!\\s*\\(?\\s*defined\\s*\\(?\\s*|#ifndef\\s+|#if !?\\(+(?=GNO_[A-Z_]+_BUILDS\\)))(GNO_[A-Z0-9_]+)");
    std::istringstream lines(text);
    std::string condition;  // from the last #if on: what an #error stands under
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("#if", 0) == 0) condition.clear();
        if (line.rfind("#error", 0) == 0) {
            for (std::sregex_iterator i(condition.begin(), condition.end(), absent), end; i != end; ++i)
                if (findWord(line, (*i)[1]) != std::string::npos) required.emplace((*i)[1], path);
        }
        condition += line + "\n";
        const std::string included = includedBy(line);
        if (included.empty()) continue;
        const std::string file = libraryPath(included, path);
        const auto found = library.find(file);
        if (found != library.end() && visited.insert(file).second) collectRequired(library, found->second, file, visited, required);
    }
}

size_t replaceAll(std::string& text, const std::regex& from, const std::string& to) {
    const size_t found = size_t(std::distance(std::sregex_iterator(text.begin(), text.end(), from), std::sregex_iterator()));
    text = std::regex_replace(text, from, to);
    return found;
}

/// Where `#define MACRO...` begins and how long it is, lines that it continues on included; length 0: nowhere.
std::pair<size_t, size_t> definitionOf(const std::string& shader, std::string_view macro) {
    const size_t from = findWord(shader, "#define " + std::string(macro));
    if (from == std::string::npos) return {0, 0};
    size_t to = shader.find('\n', from);
    while (to != std::string::npos && shader[to - 1] == '\\') to = shader.find('\n', to + 1);
    return {from, std::min(to, shader.size()) - from};
}

bool isCompute(const std::string& module) {
    static const std::regex stages("\n// Stages +compute\\b");
    return std::regex_search(module, stages);
}

}  // namespace

bool hasFragmentTwin(const Texts& library, const std::string& compute) {
    if (compute.find(" writeonly buffer Results {") == std::string::npos) return false;
    std::istringstream lines(compute);
    for (std::string line; std::getline(lines, line);) {
        const std::string included = includedBy(line);
        for (const auto& [path, text] : library)  // under whatever name the folder is mounted
            if (included.size() > path.size() && included.ends_with("/" + path) && isCompute(text)) return false;
    }
    return true;
}

std::string fragmentTwin(std::string compute) {
    static const std::regex size("layout\\(local_size_x = [0-9]+\\) in;\n"), invocation("\\bgl_GlobalInvocationID\\.x\\b");
    static const std::regex results("layout\\([^)]*\\) writeonly buffer Results \\{ (\\w+) v\\[\\]; \\} results;\n");
    static const std::regex local("    (?:vec4|uint|float) result;\n"), storeLocal(" +results\\.v\\[[^\\]]*\\] = result;\n"),
        store("\\bresults\\.v\\[[^\\]]*\\] = ");
    const auto need = [](size_t found, const char* what) {
        if (found != 1) throw std::invalid_argument(std::string("no fragment twin without exactly one line ") + what);
    };
    need(replaceAll(compute, size, ""), "layout(local_size_x = ...) in;");
    need(replaceAll(compute, results, "layout(location = 0) out $1 result;\n"), "... writeonly buffer Results { T v[]; } results;");
    if (replaceAll(compute, local, "") > 0)
        need(replaceAll(compute, storeLocal, ""), "results.v[...] = result;");
    else
        need(replaceAll(compute, store, "result = "), "results.v[...] = ...;");
    replaceAll(compute, invocation, "uint(gl_FragCoord.x)");
    return compute;
}

std::string withoutMacro(std::string shader, std::string_view macro) {
    const auto [from, length] = definitionOf(shader, macro);
    if (length == 0) throw std::invalid_argument(std::string(macro) + " is never defined");
    return shader.erase(from, length);
}

std::map<std::string, std::string> requiredBy(const Texts& library, const std::string& text, const std::string& path) {
    std::set<std::string> visited;
    std::map<std::string, std::string> required;
    collectRequired(library, text, path, visited, required);
    return required;
}

std::vector<DropIn> mustCompile(const Texts& library, const Texts& shaders) {
    std::vector<DropIn> cases;
    for (const auto& [name, text] : shaders) {
        cases.push_back({name, text});
        if (!hasFragmentTwin(library, text)) continue;
        try {
            cases.push_back({name.substr(0, name.rfind('.')) + ".frag", fragmentTwin(text)});
        } catch (const std::invalid_argument& error) {
            throw std::invalid_argument(name + ": " + error.what());
        }
    }
    return cases;
}

std::vector<MustFail> mustFail(const Texts& library, const Texts& shaders) {
    std::vector<MustFail> cases;
    for (const auto& [path, module] : library) {
        const std::string stem = moduleStem(path);
        std::vector<const std::string*> skeletons;
        for (const auto& [name, text] : shaders) {
            if (moduleStem(name) != stem) continue;
            skeletons.insert(name.find(".own_storage.") == std::string::npos ? skeletons.end() : skeletons.begin(), &text);
        }
        for (const auto& [macro, unused] : requiredBy(library, module, path)) {
            const auto skeleton = std::find_if(skeletons.begin(), skeletons.end(),
                                               [&of = macro](const std::string* text) { return definitionOf(*text, of).second > 0; });
            if (skeleton == skeletons.end()) continue;
            std::string suffix = macro.substr(std::string("GNO_").size());
            std::transform(suffix.begin(), suffix.end(), suffix.begin(), [](unsigned char c) { return char(std::tolower(c)); });
            // The shader may include another file before this one that asks for the same.
            cases.push_back(
                {stem + ".missing_" + suffix + ".comp", withoutMacro(**skeleton, macro), requiredBy(library, **skeleton).at(macro), macro});
        }
    }
    return cases;
}

std::string moduleStem(const std::string& file) {
    std::string stem = file.substr(0, file.find('.'));
    std::replace(stem.begin(), stem.end(), '/', '_');
    return stem;
}

}  // namespace gno::test
