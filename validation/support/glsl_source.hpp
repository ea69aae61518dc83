// SPDX-License-Identifier: MIT
// A file of glsl/ taken apart as far as contract.cpp needs it: header, directives, tokens. No preprocessor is run; what is for C++ only is left out.
#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

namespace gno::test {

using Lines = std::vector<std::string>;
using Tokens = std::vector<std::string>;

struct Row {
    std::string required, standard;  ///< columns "required" and "default"
};

struct Module {
    std::string path;
    Lines header;                       ///< without "// "
    Lines directives;                   ///< "#..." lines of the code, joined where they end in a backslash, without comments
    Tokens code;                        ///< everything else; what is for C++ only is left out
    std::map<std::string, Row> rows;    ///< `Macro` rows
    std::set<std::string> takenOver;    ///< "The macros of visit.glsl": "top/visit.glsl"
    std::vector<std::string> includes;  ///< resolved
};

Module parseModule(const std::string& path, const std::string& text);

Lines linesOf(const std::string& text);
Tokens tokensOf(const std::string& code);
bool isName(const std::string& token);
bool isType(const std::string& token);  ///< of GLSL, or of ours (Gno...)
/// Index of the bracket that closes the one at `open`.
size_t closing(const Tokens& code, size_t open);

bool startsWith(const std::string& text, const std::string& start);
bool endsWith(const std::string& text, const std::string& end);

}  // namespace gno::test
