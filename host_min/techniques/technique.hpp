// SPDX-License-Identifier: MIT
// A technique answers for every view sample of a frame. One class in NAME.cpp, one line in registry.cpp; every tool and test finds it from there.
#pragma once
#include <any>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host_min/frame/inputs.hpp"
#include "host_min/output/record.hpp"
#include "host_min/techniques/settings.hpp"

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
    NamedNumbers bytes;
    RecordCounters counters;
    std::vector<DumpedBuffer> dump;
    std::optional<glm::uvec2> traced{};  ///< the pixel whose way the dump holds
};

/// Structures that several techniques share for one frame and light, by a key that names all they depend on.
class StructureCache {
public:
    template <class T, class Make>
    T& get(const std::string& key, const Make& make) {
        auto& entry = entries_[key];
        if (!entry.has_value()) entry = std::shared_ptr<T>(make());
        return *std::any_cast<std::shared_ptr<T>&>(entry);
    }
    void clear() { entries_.clear(); }

private:
    std::map<std::string, std::any> entries_;
};

class Technique {
public:
    virtual ~Technique() = default;
    [[nodiscard]] virtual const TechniqueInfo& info() const = 0;
    virtual TechniqueResult run(const FrameInputs& inputs, StructureCache& structures, const Settings& settings, const RunOptions& options) = 0;
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
