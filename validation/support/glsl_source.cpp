// SPDX-License-Identifier: MIT
#include "validation/support/glsl_source.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>
#include <sstream>

namespace gno::test {

Lines linesOf(const std::string& text) {
    Lines lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

bool startsWith(const std::string& text, const std::string& start) { return text.rfind(start, 0) == 0; }
bool endsWith(const std::string& text, const std::string& end) {
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

static std::string withoutComments(const std::string& text) {
    std::string code;
    for (size_t i = 0; i < text.size(); ++i) {
        if (text.compare(i, 2, "//") == 0) {
            i = std::min(text.find('\n', i), text.size()) - 1;
        } else if (text.compare(i, 2, "/*") == 0) {
            i = std::min(text.find("*/", i + 2), text.size() - 2) + 1;
            code += ' ';
        } else {
            code += text[i];
        }
    }
    return code;
}

Tokens tokensOf(const std::string& code) {
    static const std::regex token("[A-Za-z_][A-Za-z0-9_]*|[0-9][A-Za-z0-9_.]*|\\.\\.\\.|[^\\sA-Za-z0-9_]");
    return {std::sregex_token_iterator(code.begin(), code.end(), token), std::sregex_token_iterator()};
}

bool isName(const std::string& token) { return std::isalpha(static_cast<unsigned char>(token[0])) || token[0] == '_'; }

static std::string resolve(const std::string& from, const std::string& include) {
    return (std::filesystem::path(from).parent_path() / include).lexically_normal().string();
}

static void readRows(Module& module) {
    bool inside = false;
    for (const std::string& line : module.header) {
        static const std::regex parameters("^( *GNO_[A-Z0-9_]+)\\([^)]*\\)");
        std::istringstream words(std::regex_replace(line, parameters, "$1"));
        std::string first, second, third, fourth;
        words >> first >> second >> third >> fourth;
        if (first == "Macro" && second == "required" && third == "default") {
            inside = true;
        } else if (inside && first == "The" && second == "macros" && third == "of") {
            module.takenOver.insert(resolve(module.path, fourth));
        } else if (inside && startsWith(first, "GNO_")) {
            module.rows[first] = {second, third};
        } else if (inside && !startsWith(line, "  ")) {
            inside = false;  // rows may be continued by indented lines
        }
    }
}

Module parseModule(const std::string& path, const std::string& text) {
    Module module;
    module.path = path;
    size_t at = 0;
    const Lines lines = linesOf(text);
    for (; at < lines.size() && startsWith(lines[at], "//"); ++at) module.header.push_back(lines[at].size() > 3 ? lines[at].substr(3) : "");
    readRows(module);

    std::string code;
    int cppOnly = 0;  // depth of conditionals inside the C++ branch of #ifdef __cplusplus
    Lines all = linesOf(withoutComments(text));
    for (size_t i = 0; i < all.size(); ++i) {
        std::string line = all[i];
        if (!startsWith(line, "#")) {
            if (cppOnly == 0) code += line + "\n";
            continue;
        }
        while (endsWith(line, "\\") && i + 1 < all.size()) line = line.substr(0, line.size() - 1) + all[++i];
        if (cppOnly > 0) {
            if (startsWith(line, "#if")) ++cppOnly;
            if (startsWith(line, "#endif")) --cppOnly;
            if (cppOnly == 1 && startsWith(line, "#else")) cppOnly = 0;
            continue;
        }
        if (startsWith(line, "#ifdef __cplusplus")) cppOnly = 1;
        module.directives.push_back(line);
    }
    static const std::regex output("GNO_(IN)?OUT\\(([A-Za-z0-9_]+)\\)");
    module.code = tokensOf(std::regex_replace(code, output, "$2"));
    for (const std::string& line : module.directives) {
        std::smatch match;
        if (std::regex_match(line, match, std::regex("#\\s*include\\s+\"(.*)\"\\s*"))) module.includes.push_back(resolve(path, match[1]));
    }
    return module;
}

bool isType(const std::string& token) {
    static const std::regex type("void|bool|int|uint|float|double|[iub]?vec[234]|mat[234](x[234])?|Gno[A-Z][A-Za-z0-9]*_?");
    return std::regex_match(token, type);
}

size_t closing(const Tokens& code, size_t open) {
    int depth = 0;
    for (size_t i = open; i < code.size(); ++i) {
        if (code[i] == "(" || code[i] == "{" || code[i] == "[") ++depth;
        if (code[i] == ")" || code[i] == "}" || code[i] == "]") --depth;
        if (depth == 0) return i;
    }
    return code.size() - 1;
}

}  // namespace gno::test
