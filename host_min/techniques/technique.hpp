// SPDX-License-Identifier: MIT
// A technique answers for every view sample of a frame. One class in NAME.cpp, one line in registry.cpp; every tool and test finds it from there.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host_min/frame/inputs.hpp"
#include "host_min/frame/pass_runner.hpp"
#include "host_min/output/record.hpp"
#include "host_min/techniques/settings.hpp"
#include "host_min/techniques/structure.hpp"

namespace gno::host {

enum class Precision : uint32_t { published = 0, conservative = 1, certified = 2 };  ///< GNO_PRECISION_* of core/shared_types.h
const char* name(Precision precision);
Precision precisionByName(const std::string& text);  ///< throws InputError that lists the rungs

struct TechniqueInfo {
    std::string name;  ///< of the command line, the record and the pictures
    std::string paper;
    std::vector<Precision> precisions;
    std::vector<SettingInfo> settings;
    std::vector<std::string> effects;  ///< what it can answer for: point_light, directional_light, ...
    bool subgroupBallot = false;       ///< needs subgroup ballots in compute shaders, beyond what the host needs anyway
    bool rayQuery = false;             ///< needs VK_KHR_ray_query and what belongs to it
    bool traces = false;               ///< can log the way of one pixel's query (RunOptions::trace)
    bool hostWaits = false;            ///< the host waits within a frame (Structure::segments)
};

/// What the device lacks for this technique, by Vulkan's field name; empty: nothing.
std::string missingFor(const TechniqueInfo& info, const DeviceFacts& device);

struct RunOptions {
    Precision precision = Precision::certified;
    uint32_t repeat = 1;
    bool counters = true;               ///< make the instrumented run as well
    bool dump = false;                  ///< hand over the buffers
    bool warmUp = true;                 ///< false: the pipelines have run before, or nobody reads the times
    std::optional<glm::uvec2> trace{};  ///< with dump and counters, where the technique can: log the way of this pixel's query
};

struct DumpedBuffer {
    std::string name, layout;  ///< layout: the record's type, in words of glsl/*/ *.h
    std::vector<std::byte> bytes;
    uint32_t words = 1;  ///< of 32 bits, in a record
};

struct TechniqueResult {
    std::vector<uint32_t> visibility;  ///< GNO_VISIBILITY_* per pixel
    std::vector<glm::uvec3>
        sums;  ///< per pixel, core/transmittance.glsl; shadow is where all three are kNoLight. Empty: every caster taken for opaque
    std::vector<uint32_t> visitedNodes;  ///< per pixel; empty where the technique has none, or without counters
    std::vector<uint32_t> sampleTests;   ///< per pixel: how often it was tested against a shadow volume; the same
    std::vector<uint32_t> deepestStack;  ///< per pixel; the same
    std::vector<RecordPass> passes;      ///< structure first
    uint32_t hostWaits = 0;              ///< of the host within the frame
    uint32_t reruns = 0;                 ///< builds thrown away because a pool was too small
    NamedNumbers bytes;
    RecordCounters counters;
    std::vector<DumpedBuffer> dump;
    std::optional<glm::uvec2> traced{};  ///< the pixel whose way the dump holds
};

/// How a technique's structure is asked: passes (the last one answers), and what they bind besides casters, samples and images.
struct Query {
    PassList passes;
    std::vector<Binding> resources;
    bool countsPixels = true;  ///< the instrumented shader stores visited nodes, deepest stack, overflows and exact calls of each pixel
};

/// A structure that is prepared, recorded and read (Structure), and a query of it. One class in NAME.cpp, one line in registry.cpp.
class Technique {
public:
    virtual ~Technique() = default;
    [[nodiscard]] virtual const TechniqueInfo& info() const = 0;

    /// Which limit of the device a frame would pass, and what to do, in one line; empty: none that is known before the work.
    [[nodiscard]] virtual std::string overLimit(const DeviceFacts& device, const FrameLoad& load, const Settings& settings) const;

    /// Names all that the structure depends on but the frame's inputs: techniques with the same key share it.
    [[nodiscard]] virtual std::string structureKey(const FrameInputs& inputs, const Settings& settings, const RunOptions& options) const = 0;
    /// One that is neither prepared nor built.
    [[nodiscard]] virtual std::unique_ptr<Structure> makeStructure(const FrameInputs& inputs, const Settings& settings,
                                                                   const RunOptions& options) const = 0;
    /// How this one, built, is asked for every view sample.
    [[nodiscard]] virtual Query query(const Structure& structure, const FrameInputs& inputs, const Settings& settings,
                                      const RunOptions& options) const = 0;
    /// After the answer: counters, bytes and dumps of its own. `result` holds masks, passes and the query's counts.
    virtual void read(const Structure& structure, const FrameInputs& inputs, const Settings& settings, const RunOptions& options,
                      TechniqueResult& result) const = 0;

    /// One frame and light: the structure from `structures` (built, unless another technique has done so for this frame), then the query. Throws
    /// InputError when the device lacks something; LimitError: a limit would be passed.
    [[nodiscard]] TechniqueResult run(const FrameInputs& inputs, StructureCache& structures, const Settings& settings,
                                      const RunOptions& options) const;
};

/// All techniques of this build, in the order of the table in README.
const std::vector<std::unique_ptr<Technique>>& techniques();
/// Throws InputError: no such technique, or one that is planned but not in this build yet; the text says which.
Technique& techniqueByName(const std::string& name);
/// Planned ones, with their paper.
const std::vector<std::pair<std::string, std::string>>& plannedTechniques();

/// Settings that belong to the frame, known to every technique: cull.
const std::vector<SettingInfo>& frameSettings();

}  // namespace gno::host
