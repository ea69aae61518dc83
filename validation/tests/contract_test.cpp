// SPDX-License-Identifier: MIT
// The headers of glsl/ say what its code does; see validation/support/contract.hpp for the rules. The second half feeds the checker broken files.
#include "validation/support/contract.hpp"

#include <gtest/gtest.h>

#include "validation/support/shader_compile.hpp"

namespace gno::test {
namespace {

Library readLibrary() {
    const std::filesystem::path root = GNOMON_SOURCE_DIR "/glsl";
    Library library;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
        const std::string extension = entry.path().extension();
        if (!entry.is_regular_file() || (extension != ".glsl" && extension != ".h" && extension != ".comp" && extension != ".frag" &&
                                         extension != ".vert" && extension != ".geom"))
            continue;
        if (entry.path().parent_path().filename() == "hello") continue;  // an engine, not a module
        library[std::filesystem::relative(entry.path(), root).string()] = readText(entry.path());
    }
    return library;
}

TEST(Contract, EveryHeaderAgreesWithItsCode) {
    const Library library = readLibrary();
    EXPECT_GE(library.size(), 30u);
    for (const std::string& fault : contractFaults(library)) ADD_FAILURE() << fault;
}

/// A small library without a fault; each case below spoils one thing in it.
const Library kGood{{"core/base.h", R"glsl(// SPDX-License-Identifier: MIT
// gnomon core/base.h : types.
//
// Space      none
// Stages     any
// Requires   #version 450, no extension
#ifndef GNO_CORE_BASE_H
#define GNO_CORE_BASE_H
#ifdef __cplusplus
#include <cstddef>
int x = 1;
#endif
#define GNO_PASS_ADD 2
struct GnoBase { vec3 a; };
#endif
)glsl"},
                    {"core/part.glsl", R"glsl(// SPDX-License-Identifier: MIT
// gnomon core/part.glsl : what others share.
//
// Space      grid
// Stages     any
// Requires   #version 450, no extension
//
// Macro             required  default  meaning
// GNO_LOAD(index)   yes       -        a thing
// GNO_ROOT          no        0u       where to begin
#ifndef GNO_CORE_PART_GLSL
#define GNO_CORE_PART_GLSL
#include "base.h"
#ifndef GNO_LOAD
#error "core/part.glsl: define GNO_LOAD(index)"
#endif
#ifndef GNO_ROOT
#define GNO_ROOT 0u
#endif
         vec3 gnoPart_(uint at_){return GNO_LOAD(at_ + GNO_ROOT).a;
}
#endif
)glsl"},
                    {"core/whole.glsl", R"glsl(// SPDX-License-Identifier: MIT
// gnomon core/whole.glsl : a module.
//
//   float gnoWhole(GnoBase base, vec3 p)      sums
//
// Space      grid
// Stages     any
// Requires   #version 450, no extension
//
// Macro                      required  default  meaning
// GNO_SIZE                   no        32       entries
// GNO_EXTRA                  no        -        one more
// GNO_BUILDS                 no        GNO_PASS_ADD  what it does
// GNO_BASE(index)            yes       -        where an index leads; not where GNO_WHOSE is given
// GNO_WHOSE(index)           no        GNO_BASE(index)  the same, twice
// The macros of part.glsl    yes       -        things
#ifndef GNO_CORE_WHOLE_GLSL
#define GNO_CORE_WHOLE_GLSL
#include "part.glsl"
#if !(defined(GNO_BASE) || defined(GNO_WHOSE))
#error "core/whole.glsl: define GNO_BASE(index)"
#endif
#ifndef GNO_SIZE
#define GNO_SIZE 32
#endif
#ifndef GNO_WHOSE
#define GNO_WHOSE(index_) GNO_BASE(index_)
#endif
#ifndef GNO_BUILDS
#define GNO_BUILDS GNO_PASS_ADD
#endif
#if (GNO_BUILDS) & (1 | GNO_PASS_ADD)
float gnoWhole(GnoBase base_, vec3 p_) {
    float sum_ = p_.x, other_ = base_.a.x;
    for (uint i_ = 0u; i_ < uint(GNO_SIZE); ++i_) sum_ += gnoPart_(GNO_WHOSE(i_)).x;
#ifdef GNO_EXTRA
    sum_ += GNO_EXTRA;
#endif
    return sum_ + other_;
}
#endif
#endif
)glsl"},
                    {"core/bindings.glsl", R"glsl(// SPDX-License-Identifier: MIT
// gnomon core/bindings.glsl : our buffer.
//
//   GNO_LOAD(index)    our loader
//
// Space      grid
// Stages     any
// Requires   #version 450, no extension
//
// Macro                required  default  meaning
// GNO_SET              no        1        descriptor set
#ifndef GNO_CORE_BINDINGS_GLSL
#define GNO_CORE_BINDINGS_GLSL
#include "base.h"
#ifdef GNO_OLD_SET
#error "core/bindings.glsl: GNO_OLD_SET is called otherwise"
#endif
#ifndef GNO_SET
#define GNO_SET 1
#endif
layout(set = GNO_SET, binding = 0) buffer GnoThings { GnoBase v[]; } gnoThings;
#define GNO_LOAD(index_) gnoThings.v[index_]
#endif
)glsl"},
                    {"core/examples/run.comp", R"glsl(#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
layout(local_size_x = 1) in;
#include "../bindings.glsl"
#include "../whole.glsl"
void main() {}
)glsl"}};

TEST(Checker, FindsNothingInAGoodLibrary) {
    for (const std::string& fault : contractFaults(kGood)) ADD_FAILURE() << fault;
}

TEST(Checker, ReadsADeclarationInTwoLines) {
    Library library = kGood;
    std::string& text = library.at("core/whole.glsl");
    const std::string from = "base, vec3 p)";
    ASSERT_NE(text.find(from), std::string::npos);
    text.replace(text.find(from), from.size(), "base,\n//                  vec3 p)");
    for (const std::string& fault : contractFaults(library)) ADD_FAILURE() << fault;
}

struct Spoilt {
    const char* name;
    const char* file;
    const char* from;
    const char* to;
    const char* fault;
};
const Spoilt kSpoilt[] = {
    {"NoLicence", "core/part.glsl", "// SPDX-License-Identifier: MIT\n", "// Licence: MIT\n", "the licence line is missing"},
    {"NoLicenceInAnExample", "core/examples/run.comp", "// SPDX-License-Identifier: MIT\n", "", "the licence line is missing"},
    {"NameOfAnotherFile", "core/part.glsl", "gnomon core/part.glsl :", "gnomon core/piece.glsl :", "line two"},
    {"NoSpace", "core/whole.glsl", "// Space      grid\n", "", "no field Space"},
    {"NoStages", "core/whole.glsl", "// Stages     any\n", "", "no field Stages"},
    {"NoRequires", "core/base.h", "// Requires ", "// Needs    ", "no field Requires"},
    {"RowWithoutCode", "core/whole.glsl", "// GNO_SIZE  ", "// GNO_GHOST                  no        1        nothing\n// GNO_SIZE  ",
     "documents GNO_GHOST"},
    {"OptionThatNobodyUses", "core/whole.glsl", "uint(GNO_SIZE)", "32u", "documents GNO_SIZE"},
    {"RequiredMacroThatNobodyUses", "core/part.glsl", "GNO_LOAD(at_ + GNO_ROOT).a", "vec3(GNO_ROOT)", "documents GNO_LOAD"},
    {"CodeWithoutRow", "core/whole.glsl", "// GNO_SIZE                   no        32       entries\n", "", "reads GNO_SIZE, which has no row"},
    {"OptionalMacroWithoutRow", "core/whole.glsl", "// GNO_EXTRA                  no        -        one more\n", "",
     "reads GNO_EXTRA, which has no row"},
    {"NoConstant", "core/base.h", "#define GNO_PASS_ADD 2", "#ifndef GNO_PASS_ADD\n#define GNO_PASS_ADD 2\n#endif",
     "core/whole.glsl: reads GNO_PASS_ADD, which has no row"},
    {"NoRefusedName", "core/bindings.glsl", "#ifdef GNO_OLD_SET", "#ifndef GNO_OLD_SET", "reads GNO_OLD_SET, which has no row"},
    {"RowsNotTakenOver", "core/whole.glsl",
     "float sum_ =", "#if GNO_ROOT\n#endif\n#ifndef GNO_ROOT\n#define GNO_ROOT 1u\n#endif\nfloat sum_ =", "GNO_ROOT is 1u by default"},
    {"TakenOverFromNowhere", "core/whole.glsl", "of part.glsl ", "of parts.glsl", "which does not exist"},
    {"OtherDefault", "core/whole.glsl", "no        32 ", "no        12 ", "GNO_SIZE is 32 by default, its row says 12"},
    {"OtherDefaultOfAParameter", "core/whole.glsl", "no        GNO_BASE(index) ", "no        GNO_BASE(other) ",
     "GNO_WHOSE is GNO_BASE(index) by default"},
    {"OneOfTwoCalledOptional", "core/whole.glsl", "// GNO_BASE(index)            yes", "// GNO_BASE(index)            no ",
     "GNO_BASE is required, its row says no"},
    {"RequiredCalledOptional", "core/part.glsl", "// GNO_LOAD(index)   yes", "// GNO_LOAD(index)   no ", "GNO_LOAD is required, its row says no"},
    {"OptionalCalledRequired", "core/part.glsl", "// GNO_ROOT          no ", "// GNO_ROOT          yes",
     "GNO_ROOT has a default, its row says required yes"},
    {"UndeclaredFunction", "core/part.glsl", "gnoPart_", "gnoPart", "public function gnoPart is not in the header"},
    {"DeclaredButGone", "core/whole.glsl", "float gnoWhole(GnoBase base_", "float gnoAll_(GnoBase base_", "the header promises gnoWhole"},
    {"OtherParameterType", "core/whole.glsl", "base, vec3 p)", "base, vec4 p)", "with other types"},
    {"OtherTypeInASecondLine", "core/whole.glsl", "base, vec3 p)", "base,\n//                  vec4 p)", "with other types"},
    {"OtherReturnType", "core/whole.glsl", "//   float gnoWhole", "//   bool gnoWhole", "with other types"},
    {"ParameterName", "core/part.glsl", "(uint at_)", "(uint at)", "parameter at of gnoPart_"},
    {"LocalName", "core/whole.glsl", "float sum_ =", "float sum =", "local sum of gnoWhole"},
    {"SecondLocalName", "core/whole.glsl", "other_ =", "other =", "local other of gnoWhole"},
    {"LoopVariableName", "core/whole.glsl", "uint i_ =", "uint i =", "local i of gnoWhole"},
    {"MacroParameterName", "core/bindings.glsl", "GNO_LOAD(index_)", "GNO_LOAD(index)", "macro parameter index of GNO_LOAD"},
    {"UnnamedMacro", "core/bindings.glsl", "//   GNO_LOAD(index)    our loader\n", "", "does not name the macro GNO_LOAD"},
    {"GlobalName", "core/part.glsl", "vec3 gnoPart_", "vec3 part_", "global part_"},
    {"StructName", "core/base.h", "struct GnoBase", "struct Base", "struct Base"},
    {"MacroName", "core/part.glsl", "#include \"base.h\"", "#include \"base.h\"\n#define HALF 0.5", "defines HALF"},
    {"BindingInALibraryFile", "core/part.glsl", "vec3 gnoPart_", "layout(set = 0, binding = 1) buffer GnoX { uint v[]; } gnoX;\nvec3 gnoPart_",
     "has a layout("},
    {"Version", "core/part.glsl", "#include \"base.h\"", "#version 450\n#include \"base.h\"", "#version"},
    {"Extension", "core/part.glsl", "#include \"base.h\"", "#extension GL_EXT_shader_explicit_arithmetic_types : require\n#include \"base.h\"",
     "#extension"},
    {"SystemHeader", "core/base.h", "#ifdef __cplusplus\n#include <cstddef>", "#include <cstddef>\n#ifdef __cplusplus", "system header"},
    {"IncludeOutside", "core/part.glsl", "#include \"base.h\"", "#include \"../../host_min/frame.glsl\"", "which is not in glsl/"},
    {"ExampleIncludeOutside", "core/examples/run.comp", "../whole.glsl", "../../../whole.glsl", "which is not in glsl/"},
    {"ErrorWithoutFile", "core/part.glsl", "#error \"core/part.glsl: define", "#error \"core: define", "does not begin with the file's name"},
    {"ErrorWithoutMacro", "core/part.glsl", "define GNO_LOAD(index)\"", "define the loader\"", "names no macro"},
};

void PrintTo(const Spoilt& spoilt, std::ostream* out) { *out << spoilt.name; }

class CheckerSees : public testing::TestWithParam<Spoilt> {};

TEST_P(CheckerSees, TheFault) {
    const Spoilt& spoilt = GetParam();
    Library library = kGood;
    std::string& text = library.at(spoilt.file);
    const size_t at = text.find(spoilt.from);
    ASSERT_NE(at, std::string::npos);
    text.replace(at, std::string(spoilt.from).size(), spoilt.to);
    std::string all;
    for (const std::string& fault : contractFaults(library)) all += fault + "\n";
    EXPECT_NE(all.find(spoilt.fault), std::string::npos) << "got:\n" << all;
}

INSTANTIATE_TEST_SUITE_P(, CheckerSees, testing::ValuesIn(kSpoilt), [](const auto& spoilt) { return std::string(spoilt.param.name); });

}  // namespace
}  // namespace gno::test
