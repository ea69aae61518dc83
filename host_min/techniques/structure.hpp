// SPDX-License-Identifier: MIT
// What a technique asks: a tree, a forest, lists, a map, for one light and one choice of settings. It outlives frames: buffers keep their sizes, and
// what one frame told (how many pairs there were) sizes the next. Several techniques may share one.
#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "host_min/frame/inputs.hpp"
#include "host_min/output/record.hpp"

namespace gno::host {

/// What a frame asks of any structure, known before any work on it.
struct FrameLoad {
    uint64_t triangles = 0;
    uint32_t width = 1, height = 1;
    bool materials = false;  ///< some casters are alpha-tested or coloured
    static FrameLoad of(const FrameInputs& inputs);
};

/// "N triangles, and it holds MOST: WHY": what structures say when they are too many; empty when they are not.
std::string overCasters(uint64_t triangles, uint64_t most, const std::string& why);

/// Throws LimitError with this text unless it is empty.
void throwLimit(const std::string& text);

/// How often to run, and what for.
struct BuildOptions {
    uint32_t repeat = 1;
    bool warmUp = true;    ///< once before, for the driver's compilation
    bool counters = true;  ///< the instrumented passes as well
};

class Structure {
public:
    virtual ~Structure() = default;

    /// Everything a frame needs before it is recorded: buffers and pipelines, sizes from this frame's counts and from what earlier frames told,
    /// constants that the host owes. The only place (but for between()) that allocates. `inputs` must outlive the frame. Throws InputError when a
    /// limit of the device would be passed.
    virtual void prepare(const FrameInputs& inputs) = 0;

    /// A frame is recorded in so many parts; the host waits between them. More than one only where TechniqueInfo::hostWaits says so.
    [[nodiscard]] virtual uint32_t segments() const { return 1; }

    /// Records one of them: no allocation, no submission, no wait. The same state recorded twice does the same work.
    virtual void record(Recording& recording, uint32_t segment) const = 0;

    /// What the host does after segment `segment` is done and before the next one is recorded.
    virtual void between(uint32_t segment);

    /// The instrumented passes, once; fills counters. After prepare(). Without counters of its own there is nothing to do.
    virtual void count() {}

    /// After the frame: learns what the device found. False: a pool was too small, the answers are unknown: prepare() enlarges it, build again.
    [[nodiscard]] virtual bool read() { return true; }

    [[nodiscard]] const std::vector<RecordPass>& passes() const { return passes_; }  ///< of the last build: device time each, the host's waits
    [[nodiscard]] uint32_t waits() const { return segments() - 1; }                  ///< of the host, in a frame
    [[nodiscard]] uint32_t reruns() const { return reruns_; }                        ///< of the last build, until its pools were large enough

private:
    friend void build(Structure& structure, const FrameInputs& inputs, const BuildOptions& options);
    std::vector<RecordPass> passes_;
    uint32_t reruns_ = 0;
};

/// Prepares and builds it for this frame: with counters, then as often as asked, each from the same state before. A pool that was too small is
/// enlarged, three times at most. passes(): median times; behind several segments a pass "host_wait", the time on the host's clock that was none of
/// the device's passes. Throws InputError when it is still not complete.
void build(Structure& structure, const FrameInputs& inputs, const BuildOptions& options);

/// One of its own, built at once.
template <class T, class Options>
[[nodiscard]] T built(const FrameInputs& inputs, const Options& options, const BuildOptions& how = {.warmUp = false}) {
    T structure(options);
    build(structure, inputs, how);
    return structure;
}

/// Structures of one light, by a key that names all they depend on. They outlive frames; each is built once a frame, by the first technique that
/// asks.
class StructureCache {
public:
    template <class T, class Make>
    T& get(const std::string& key, const FrameInputs& inputs, const BuildOptions& options, const Make& make) {
        Entry& entry = entries_[key];
        try {
            if (!entry.structure) entry.structure = make();
            if (!entry.built) build(*entry.structure, inputs, options);
        } catch (...) {
            entries_.erase(key);  // what it holds may be what others lack
            throw;
        }
        entry.built = true;
        return dynamic_cast<T&>(*entry.structure);
    }
    /// A new frame, or other inputs: all have to be built again, from what they learned.
    void nextFrame() {
        for (auto& [key, entry] : entries_) entry.built = false;
    }
    void clear() { entries_.clear(); }

private:
    struct Entry {
        std::unique_ptr<Structure> structure;
        bool built = false;
    };
    std::map<std::string, Entry> entries_;
};

}  // namespace gno::host
