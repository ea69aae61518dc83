// SPDX-License-Identifier: MIT
// What the examples ask of a pipeline, read from their SPIR-V: the buffers they may write, and their specialization constants.
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <spirv_cross/spirv_cross.hpp>

#include "glsl/core/constant_ids.h"
#include "glsl/top/node.h"
#include "host_min/vulkan/shader.hpp"
#include "validation/support/shader_compile.hpp"
#include "validation/support/shader_rights.hpp"

namespace gno::test {
namespace {

using Names = std::set<std::string>;

std::string join(const Names& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : " ") + name;
    return text;
}

TEST(Rights, EveryExampleMayWriteWhatItsPassesWriteAndNothingElse) {
    size_t writing = 0, fragments = 0;
    for (const std::string& shader : host::embeddedShaderNames()) {
        const auto spirv = host::embeddedShader(shader);
        const Names may = writable(spirv);
        EXPECT_EQ(join(may), join(writtenBy(shader))) << shader;
        EXPECT_EQ(join(may), join(stored(spirv))) << shader << " has a right that it does not use";
        if (host::reflect(spirv).stage != vk::ShaderStageFlagBits::eCompute) {
            ++fragments;
            EXPECT_TRUE(may.empty()) << shader << " needs fragmentStoresAndAtomics or vertexPipelineStoresAndAtomics";
        }
        writing += may.empty() ? 0 : 1;
    }
    EXPECT_GE(writing, 100u);
    EXPECT_GE(fragments, 20u);
}

/// The walk sees what is wrong with each of these: compiled as for Vulkan 1.0 (BufferBlock) and 1.2 (StorageBuffer).
TEST(Rights, TheWalkSeesAWritableBuffer) {
    const Mount mount(GNOMON_SOURCE_DIR "/glsl");
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / ("gnomon-rights-" + std::to_string(getpid()) + ".frag");
    const auto compiled = [&](const std::string& text, const char* environment) {
        std::ofstream(file) << "#version 450\n#extension GL_GOOGLE_include_directive : require\nlayout(location = 0) out vec4 color;\n" << text;
        Mount::Compiled result = mount.compile(file, environment, false);
        EXPECT_TRUE(result.good) << result.output;
        return result.spirv;
    };
    struct Case {
        std::string text, may, does;
    };
    const std::string read = "void main() { color = vec4(b.v[0]); }\n";
    const std::vector<Case> cases{
        {"layout(set = 0, binding = 0) readonly buffer B { float v[]; } b;\n" + read, "", ""},
        {"layout(set = 0, binding = 0) buffer B { float v[]; } b;\n" + read, "b", ""},
        {"layout(set = 0, binding = 0) coherent buffer B { float v[]; } b;\n" + read, "b", ""},
        {"layout(set = 0, binding = 0) buffer B { readonly float first; float v[]; } b;\n" + read, "b", ""},
        {"layout(set = 0, binding = 0) buffer B { readonly float first; readonly float v[]; } b;\n" + read, "", ""},
        {"layout(set = 0, binding = 0) buffer B { float v[]; } b;\nvoid main() { b.v[1] = 0.0; color = vec4(0.0); }\n", "b", "b"},
        {"layout(set = 0, binding = 0) buffer B { uint v[]; } b;\nvoid main() { atomicAdd(b.v[1], 1u); color = vec4(0.0); }\n", "b", "b"},
        {"layout(set = 0, binding = 0) buffer B { float v[]; } b[2];\n"
         "void main() { b[1].v[1] = 0.0; color = vec4(0.0); }\n",
         "b", "b"},
        {"layout(set = 0, binding = 0) uniform B { float v[4]; } b;\n" + read, "", ""},
        {"layout(set = 0, binding = 0, r32ui) uniform uimage2D b;\nvoid main() { color = vec4(imageLoad(b, ivec2(0))); }\n", "b", ""},
        {"layout(set = 0, binding = 0, r32ui) uniform readonly uimage2D b;\nvoid main() { color = vec4(imageLoad(b, ivec2(0))); }\n", "", ""},
        {"layout(set = 0, binding = 0, r32ui) uniform uimage2D b;\nvoid main() { imageAtomicAdd(b, ivec2(0), 1u); color = vec4(0.0); }\n", "b", "b"},
        {"layout(set = 0, binding = 0, r32ui) uniform writeonly uimage2D b;\nvoid main() { imageStore(b, ivec2(0), uvec4(1u)); color = vec4(0.0); "
         "}\n",
         "b", "b"},
        {"layout(set = 0, binding = 0) uniform sampler2D b;\nvoid main() { color = texelFetch(b, ivec2(0), 0); }\n", "", ""},
        // without a macro our buffers are readonly, with one they are not
        {"#include \"gnomon/top/bindings.glsl\"\nvoid main() { color = vec4(GNO_TOP_ROOT); }\n", "", ""},
        {"#define GNO_TOP_BUILDS 1\n#include \"gnomon/top/bindings.glsl\"\nvoid main() { color = vec4(GNO_TOP_ROOT); }\n",
         "gnoTopHeader gnoTopLinks gnoTopPlanes", ""},
    };
    for (const char* environment : {"vulkan1.0", "vulkan1.2"}) {
        for (const Case& wanted : cases) {
            SCOPED_TRACE(std::string(environment) + "\n" + wanted.text);
            const std::vector<uint32_t> spirv = compiled(wanted.text, environment);
            EXPECT_EQ(join(writable(spirv)), wanted.may);
            EXPECT_EQ(join(stored(spirv)), wanted.does);
        }
    }
    std::filesystem::remove(file);
    EXPECT_THROW((void)writable(std::vector<uint32_t>{1, 2, 3, 4, 5}), std::runtime_error);
}

/// The table of core/constant_ids.h: number to name, as its comment has it.
std::map<uint32_t, std::string> constantTable(const std::string& header) {
    std::map<std::string, std::string> names;
    const std::regex row("// +(GNO_ID_[A-Z_]+) +(k[A-Za-z]+) "), number("#define (GNO_ID_[A-Z_]+) ([0-9]+)\n");
    for (std::sregex_iterator i(header.begin(), header.end(), row), end; i != end; ++i) names[(*i)[1]] = (*i)[2].str();
    std::map<uint32_t, std::string> table;
    for (std::sregex_iterator i(header.begin(), header.end(), number), end; i != end; ++i) {
        if (!names.contains((*i)[1])) throw std::runtime_error((*i)[1].str() + " has no row");
        if (!table.emplace(uint32_t(std::stoul((*i)[2])), names.at((*i)[1])).second) throw std::runtime_error((*i)[2].str() + " stands there twice");
        names.erase((*i)[1]);
    }
    if (!names.empty()) throw std::runtime_error(names.begin()->first + " has no number");
    return table;
}

/// One line per constant that the table does not know under its name, and per row that no shader has.
std::vector<std::string> constantFaults(const std::map<uint32_t, std::string>& table) {
    std::vector<std::string> faults;
    std::set<uint32_t> used;
    for (const std::string& shader : host::embeddedShaderNames()) {
        for (const auto& [id, name] : host::reflect(host::embeddedShader(shader)).specialization) {
            used.insert(id);
            const auto row = table.find(id);
            if (row == table.end() || row->second != name) faults.push_back(shader + ": constant " + std::to_string(id) + " is called " + name);
        }
    }
    for (const auto& [id, name] : table)
        if (!used.contains(id)) faults.push_back("no shader has constant " + std::to_string(id) + ", " + name);
    return faults;
}

TEST(Constants, EachNumberHasOneNameInAllShaders) {
    std::map<uint32_t, std::string> table = constantTable(readText(GNOMON_SOURCE_DIR "/glsl/core/constant_ids.h"));
    EXPECT_EQ(table.size(), 15u);
    EXPECT_EQ(table.at(GNO_ID_PRECISION), "kPrecision");
    EXPECT_EQ(table.at(GNO_ID_GROUP_SIZE), "kGroupSize");
    for (const std::string& fault : constantFaults(table)) ADD_FAILURE() << fault;

    // It sees another name, a number that is missing, and a row too many.
    auto renamed = table, short_ = table, longer = table;
    renamed[GNO_ID_STEP] = "kStage";
    short_.erase(GNO_ID_FORM);
    longer[99] = "kNothing";
    for (const auto& wrong : {renamed, short_, longer}) EXPECT_FALSE(constantFaults(wrong).empty());
    EXPECT_THROW((void)constantTable("//   GNO_ID_A  kA  all\n"), std::runtime_error);
    EXPECT_THROW((void)constantTable("#define GNO_ID_A 1\n"), std::runtime_error);
}

/// Who forgets constant 10 gets whole work groups, not one invocation in each.
TEST(Constants, TheWorkGroupSizeHasADefault) {
    size_t found = 0;
    for (const std::string& shader : host::embeddedShaderNames()) {
        const auto spirv = host::embeddedShader(shader);
        const spirv_cross::Compiler compiler(spirv.data(), spirv.size());
        for (const spirv_cross::SpecializationConstant& constant : compiler.get_specialization_constants()) {
            if (constant.constant_id != GNO_ID_GROUP_SIZE) continue;
            ++found;
            EXPECT_EQ(compiler.get_constant(constant.id).scalar(), kTopGroupSize) << shader;
        }
    }
    EXPECT_EQ(found, 6u);  // set-up and build of a TOP tree, tiles of clusters, each twice
}

}  // namespace
}  // namespace gno::test
