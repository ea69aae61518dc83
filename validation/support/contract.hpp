// SPDX-License-Identifier: MIT
// Holds the header of every file of glsl/ against its code: a header that drifts from the code is worse than none.
#pragma once
#include <map>
#include <string>
#include <vector>

namespace gno::test {

/// Path inside glsl/ ("top/build.glsl") to text.
using Library = std::map<std::string, std::string>;

/// One line per fault, "FILE: what is wrong"; empty when all headers and code agree.
///
/// Library files (*.glsl and *.h outside examples/):
///  - line one is the licence, line two "gnomon FILE : ..."; the fields Space, Stages and Requires are there;
///  - every macro in a `Macro` row is read by the code of this file, of what it includes, or of a file that takes the row over ("The macros of
///    visit.glsl"); every macro that the code reads from its user has a row, with the same default or "yes" when its absence is an #error;
///  - public functions stand in the header with their types, and what stands in the header exists;
///  - parameters, locals and macro parameters end in '_'; global names begin with gno, Gno or GNO_;
///  - `layout(` only in bindings.glsl; no #version, no #extension; an #error begins with the file's name and names a macro.
/// All files: the licence in the first three lines; includes stay inside glsl/.
std::vector<std::string> contractFaults(const Library& library);

}  // namespace gno::test
