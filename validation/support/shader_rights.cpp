// SPDX-License-Identifier: MIT
#include "validation/support/shader_rights.hpp"

#include <map>
#include <stdexcept>

namespace gno::test {
namespace {

// Of the SPIR-V specification.
enum Op : uint32_t {
    kName = 5,
    kTypeImage = 25,
    kTypeArray = 28,
    kTypeRuntimeArray = 29,
    kTypeStruct = 30,
    kTypePointer = 32,
    kVariable = 59,
    kImageTexelPointer = 60,
    kLoad = 61,
    kStore = 62,
    kAccessChain = 65,
    kInBoundsAccessChain = 66,
    kDecorate = 71,
    kMemberDecorate = 72,
    kImageWrite = 99,
    kAtomicStore = 228,
    kAtomicExchange = 229,
    kAtomicXor = 242  // and all atomics between
};
enum Decoration : uint32_t { kBufferBlock = 3, kNonWritable = 24 };
enum StorageClass : uint32_t { kUniformConstant = 0, kUniform = 2, kStorageBuffer = 12 };

struct Type {
    Op op;
    uint32_t inner = 0;    ///< of a pointer or an array
    uint32_t members = 0;  ///< of a structure
    bool storage = false;  ///< of an image: it has no sampler
};

struct Module {
    std::map<uint32_t, std::string> names;
    std::map<uint32_t, Type> types;
    std::map<uint32_t, std::set<uint32_t>> decorations;           ///< of a variable or a type
    std::map<uint32_t, std::set<uint32_t>> constantMembers;       ///< of a structure: the members that are NonWritable
    std::map<uint32_t, std::pair<uint32_t, uint32_t>> variables;  ///< pointer type, storage class
    std::map<uint32_t, uint32_t> origins;                         ///< of a pointer or an image: the variable it comes from
    std::set<uint32_t> stored;                                    ///< variables that are written

    explicit Module(std::span<const uint32_t> spirv) {
        if (spirv.size() < 5 || spirv[0] != 0x07230203u) throw std::runtime_error("this is no SPIR-V");
        for (size_t at = 5; at < spirv.size();) {
            const uint32_t length = spirv[at] >> 16;
            if (length == 0 || at + length > spirv.size()) throw std::runtime_error("a broken SPIR-V module");
            read(spirv[at] & 0xFFFFu, spirv.subspan(at + 1, length - 1));
            at += length;
        }
    }

    /// What it points to, out of all arrays.
    [[nodiscard]] uint32_t pointee(uint32_t pointer) const {
        uint32_t id = types.at(pointer).inner;
        for (auto at = types.find(id); at != types.end() && (at->second.op == kTypeArray || at->second.op == kTypeRuntimeArray); at = types.find(id))
            id = at->second.inner;
        return id;
    }
    [[nodiscard]] bool has(uint32_t id, uint32_t decoration) const {
        const auto found = decorations.find(id);
        return found != decorations.end() && found->second.contains(decoration);
    }

private:
    [[nodiscard]] uint32_t origin(uint32_t pointer) const {
        const auto found = origins.find(pointer);
        return found == origins.end() ? pointer : found->second;
    }
    void read(uint32_t op, std::span<const uint32_t> words) {
        switch (op) {
            case kName:
                names[words[0]] = reinterpret_cast<const char*>(&words[1]);
                break;
            case kDecorate:
                decorations[words[0]].insert(words[1]);
                break;
            case kMemberDecorate:
                if (words[2] == kNonWritable) constantMembers[words[0]].insert(words[1]);
                break;
            case kTypeImage:
                types[words[0]] = {Op(op), 0, 0, words[6] == 2};
                break;
            case kTypeArray:
            case kTypeRuntimeArray:
                types[words[0]] = {Op(op), words[1]};
                break;
            case kTypeStruct:
                types[words[0]] = {Op(op), 0, uint32_t(words.size() - 1)};
                break;
            case kTypePointer:
                types[words[0]] = {Op(op), words[2]};
                break;
            case kVariable:
                variables[words[1]] = {words[0], words[2]};
                break;
            case kLoad:
            case kAccessChain:
            case kInBoundsAccessChain:
            case kImageTexelPointer:
                origins[words[1]] = origin(words[2]);
                break;
            case kStore:
            case kAtomicStore:
            case kImageWrite:
                stored.insert(origin(words[0]));
                break;
            default:
                if (op >= kAtomicExchange && op <= kAtomicXor) stored.insert(origin(words[2]));
                break;
        }
    }
};

std::string nameOf(const Module& module, uint32_t variable, uint32_t type) {
    for (const uint32_t id : {variable, type}) {  // a block without an instance name has the block's
        const auto found = module.names.find(id);
        if (found != module.names.end() && !found->second.empty()) return found->second;
    }
    throw std::runtime_error("a buffer or an image without a name");
}

using Names = std::set<std::string>;

// One line per example that writes anything. Held against the modules' headers by hand: what a step says it writes is what stands here.
const std::map<std::string_view, Names> kWritten{
    {"clusters/examples/allocate.comp", {"gnoClusterHeader", "gnoClusterPointers"}},
    {"clusters/examples/clear_sums.comp", {"gnoTransmittances"}},
    {"clusters/examples/finish_size.comp", {"gnoClusterHeader"}},
    {"clusters/examples/merge.comp", {"gnoVisibility"}},
    {"clusters/examples/merge_layers.comp", {"gnoTransmittances", "gnoVisibility"}},
    {"clusters/examples/range.comp", {"gnoClusterHeader"}},
    {"clusters/examples/reset.comp", {"gnoClusterHeader", "gnoClusterMasks", "gnoClusterShade"}},
    {"clusters/examples/slices.comp", {"gnoClusterHeader", "gnoClusterSliceTable"}},
    {"clusters/examples/tiles.comp", {"gnoClusterHeader", "gnoClusterHigh", "gnoClusterLow", "gnoClusterMasks"}},
    {"clusters/examples/traverse.comp", {"gnoClusterHeader", "gnoClusterJobs", "gnoClusterMasks", "gnoClusterShade"}},
    {"clusters/examples/traverse_layers.comp", {"gnoClusterHeader", "gnoClusterJobs", "gnoClusterMasks", "gnoClusterShade", "gnoTransmittances"}},
    {"clusters/examples/up.comp", {"gnoClusterHeader", "gnoClusterHigh", "gnoClusterLow", "gnoClusterMasks"}},
    {"clusters/examples/volumes.comp", {"gnoClusterHeader", "gnoClusterInfo", "gnoClusterVolumes"}},
    {"core/examples/caster_state.comp", {"gnoStates"}},
    {"core/examples/floor.comp", {"gnoVisibility"}},
    {"core/examples/orient3d.comp", {"Answers"}},
    {"core/examples/view_samples.comp", {"gnoSamples"}},
    {"core/examples/view_samples_from_depth.comp", {"gnoSamples"}},
    {"forest/examples/allocate.comp", {"gnoForestCells", "gnoForestHeader"}},
    {"forest/examples/assign_few.comp", {"gnoForestCells", "gnoForestHeader", "gnoForestPairs"}},
    {"forest/examples/assign_many.comp", {"gnoForestCells", "gnoForestHeader", "gnoForestPairs"}},
    {"forest/examples/assign_some.comp", {"gnoForestCells", "gnoForestHeader", "gnoForestPairs"}},
    {"forest/examples/build.comp", {"gnoForestCells", "gnoTopHeader", "gnoTopLinks", "gnoTopSlabs"}},
    {"forest/examples/depth.comp", {"gnoForestCells"}},
    {"forest/examples/query_hybrid.comp", {"gnoVisibility"}},
    {"forest/examples/query_stack.comp", {"gnoVisibility"}},
    {"forest/examples/query_stackless.comp", {"gnoVisibility"}},
    {"forest/examples/reset.comp", {"gnoForestCells", "gnoForestHeader"}},
    {"forest/examples/set_up.comp", {"gnoTopHeader", "gnoTopLinks", "gnoTopPlanes", "gnoTopSlabs"}},
    {"forest/examples/sizes.comp", {"gnoForestHeader"}},
    {"forest/examples/sort.comp", {"gnoForestFew", "gnoForestHeader", "gnoList"}},
    {"rivals/examples/light_bvh_begin.comp", {"gnoLightBvhHeader", "gnoLightBvhLevels", "gnoLightBvhSums"}},
    {"rivals/examples/light_bvh_collapse.comp", {"gnoLightBvhHeader", "gnoLightBvhLevels", "gnoLightBvhNode", "gnoLightBvhParents"}},
    {"rivals/examples/light_bvh_count.comp", {"gnoLightBvhHeader", "gnoLightBvhMasks", "gnoLightBvhSums"}},
    {"rivals/examples/light_bvh_emit.comp", {"gnoLightBvhHeader", "gnoLightBvhKeys", "gnoLightBvhOrder", "gnoLightBvhReferences"}},
    {"rivals/examples/light_bvh_leaves.comp", {"gnoLightBvhBoxes_"}},
    {"rivals/examples/light_bvh_query_stack.comp", {"gnoVisibility"}},
    {"rivals/examples/light_bvh_query_stackless.comp", {"gnoVisibility"}},
    {"rivals/examples/light_bvh_sort_count.comp", {"gnoSortCountWords"}},
    {"rivals/examples/light_bvh_sort_prefix.comp", {"gnoSortCountWords"}},
    {"rivals/examples/light_bvh_sort_scatter.comp", {"gnoSortedKeys", "gnoSortedOrder"}},
    {"rivals/examples/light_bvh_split.comp",
     {"gnoLightBvhHeader", "gnoLightBvhLevels", "gnoLightBvhNode", "gnoLightBvhParents", "gnoLightBvhSplits"}},
    {"rivals/examples/light_bvh_up.comp", {"gnoLightBvhBoxes_"}},
    {"rivals/examples/light_grid_allocate.comp", {"gnoGridHeader", "gnoGridLists"}},
    {"rivals/examples/light_grid_depth.comp", {"gnoGridDepths"}},
    {"rivals/examples/light_grid_open.comp", {"gnoForestCells", "gnoForestHeader", "gnoGridDepths", "gnoGridHeader", "gnoGridLists"}},
    {"rivals/examples/light_grid_pairs.comp", {"gnoGridHeader", "gnoGridItems", "gnoGridLists"}},
    {"rivals/examples/light_grid_planes.comp", {"gnoGridHeader", "gnoGridPlanes"}},
    {"rivals/examples/light_grid_query.comp", {"gnoVisibility"}},
    {"rivals/examples/light_grid_query_planes.comp", {"gnoVisibility"}},
    {"rivals/examples/light_grid_reset.comp", {"gnoGridHeader"}},
    {"rivals/examples/light_grid_sizes.comp", {"gnoGridHeader"}},
    {"rivals/examples/light_grid_sort.comp", {"gnoGridHeader", "gnoGridItems"}},
    {"rivals/examples/ray_query.comp", {"gnoVisibility"}},
    {"rivals/examples/ray_set_up.comp", {"gnoRayIndices"}},
    {"shadow_map/examples/fit.comp", {"gnoShadowMapBounds"}},
    {"shadow_map/examples/query.comp", {"gnoVisibility"}},
    {"shadow_map/examples/reset.comp", {"gnoShadowMapBounds"}},
    {"top/examples/build.comp", {"gnoTopHeader", "gnoTopLinks"}},
    {"top/examples/query_hybrid.comp", {"gnoVisibility"}},
    {"top/examples/query_stack.comp", {"gnoVisibility"}},
    {"top/examples/query_stackless.comp", {"gnoVisibility"}},
    {"top/examples/set_up.comp", {"gnoTopHeader", "gnoTopLinks", "gnoTopPlanes"}},
    {"top/examples/trace_hybrid.comp", {"gnoTopTrace", "gnoTopVisits", "gnoVisibility"}},
    {"top/examples/trace_stack.comp", {"gnoTopTrace", "gnoTopVisits", "gnoVisibility"}},
    {"top/examples/trace_stackless.comp", {"gnoTopTrace", "gnoTopVisits", "gnoVisibility"}},
};

// What the instrumented variant of a shader writes more.
Names countersOf(std::string_view shader) {
    if (shader.ends_with("/build.comp")) return {"gnoTotals"};
    if (shader.find("/traverse") != std::string_view::npos) return {"gnoCounts", "gnoSteps", "gnoTotals"};
    const bool asks = shader.find("query") != std::string_view::npos || shader.find("/trace_") != std::string_view::npos;
    if (shader.ends_with(".comp") && (asks || shader == "core/examples/floor.comp")) return {"gnoCounts"};
    return {};
}

/// Storage buffers and storage images that `wanted` picks, by name.
template <class Wanted>
Names pick(const Module& module, Wanted wanted) {
    Names found;
    for (const auto& [variable, what] : module.variables) {
        const auto [pointer, storage] = what;
        if (storage != kUniformConstant && storage != kUniform && storage != kStorageBuffer) continue;
        const uint32_t id = module.pointee(pointer);
        const auto known = module.types.find(id);
        if (known == module.types.end()) continue;  // a sampled image, an acceleration structure
        const Type& type = known->second;
        const bool buffer = type.op == kTypeStruct && (storage == kStorageBuffer || (storage == kUniform && module.has(id, kBufferBlock)));
        const bool image = type.op == kTypeImage && type.storage && storage == kUniformConstant;
        if ((buffer || image) && wanted(variable, id, type)) found.insert(nameOf(module, variable, id));
    }
    return found;
}

}  // namespace

Names writable(std::span<const uint32_t> spirv) {
    const Module module(spirv);
    return pick(module, [&](uint32_t variable, uint32_t id, const Type& type) {
        if (module.has(variable, kNonWritable)) return false;
        const auto constant = module.constantMembers.find(id);
        return type.op != kTypeStruct || constant == module.constantMembers.end() || constant->second.size() < type.members;
    });
}

Names stored(std::span<const uint32_t> spirv) {
    const Module module(spirv);
    return pick(module, [&](uint32_t variable, uint32_t, const Type&) { return module.stored.contains(variable); });
}

Names writtenBy(std::string_view shader) {
    constexpr std::string_view kCounters = ".counters";
    const bool counts = shader.ends_with(kCounters);
    if (counts) shader.remove_suffix(kCounters.size());
    const auto listed = kWritten.find(shader);
    Names names = listed == kWritten.end() ? Names{} : listed->second;
    if (counts) names.merge(countersOf(shader));
    return names;
}

}  // namespace gno::test
