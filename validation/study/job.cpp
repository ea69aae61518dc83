// SPDX-License-Identifier: MIT
#include "validation/study/job.hpp"

#include <fmt/format.h>

#include "host_min/techniques/technique.hpp"

namespace gno::study {
namespace {

std::vector<std::string> withBest(const Variant& variant, const std::string& bestValue) {
    std::vector<std::string> given = variant.given;
    if (!bestValue.empty()) given.push_back(variant.bestOf + "=" + bestValue);
    return given;
}

}  // namespace

std::string Group::key() const {
    return fmt::format("{} camera={} frame={} light={} cull={} {}x{}", scene, camera, frame, light, cull, width, height);
}

nlohmann::ordered_json Variant::settings(const std::string& bestValue) const {
    if (peer) return nlohmann::ordered_json::object();
    return host::Settings(host::techniqueByName(technique).info().settings, withBest(*this, bestValue)).json();
}

std::vector<std::string> Variant::varied(const std::string& bestValue) const {
    std::vector<std::string> keys;
    if (peer) return keys;
    const auto& known = host::techniqueByName(technique).info().settings;
    const host::Settings defaults(known, {}), chosen(known, withBest(*this, bestValue));
    for (const host::SettingInfo& info : known)
        if (info.key == bestOf || chosen.word(info.key) != defaults.word(info.key)) keys.push_back(info.key);
    return keys;
}

std::string Variant::key() const {
    std::string text = technique + " " + precision;
    if (peer) return text;
    const auto& known = host::techniqueByName(technique).info().settings;
    const host::Settings chosen(known, given);
    for (const host::SettingInfo& info : known) text += fmt::format(" {}={}", info.key, info.key == bestOf ? "best" : chosen.word(info.key));
    return text;
}

std::string jobKey(const Group& group, const Variant& variant) { return group.key() + " " + variant.key(); }

}  // namespace gno::study
