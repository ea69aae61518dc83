// SPDX-License-Identifier: MIT
// Shaders that must not compile although no macro is missing: what they define, or the order of their includes, would be a silent mistake.
#include <regex>
#include <stdexcept>

#include "validation/support/drop_in_cases.hpp"

namespace gno::test {
namespace {

struct Refusal {
    const char* name;
    const char* body;
    const char* file;
    const char* macro;
};

#define BOUND "#include \"gnomon/core/bindings.glsl\"\n"
#define LIGHT "layout(push_constant) uniform Push { vec4 light; } push;\n#define GNO_LIGHT push.light\n" BOUND
#define FOREST "#include \"gnomon/forest/bindings.glsl\"\n"
#define TOP "#include \"gnomon/top/bindings.glsl\"\n"

constexpr Refusal kRefusals[] = {
    // Names of earlier versions.
    {"top_bindings.read_only", "#define GNO_TOP_READ_ONLY 1\n" TOP, "top/bindings.glsl", "GNO_TOP_READ_ONLY"},
    {"rivals_light_grid_bindings.read_only", "#define GNO_LIGHT_GRID_READ_ONLY 1\n#include \"gnomon/rivals/light_grid_bindings.glsl\"\n",
     "rivals/light_grid_bindings.glsl", "GNO_LIGHT_GRID_READ_ONLY"},
    {"rivals_light_bvh_bindings.build", "#define GNO_LIGHT_BVH_BUILD 1\n#include \"gnomon/rivals/light_bvh_bindings.glsl\"\n",
     "rivals/light_bvh_bindings.glsl", "GNO_LIGHT_BVH_BUILD"},
    // A forest is bound, and nobody says whether its trees or one tree are meant.
    {"top_visit.forest_undecided", LIGHT FOREST TOP "#include \"gnomon/top/query_hybrid.glsl\"\n", "top/visit.glsl", "GNO_FOREST_TREES"},
    {"top_build.forest_undecided", LIGHT FOREST "#define GNO_TOP_BUILDS 1\n" TOP "#include \"gnomon/top/build.glsl\"\n", "top/build.glsl",
     "GNO_FOREST_TREES"},
    {"top_visit.forest_decided_too_late", LIGHT FOREST TOP "#define GNO_FOREST_TREES 1\n#include \"gnomon/top/query_stack.glsl\"\n",
     "top/visit.glsl", "GNO_FOREST_TREES"},
    {"forest_bindings.behind_the_query", LIGHT TOP "#include \"gnomon/top/query_hybrid.glsl\"\n#define GNO_FOREST_TREES 1\n" FOREST,
     "forest/bindings.glsl", "GNO_FOREST_TREES"},
    {"top_build.forest_readonly",
     LIGHT "#define GNO_FOREST_TREES 1\n" FOREST "#define GNO_TOP_BUILDS 1\n" TOP "#include \"gnomon/top/build.glsl\"\n", "top/build.glsl",
     "GNO_FOREST_BUILDS"},
    // A misspelt pass is no pass.
    {"top_build.misspelt_pass",
     LIGHT "#define GNO_TOP_BUILDS GNO_TOP_PASS_NONE\n#define GNO_TOP_PASS_NONE 0\n" TOP "#include \"gnomon/top/build.glsl\"\n", "top/build.glsl",
     "GNO_TOP_BUILDS"},
    // Where a light's part of the buffers begins is for queries alone.
    {"top_bindings.build_of_a_part", "#define GNO_TOP_BUILDS 1\n#define GNO_TOP_FIRST_NODE 64u\n" TOP, "top/bindings.glsl", "GNO_TOP_FIRST_NODE"},
    {"forest_bindings.build_of_a_part", "#define GNO_FOREST_BUILDS 1\n#define GNO_FOREST_FIRST_CELL 64u\n" FOREST, "forest/bindings.glsl",
     "GNO_FOREST_FIRST_CELL"},
    {"forest_bindings.emit_to_a_part", "#define GNO_FOREST_BUILDS 1\n#define GNO_FOREST_FIRST_PAIR 64u\n" FOREST, "forest/bindings.glsl",
     "GNO_FOREST_FIRST_PAIR"},
    {"rivals_light_grid_bindings.lists_of_a_part",
     "#define GNO_LIGHT_GRID_BUILDS 1\n#define GNO_LIGHT_GRID_FIRST_LIST 64u\n#include \"gnomon/rivals/light_grid_bindings.glsl\"\n",
     "rivals/light_grid_bindings.glsl", "GNO_LIGHT_GRID_FIRST_LIST"},
    {"rivals_light_grid_bindings.items_of_a_part",
     "#define GNO_LIGHT_GRID_BUILDS 1\n#define GNO_LIGHT_GRID_FIRST_ITEM 64u\n#include \"gnomon/rivals/light_grid_bindings.glsl\"\n",
     "rivals/light_grid_bindings.glsl", "GNO_LIGHT_GRID_FIRST_ITEM"},
    {"rivals_light_bvh_bindings.build_of_a_part",
     "#define GNO_LIGHT_BVH_BUILDS 1\n#define GNO_LIGHT_BVH_FIRST_NODE 64u\n#include \"gnomon/rivals/light_bvh_bindings.glsl\"\n",
     "rivals/light_bvh_bindings.glsl", "GNO_LIGHT_BVH_FIRST_NODE"},
    // Two lights by including twice: the second inclusion would be ignored.
    {"two_lights_by_including_twice",
     "layout(push_constant) uniform Push { vec4 sun, lamp; } push;\n" BOUND "#define GNO_LIGHT push.sun\n#define GNO_TOP_SET 1\n" TOP
     "#include \"gnomon/top/query_hybrid.glsl\"\n#undef GNO_LIGHT\n#undef GNO_TOP_SET\n#define GNO_LIGHT push.lamp\n#define GNO_TOP_SET 2\n" TOP
     "#include \"gnomon/top/query_hybrid.glsl\"\n",
     "top/bindings.glsl", "GNO_TOP_FIRST_NODE"},
};

std::string shader(const std::string& body, bool rays) {
    return std::string("#version ") + (rays ? "460" : "450") + "\n#extension GL_GOOGLE_include_directive : require\n" +
           (rays ? "#extension GL_EXT_ray_query : require\n" : "") + body + "layout(local_size_x = 1) in;\nvoid main() {}\n";
}

}  // namespace

std::vector<MustFail> refused(const Texts& library) {
    std::vector<MustFail> cases;
    for (const Refusal& one : kRefusals) cases.push_back({std::string(one.name) + ".comp", shader(one.body, false), one.file, one.macro});
    for (const auto& [path, text] : library) {
        if (!path.ends_with("bindings.glsl")) continue;
        std::smatch error;
        static const std::regex twice("\n#ifdef GNO_[A-Z_]+_GLSL\n#error \"[^\n]*(GNO_[A-Z_]+)");
        if (!std::regex_search(text, error, twice)) throw std::invalid_argument(path + " does not refuse a second inclusion");
        const std::string include = "#include \"gnomon/" + path + "\"\n";
        cases.push_back(
            {moduleStem(path) + ".included_twice.comp", shader(include + include, path.find("ray_query") != std::string::npos), path, error[1]});
    }
    return cases;
}

}  // namespace gno::test
