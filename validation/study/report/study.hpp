// SPDX-License-Identifier: MIT
// Rows put in order: setups (what was asked) and, in each, variants (who answered, with which settings), over the frames that they share.
#pragma once
#include <string>
#include <vector>

#include "validation/study/report/results.hpp"
#include "validation/study/report/statistics.hpp"

namespace gno::report {

/// One technique at one precision with its settings.
struct Variant {
    std::string technique, precision, bestOf;
    bool peer = false;
    nlohmann::ordered_json varied = nlohmann::ordered_json::object();  ///< settings moved away from the default, without the one that was searched
    nlohmann::ordered_json found = nlohmann::ordered_json::object();   ///< the searched one, with the value that was best here
    std::vector<const Row*> rows;                                      ///< one a frame, ascending
    std::string unavailable;                                           ///< why it has no measurements; empty: it has
    std::vector<double> repeats;                                       ///< time as ratio to the bare full-screen pass; over frames: geometric mean
    Spread time;                                                       ///< of `repeats`
    uint64_t checked = 0, wrong = 0, leaks = 0, bytes = 0;             ///< bytes: the most of any frame

    [[nodiscard]] bool isMeasured() const { return unavailable.empty(); }
    [[nodiscard]] bool isChecked() const { return isMeasured() && checked > 0; }
    [[nodiscard]] double wrongPerMillion() const { return 1e6 * double(wrong) / double(checked); }
    [[nodiscard]] std::string label() const;     ///< technique and settings: shadow-map size=2048 best bias
    [[nodiscard]] std::string fullName() const;  ///< with the precision and the value that was found
    [[nodiscard]] std::string key() const;       ///< the same in all setups; without what was found
};

/// A scene, camera, light, culling and size.
struct Setup {
    std::string title;  ///< show_garden, light 0 (point)
    std::string slug;   ///< for file names: show_garden-light0
    std::string scene;
    std::array<uint32_t, 2> size{};
    uint64_t casters = 0;
    std::vector<uint32_t> frames;   ///< those that most variants share
    std::vector<Variant> variants;  ///< that have all of these frames, or are unavailable
    std::vector<const Row*> rows;   ///< all of this setup, every frame

    [[nodiscard]] const Variant* find(const std::string& key) const;
};

struct Study {
    Study() = default;
    Study(Study&&) = default;  ///< and no copy: setups point into the rows
    Study& operator=(Study&&) = default;

    Results results;
    std::vector<Setup> setups;  ///< at the size at which most was measured; one a scene, camera, light and culling
    std::vector<Setup> others;  ///< the same at other sizes
    std::string device;
    std::vector<std::string> techniques;  ///< names, peers last
    std::vector<std::string> precisions;  ///< published, conservative and certified first

    [[nodiscard]] std::string sizes() const;  ///< of `setups`: 480x270
};

Study arrange(Results results);

/// The precision that promises most among those of the technique: certified before conservative before published.
int rank(const std::string& precision);
/// a's time over b's, repeat by repeat, in this setup. Both measured.
Spread timeRatio(const Variant& a, const Variant& b);

}  // namespace gno::report
