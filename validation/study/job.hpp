// SPDX-License-Identifier: MIT
// What one row of the results is about. Its key names everything that defines it, in words that another run, or another machine, spells the same.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace gno::study {

/// All that is measured together, in turns: one frame of a scene, one light, one size.
struct Group {
    std::string scene;  ///< a file, or NAME:TRIANGLES of a generated one
    uint32_t camera = 0, frame = 0, light = 0;
    std::string cull = "none";
    uint32_t width = 0, height = 0;

    [[nodiscard]] std::string key() const;
};

/// A technique or peer, a precision, and where its settings are away from their defaults.
struct Variant {
    std::string technique, precision;
    bool peer = false;
    std::vector<std::string> given;  ///< KEY=VALUE; without the key that is searched
    std::string bestOf;              ///< key whose best value is searched; empty: none

    /// All settings, defaults included; the searched one only when `bestValue` is not empty. Empty object for a peer.
    [[nodiscard]] nlohmann::ordered_json settings(const std::string& bestValue) const;
    /// Names of the settings that are away from their defaults.
    [[nodiscard]] std::vector<std::string> varied(const std::string& bestValue) const;
    [[nodiscard]] std::string key() const;
};

std::string jobKey(const Group& group, const Variant& variant);

/// A group and what of it is wanted.
struct GroupJobs {
    Group group;
    std::vector<Variant> variants;
    uint32_t repeat = 3;
};

}  // namespace gno::study
