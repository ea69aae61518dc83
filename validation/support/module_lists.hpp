// SPDX-License-Identifier: MIT
// Every technique that glsl/ has a list of passes for, as an engine would ask for it with its defaults: what the tests of lists, barriers and
// copies, and glsl/MODULES.md go through.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "glsl/core/pass.hpp"

namespace gno::test {

/// The frame of the examples in MODULES.md.
inline constexpr uint32_t kListCasters = 100000, kListWidth = 1024, kListHeight = 1024;

struct ModuleLists {
    std::string technique;  ///< of the registry: "d-hybrid"
    std::string header;     ///< "top/passes.hpp"
    ArrayList arrays;       ///< its own, without core/passes.hpp's
    PassList build, query;
    std::vector<std::string> includes;  ///< what the user's shader includes to ask, in this order
    std::vector<std::string> defines;   ///< lines before the includes, besides GNO_LIGHT
    std::string question;               ///< a call that is true in shadow; the sample is called s
    std::string asks{};                 ///< another technique's structure: the page tells buffers and build there
};

/// In the order of MODULES.md.
std::vector<ModuleLists> moduleLists();

/// What to copy for it: all files of glsl/ that its lists, its compiled examples and the user's shader need, sorted, with LICENSE. Throws
/// std::runtime_error when an include leads nowhere.
std::vector<std::string> filesToCopy(const ModuleLists& lists, const std::filesystem::path& glsl);

}  // namespace gno::test
