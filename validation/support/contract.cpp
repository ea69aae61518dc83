// SPDX-License-Identifier: MIT
#include "validation/support/contract.hpp"

#include <algorithm>
#include <regex>
#include <set>

#include "validation/support/glsl_source.hpp"

namespace gno::test {
namespace {

std::set<std::string> namesIn(const std::string& text, const std::string& start) {
    std::set<std::string> names;
    for (const std::string& token : tokensOf(text))
        if (startsWith(token, start)) names.insert(token);
    return names;
}

std::string guardOf(const Module& module) {
    for (const std::string& line : module.directives)
        if (startsWith(line, "#ifndef ")) return line.substr(8);
    return "";
}

/// What a #define says after the name and its parameters; these as headers write them, without their last '_'.
std::string bodyOf(const std::string& define, size_t nameEnd) {
    if (nameEnd >= define.size() || define[nameEnd] != '(') return define.substr(nameEnd);
    const size_t end = define.find(')', nameEnd);
    std::string body = define.substr(end + 1);
    for (const std::string& parameter : tokensOf(define.substr(nameEnd, end - nameEnd)))
        if (isName(parameter) && endsWith(parameter, "_"))
            body = std::regex_replace(body, std::regex("\\b" + parameter + "\\b"), parameter.substr(0, parameter.size() - 1));
    return body;
}

/// What a module's code asks of its user: macros in conditionals that the library does not define itself.
struct Asked {
    bool required = false;  ///< its absence is an #error, unless it has a default: then another macro will do
    std::string standard;   ///< default, when the code gives one
};

std::map<std::string, Asked> askedMacros(const Module& module) {
    std::map<std::string, Asked> asked;
    const std::string guard = guardOf(module);
    for (size_t i = 0; i < module.directives.size(); ++i) {
        const std::string& line = module.directives[i];
        if (!startsWith(line, "#if") && !startsWith(line, "#elif")) continue;
        const bool refused = startsWith(line, "#ifdef ") && i + 1 < module.directives.size() && startsWith(module.directives[i + 1], "#error");
        if (refused) continue;  // a name of an earlier version
        for (const std::string& name : namesIn(line, "GNO_")) {
            if (name == guard) continue;
            Asked& entry = asked[name];
            if (i + 1 == module.directives.size()) continue;
            const std::string& next = module.directives[i + 1];
            if (startsWith(next, "#error")) entry.required = true;
            if (startsWith(line, "#ifndef") && startsWith(next, "#define " + name)) entry.standard = bodyOf(next, 8 + name.size());
        }
    }
    return asked;
}

/// Macros that a header gives a number, whatever its user says: no options.
std::set<std::string> constantsOf(const Module& module) {
    static const std::regex number("^#define (GNO_[A-Z0-9_]+) [0-9]+ *$");
    std::set<std::string> names;
    for (size_t i = 1; i < module.directives.size(); ++i) {
        std::smatch match;
        if (std::regex_match(module.directives[i], match, number) && module.directives[i - 1] != "#ifndef " + match[1].str()) names.insert(match[1]);
    }
    return names;
}

/// The macro is used for something: not only tested for, given a default or complained about.
bool reads(const Module& module, const std::string& macro) {
    if (std::find(module.code.begin(), module.code.end(), macro) != module.code.end()) return true;
    for (const std::string& line : module.directives) {
        if (startsWith(line, "#if ") && line.find("defined") == std::string::npos && namesIn(line, "GNO_").contains(macro)) return true;
        if (startsWith(line, "#define ") &&
            namesIn(line.substr(8 + std::min(line.size() - 8, line.find_first_of(" (", 8) - 8)), "GNO_").contains(macro))
            return true;
    }
    return false;
}

std::string trimmed(std::string text) {
    text.erase(0, text.find_first_not_of(' '));
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
}

struct Function {
    std::string name, type;
    std::vector<std::string> parameterTypes, parameters;
};

class Checker {
public:
    explicit Checker(const Library& library) {
        for (const auto& [path, text] : library) modules_.emplace(path, parseModule(path, text));
        for (const auto& [path, text] : library) check(path, text);
    }
    std::vector<std::string> faults;

private:
    void fault(const std::string& path, const std::string& what) { faults.push_back(path + ": " + what); }

    void check(const std::string& path, const std::string& text) {
        const Module& module = modules_.at(path);
        const Lines lines = linesOf(text);
        const bool example = path.find("examples/") != std::string::npos;
        const std::string licence = "// SPDX-License-Identifier: MIT";
        const auto licenceEnd = lines.begin() + std::min<std::ptrdiff_t>(example ? 3 : 1, std::ssize(lines));
        if (std::find(lines.begin(), licenceEnd, licence) == licenceEnd) fault(path, "the licence line is missing");
        for (const std::string& include : module.includes)
            if (!modules_.contains(include)) fault(path, "includes \"" + include + "\", which is not in glsl/");
        if (example) return;

        if (module.header.size() < 2 || !startsWith(module.header[1], "gnomon " + path + " : "))
            fault(path, "line two is not \"// gnomon " + path + " : ...\"");
        for (const char* field : {"Space", "Stages", "Requires"})
            if (std::none_of(module.header.begin(), module.header.end(),
                             [&](const std::string& line) { return startsWith(line, std::string(field) + " "); }))
                fault(path, std::string("no field ") + field);
        checkDirectives(module);
        checkMacros(module);
        checkCode(module);
    }

    void checkDirectives(const Module& module) {
        for (const std::string& line : module.directives) {
            if (startsWith(line, "#version") || startsWith(line, "#extension")) fault(module.path, "has " + line + "; that is the user's");
            if (startsWith(line, "#include <")) fault(module.path, "includes a system header outside #ifdef __cplusplus");
            if (startsWith(line, "#error")) {
                if (!startsWith(line, "#error \"" + module.path + ": "))
                    fault(module.path, "an #error does not begin with the file's name: " + line);
                if (namesIn(line, "GNO_").empty()) fault(module.path, "an #error names no macro: " + line);
            }
            std::smatch match;
            if (!std::regex_search(line, match, std::regex("^#define\\s+([A-Za-z0-9_]+)(\\(([^)]*)\\))?"))) continue;
            if (!startsWith(match[1], "GNO_")) fault(module.path, "defines " + match[1].str() + ", which does not begin with GNO_");
            for (const std::string& parameter : tokensOf(match[3]))
                if (isName(parameter) && !endsWith(parameter, "_"))
                    fault(module.path, "macro parameter " + parameter + " of " + match[1].str() + " does not end in _");
            if (endsWith(module.path, ".glsl") && match[1] != guardOf(module) && !endsWith(match[1], "_") && !named(module, match[1]))
                fault(module.path, "the header does not name the macro " + match[1].str());
        }
        const bool bindings = endsWith(module.path, "bindings.glsl");
        if (!bindings && std::find(module.code.begin(), module.code.end(), "layout") != module.code.end())
            fault(module.path, "has a layout(; only *bindings.glsl may");
    }

    static bool named(const Module& module, const std::string& name) {
        return std::any_of(module.header.begin(), module.header.end(), [&](const std::string& line) { return namesIn(line, name).contains(name); });
    }

    /// This file, the files whose macros it takes over, and what those include.
    std::set<std::string> reach(const Module& module) {
        std::set<std::string> found{module.path};
        std::vector<std::string> open(module.includes);
        open.insert(open.end(), module.takenOver.begin(), module.takenOver.end());
        while (!open.empty()) {
            const std::string path = open.back();
            open.pop_back();
            if (!modules_.contains(path) || !found.insert(path).second) continue;
            const Module& next = modules_.at(path);
            open.insert(open.end(), next.includes.begin(), next.includes.end());
        }
        return found;
    }

    void checkMacros(const Module& module) {
        const std::set<std::string> around = reach(module);
        std::map<std::string, Row> rows = module.rows;
        for (const std::string& other : module.takenOver) {
            if (!modules_.contains(other)) {
                fault(module.path, "takes over the macros of " + other + ", which does not exist");
                continue;
            }
            rows.insert(modules_.at(other).rows.begin(), modules_.at(other).rows.end());
        }
        std::set<std::string> readers = around;
        const std::string folder = module.path.substr(0, module.path.find('/') + 1);
        for (const auto& [path, other] : modules_)  // bindings define what the modules beside them read
            if (other.takenOver.contains(module.path) || (endsWith(module.path, "bindings.glsl") && startsWith(path, folder))) readers.insert(path);
        for (const auto& [macro, row] : module.rows) {
            if (std::none_of(readers.begin(), readers.end(), [&, name = macro](const std::string& path) { return reads(modules_.at(path), name); }))
                fault(module.path, "documents " + macro + ", which no code reads");
        }
        std::set<std::string> ours;  // macros that the included files document themselves
        std::set<std::string> constants;
        for (const std::string& path : around) {
            if (path == module.path) continue;
            for (const auto& [macro, row] : modules_.at(path).rows) ours.insert(macro);
            constants.merge(constantsOf(modules_.at(path)));
        }
        for (const auto& [macro, entry] : askedMacros(module)) {
            if (endsWith(macro, "_") || constants.contains(macro)) continue;
            const auto row = rows.find(macro);
            if (row == rows.end()) {
                if (!ours.contains(macro) || !entry.standard.empty() || entry.required) fault(module.path, "reads " + macro + ", which has no row");
                continue;
            }
            if (entry.required && entry.standard.empty() && row->second.required != "yes")
                fault(module.path, macro + " is required, its row says " + row->second.required);
            if (!entry.standard.empty()) {
                const std::string standard = trimmed(entry.standard);
                if (row->second.required != "no") fault(module.path, macro + " has a default, its row says required " + row->second.required);
                if (row->second.standard != standard)
                    fault(module.path, macro + " is " + standard + " by default, its row says " + row->second.standard);
            }
        }
    }

    void checkCode(const Module& module);
    void checkBody(const Module& module, const std::string& function, size_t first, size_t last);

    std::map<std::string, Module> modules_;
};

/// Parameter types and names between two parentheses.
void readParameters(const Tokens& code, size_t open, size_t close, Function& function) {
    std::string last, before;
    const auto finish = [&] {
        if (before.empty()) return;
        function.parameterTypes.push_back(before);
        function.parameters.push_back(last);
    };
    for (size_t i = open + 1; i < close; ++i) {
        if (code[i] == ",") {
            finish();
            last = before = "";
        } else if (isName(code[i])) {
            before = last;
            last = code[i];
        }
    }
    finish();
}

void Checker::checkCode(const Module& module) {
    const Tokens& code = module.code;
    std::map<std::string, std::vector<Function>> defined;
    for (size_t i = 0; i < code.size(); ++i) {
        if (code[i] == "struct" && i + 2 < code.size()) {
            if (!startsWith(code[i + 1], "Gno")) fault(module.path, "struct " + code[i + 1] + " does not begin with Gno");
            while (i < code.size() && code[i] != "{") ++i;
            i = closing(code, i);
            continue;
        }
        if (code[i] == "layout") {
            while (i < code.size() && code[i] != ";" && code[i] != "{") ++i;
            if (i < code.size() && code[i] == "{") i = closing(code, i);
            continue;
        }
        if (!isType(code[i]) || i + 2 >= code.size() || !isName(code[i + 1])) continue;
        const std::string name = code[i + 1];
        if (!startsWith(name, "gno") && !startsWith(name, "GNO_")) fault(module.path, "global " + name + " does not begin with gno or GNO_");
        if (code[i + 2] != "(") continue;
        Function function{name, code[i], {}, {}};
        const size_t close = closing(code, i + 2);
        readParameters(code, i + 2, close, function);
        for (const std::string& parameter : function.parameters)
            if (!endsWith(parameter, "_")) fault(module.path, "parameter " + parameter + " of " + name + " does not end in _");
        defined[name].push_back(function);
        i = close;
        if (i + 1 < code.size() && code[i + 1] == "{") {
            const size_t end = closing(code, i + 1);
            checkBody(module, name, i + 1, end);
            i = end;
        }
    }

    std::set<std::string> declared;
    static const std::regex declaration("^ *([A-Za-z0-9_]+) +(gno[A-Za-z0-9_]+)\\(([^)]*)\\)");
    for (size_t i = 0; i < module.header.size(); ++i) {
        std::string line = module.header[i];
        if (!startsWith(line, "  ")) continue;
        while (line.find("(") != std::string::npos && line.find(")") == std::string::npos && i + 1 < module.header.size())
            line += " " + trimmed(module.header[++i]);  // a long declaration goes on in the next line
        std::smatch match;
        if (!std::regex_search(line, match, declaration)) continue;
        const std::string name = match[2];
        declared.insert(name);
        const auto found = defined.find(name);
        if (found == defined.end()) {
            fault(module.path, "the header promises " + name + ", which does not exist");
            continue;
        }
        Function wanted{name, match[1], {}, {}};
        Tokens parameters = tokensOf("(" + match[3].str() + ")");
        readParameters(parameters, 0, parameters.size() - 1, wanted);
        const bool open = match[3] == "...";
        if (std::none_of(found->second.begin(), found->second.end(),
                         [&](const Function& f) { return f.type == wanted.type && (open || f.parameterTypes == wanted.parameterTypes); }))
            fault(module.path, "the header declares " + name + " with other types than the code");
    }
    for (const auto& [name, functions] : defined)
        if (startsWith(name, "gno") && !endsWith(name, "_") && !declared.contains(name))
            fault(module.path, "public function " + name + " is not in the header");
}

void Checker::checkBody(const Module& module, const std::string& function, size_t first, size_t last) {
    const Tokens& code = module.code;
    for (size_t i = first; i < last; ++i) {
        if (!isType(code[i]) || !isName(code[i + 1])) continue;
        int depth = 0;
        bool expectName = true;
        for (++i; i < last; ++i) {  // declarators up to the end of the statement
            if (expectName && isName(code[i])) {
                if (!endsWith(code[i], "_")) fault(module.path, "local " + code[i] + " of " + function + " does not end in _");
                expectName = false;
                continue;
            }
            if (code[i] == "(" || code[i] == "[") ++depth;
            if (code[i] == ")" || code[i] == "]") --depth;
            if (code[i] == ";" || code[i] == "{" || depth < 0) break;
            if (code[i] == "," && depth == 0) expectName = true;
        }
    }
}

}  // namespace

std::vector<std::string> contractFaults(const Library& library) { return Checker(library).faults; }

}  // namespace gno::test
