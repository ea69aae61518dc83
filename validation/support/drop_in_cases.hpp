// SPDX-License-Identifier: MIT
// The shaders of validation/drop_in, and what is made of them: the same shader for the fragment stage, and copies that must not compile because one
// macro is no longer defined.
#pragma once
#include <map>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace gno::test {

/// File name ("top_build.comp", or inside glsl/ "top/build.glsl") to text.
using Texts = std::map<std::string, std::string>;

struct DropIn {
    std::string name;  ///< "top_build.frag"
    std::string text;
    friend void PrintTo(const DropIn& one, std::ostream* stream) { *stream << one.name; }  // for gtest
};

struct MustFail {
    std::string name;         ///< "top_build.missing_light.comp"
    std::string text;         ///< the skeleton without that macro's #define
    std::string file, macro;  ///< the #error that has to stop it: "top/build.glsl", "GNO_LIGHT"
    friend void PrintTo(const MustFail& one, std::ostream* stream) { *stream << one.name; }
};

/// Whether the fragment stage may run it: every module that it includes says so (header field Stages), and it is written for both stages, that is,
/// it stores into `Results`.
bool hasFragmentTwin(const Texts& library, const std::string& compute);

/// The same body for the fragment stage. Throws std::invalid_argument where one of the lines that differ between the stages is not there:
///   layout(local_size_x = 64) in;                                                        left out
///   layout(set = 3, binding = 0, std430) writeonly buffer Results { T v[]; } results;    layout(location = 0) out T result;
///   gl_GlobalInvocationID.x                                                              uint(gl_FragCoord.x)
///   vec4 result; ... results.v[at] = result;                                             both left out; where there is no such local,
///   results.v[at] = ...;                                                                 result = ...;
std::string fragmentTwin(std::string compute);

/// `shader` without the definition of `macro`; throws std::invalid_argument when it has none.
std::string withoutMacro(std::string shader, std::string_view macro);

/// Macros whose absence is an #error (with our bindings also GNO_..._BUILDS, which says what a shader may write), with the file of the first such
/// #error in the order of a compiler: of `text` and of what it includes as "gnomon/..." or, where `text` is the library's own file `path`, relative
/// to that.
std::map<std::string, std::string> requiredBy(const Texts& library, const std::string& text, const std::string& path = "");

/// The shaders that must compile: every file, and the fragment twin of each that has one.
std::vector<DropIn> mustCompile(const Texts& library, const Texts& shaders);

/// One broken copy per module and required macro: of NAME.own_storage.comp where that defines the macro, else of another shader of that module.
std::vector<MustFail> mustFail(const Texts& library, const Texts& shaders);

/// What must fail although no macro is missing: names of earlier versions, a forgotten switch, bindings that are included twice. Throws
/// std::invalid_argument for a file *bindings.glsl that may be.
std::vector<MustFail> refused(const Texts& library);

/// "core_sample" for "core/sample.glsl", and for "core_sample.own_storage.comp".
std::string moduleStem(const std::string& file);

}  // namespace gno::test
