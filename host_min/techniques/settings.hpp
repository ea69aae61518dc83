// SPDX-License-Identifier: MIT
// `--set KEY=VALUE`: what keys there are, and their values checked once, before any work.
#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace gno::host {

struct SettingInfo {
    std::string key;
    std::string meaning;
    uint32_t minimum = 0, maximum = 0;  ///< unused when there are choices
    std::vector<std::string> choices;   ///< words; empty: a number
    std::string fallback;               ///< the default
    bool decimals = false;              ///< a number may have digits behind a point

    [[nodiscard]] std::string range() const;  ///< "1..64", "0.0..64.0" or "none|front|hull|all"
};

/// Values of some keys, defaults included.
class Settings {
public:
    /// Defaults of `known`, then `given` (KEY=VALUE each) on top. Throws InputError: no '=', a value out of range, a key given twice. A key that
    /// is not among `known` is skipped: checkSettings finds those that nobody knows.
    Settings(std::span<const SettingInfo> known, std::span<const std::string> given);

    [[nodiscard]] uint32_t number(const std::string& key) const;  ///< whole ones
    [[nodiscard]] double real(const std::string& key) const;      ///< with decimals or without
    [[nodiscard]] const std::string& word(const std::string& key) const;
    [[nodiscard]] nlohmann::ordered_json json() const;

private:
    std::vector<std::pair<std::string, std::string>> values_;
    enum class Kind { word, whole, decimals };
    std::map<std::string, Kind> kinds_;
};

/// Throws InputError when a key of `given` is in none of the lists; the text lists what is known.
void checkSettings(std::span<const std::span<const SettingInfo>> known, std::span<const std::string> given);

}  // namespace gno::host
