// SPDX-License-Identifier: MIT
#include "validation/study/expand.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "host_min/error.hpp"
#include "host_min/techniques/technique.hpp"
#include "validation/study/peer.hpp"

namespace gno::study {
namespace {

using Values = std::pair<std::string, std::vector<std::string>>;

bool has(const std::vector<std::string>& list, const std::string& word) { return std::find(list.begin(), list.end(), word) != list.end(); }

bool knows(const host::TechniqueInfo& info, const std::string& key) {
    return std::any_of(info.settings.begin(), info.settings.end(), [&](const host::SettingInfo& setting) { return setting.key == key; });
}

/// K1=V1,V2:K2=V3
std::vector<Values> valuesOf(const std::string& entry) {
    std::vector<Values> values;
    for (const std::string& part : splitAt(entry, ':')) {
        const size_t at = part.find('=');
        const std::vector<std::string> list = at == std::string::npos ? std::vector<std::string>() : splitAt(part.substr(at + 1), ',');
        if (at == 0 || list.empty()) throw host::InputError(fmt::format("--vary {}: write KEY=V1,V2,...", entry));
        values.emplace_back(part.substr(0, at), list);
    }
    if (values.empty()) throw host::InputError("--vary: write KEY=V1,V2,...");
    return values;
}

std::string keyOf(const std::string& keyAndValue) { return keyAndValue.substr(0, keyAndValue.find('=')); }

/// Those of the chosen techniques, in the order of the registry.
std::vector<const host::TechniqueInfo*> chosenTechniques(const SweepOptions& options) {
    std::vector<std::string> names;
    std::vector<const host::TechniqueInfo*> chosen;
    for (const auto& technique : host::techniques()) {
        names.push_back(technique->info().name);
        if (has(options.techniques, "all") || has(options.techniques, names.back())) chosen.push_back(&technique->info());
    }
    for (const auto& peer : peers()) names.push_back(peer->name());
    for (const std::string& word : options.techniques)
        if (word != "all" && !has(names, word))
            throw host::InputError(fmt::format("--technique {}: there is none of that name; there are {}", word, fmt::join(names, ", ")));
    return chosen;
}

void checkPrecisions(const SweepOptions& options) {
    std::vector<std::string> words;
    const auto add = [&](const std::string& word) {
        if (!has(words, word)) words.push_back(word);
    };
    for (const auto& technique : host::techniques())
        for (const host::Precision precision : technique->info().precisions) add(host::name(precision));
    for (const auto& peer : peers())
        for (const std::string& word : peer->precisions()) add(word);
    for (const std::string& word : options.precisions)
        if (word != "all" && !has(words, word))
            throw host::InputError(fmt::format("--precision {}: there is none of that name; there are {}", word, fmt::join(words, ", ")));
}

void checkKeys(const SweepOptions& options, const std::vector<const host::TechniqueInfo*>& chosen) {
    std::vector<std::string> known;
    for (const host::TechniqueInfo* info : chosen)
        for (const host::SettingInfo& setting : info->settings)
            if (!has(known, setting.key)) known.push_back(setting.key);
    const auto check = [&](const char* option, const std::string& key) {
        if (!has(known, key))
            throw host::InputError(fmt::format("{} {}: none of the chosen techniques knows it; known here: {}", option, key,
                                               known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "))));
    };
    std::set<std::string> set;
    for (const std::string& entry : options.set) {
        if (entry.find('=') == std::string::npos) throw host::InputError(fmt::format("--set {}: write KEY=VALUE", entry));
        check("--set", keyOf(entry));
        set.insert(keyOf(entry));
    }
    const auto checkFree = [&](const char* option, const std::string& key) {
        if (set.contains(key)) throw host::InputError(fmt::format("{} {}: --set gives its value already", option, key));
    };
    for (const std::string& entry : options.vary) {
        for (const Values& values : valuesOf(entry)) {
            check("--vary", values.first);
            checkFree("--vary", values.first);
        }
    }
    for (const std::string& key : options.best) {
        check("--best", key);
        checkFree("--best", key);
    }
}

/// All combinations of the values of the keys that this technique knows.
std::vector<std::vector<std::string>> combinations(const std::vector<Values>& values, const host::TechniqueInfo& info) {
    std::vector<std::vector<std::string>> result{{}};
    for (const auto& [key, list] : values) {
        if (!knows(info, key)) continue;
        std::vector<std::vector<std::string>> longer;
        for (const auto& start : result) {
            for (const std::string& value : list) {
                longer.push_back(start);
                longer.back().push_back(key + "=" + value);
            }
        }
        result = std::move(longer);
    }
    return result;
}

void addTechnique(const SweepOptions& options, const host::TechniqueInfo& info, host::Precision precision, std::vector<Variant>& variants) {
    const Variant base{info.name, host::name(precision), false, {}, {}};
    std::vector<std::string> set;
    for (const std::string& entry : options.set)
        if (knows(info, keyOf(entry))) set.push_back(entry);
    std::vector<std::vector<std::string>> all{set};
    for (const std::string& entry : options.vary) {
        for (const auto& combination : combinations(valuesOf(entry), info)) {
            all.push_back(set);
            all.back().insert(all.back().end(), combination.begin(), combination.end());
        }
    }
    for (const auto& given : all) {
        Variant variant = base;
        variant.given = given;
        const host::Settings checked(info.settings, given);
        variants.push_back(variant);
        for (const std::string& key : options.best) {
            if (!knows(info, key) || std::any_of(given.begin(), given.end(), [&](const std::string& entry) { return keyOf(entry) == key; }))
                continue;
            variant.bestOf = key;
            variants.push_back(variant);
        }
    }
}

}  // namespace

std::vector<Variant> variantsOf(const SweepOptions& options) {
    const auto chosen = chosenTechniques(options);
    checkPrecisions(options);
    checkKeys(options, chosen);
    const auto wanted = [&](const std::string& precision) { return has(options.precisions, "all") || has(options.precisions, precision); };
    std::vector<Variant> all;
    for (const host::TechniqueInfo* info : chosen)
        for (const host::Precision precision : info->precisions)
            if (wanted(host::name(precision))) addTechnique(options, *info, precision, all);
    for (const auto& peer : peers())
        if (has(options.techniques, "all") || has(options.techniques, peer->name()))
            for (const std::string& precision : peer->precisions())
                if (wanted(precision)) all.push_back({peer->name(), precision, true, {}, {}});
    std::vector<Variant> once;
    std::set<std::string> keys;
    for (const Variant& variant : all)
        if (keys.insert(variant.key()).second) once.push_back(variant);
    if (once.empty()) throw host::InputError("nothing to measure: no chosen technique has a chosen precision");
    return once;
}

std::vector<GroupJobs> expand(const SweepOptions& options, SceneShelf& shelf) {
    const std::vector<Variant> variants = variantsOf(options);
    std::vector<std::string> scenes = options.scenes;
    for (const std::string& entry : options.series) {
        const size_t at = entry.find('=');
        const std::vector<std::string> sizes = at == std::string::npos ? std::vector<std::string>() : splitAt(entry.substr(at + 1), ',');
        if (sizes.empty()) throw host::InputError(fmt::format("--vary-scene {}: write NAME=TRIANGLES,TRIANGLES,...", entry));
        for (const std::string& size : sizes) scenes.push_back(entry.substr(0, at) + ":" + size);
        if (!generatedScene(scenes.back()))
            throw host::InputError(fmt::format("--vary-scene {}: gnomon-scenes makes none of that name in several sizes", entry));
    }
    for (std::string& scene : scenes)  // one spelling for one scene
        if (const auto made = generatedScene(scene)) scene = fmt::format("{}:{}", made->kind, made->triangles);
    if (scenes.empty()) throw host::InputError("which scenes? name .glb files, or scenes of gnomon-scenes as NAME:TRIANGLES");
    const std::vector<uint32_t> frames = framesOf(options.frame);
    const std::optional<uint32_t> light = lightOf(options.light);
    for (const std::string& cull : options.culls) const host::Settings checked(host::frameSettings(), std::vector{"cull=" + cull});
    for (const std::string& size : options.sizes) {
        const auto [width, height] = sizeOf(size);
        host::checkSize({}, width, height);
    }

    std::vector<GroupJobs> groups;
    std::set<std::string> keys;
    for (const std::string& scene : scenes) {
        const host::SceneFile& file = shelf.load(scene);
        if (options.camera >= file.cameraCount())
            throw host::InputError(fmt::format("--camera {}: {} has {} (0..{})", options.camera, scene, file.cameraCount(), file.cameraCount() - 1));
        if (light && *light >= file.lightCount())
            throw host::InputError(fmt::format("--light {}: {} has {} (0..{})", *light, scene, file.lightCount(), file.lightCount() - 1));
        for (const uint32_t frame : frames)
            for (uint32_t l = light.value_or(0); l <= light.value_or(file.lightCount() - 1); ++l)
                for (const std::string& cull : options.culls)
                    for (const std::string& size : options.sizes) {
                        const auto [width, height] = sizeOf(size);
                        const Group group{scene, options.camera, frame, l, cull, width, height};
                        if (keys.insert(group.key()).second) groups.push_back({group, variants, options.repeat});
                    }
    }
    return groups;
}

SweepOptions narrowed(const SweepOptions& options, const Group& group) {
    SweepOptions one = options;
    one.scenes = {group.scene};
    one.series.clear();
    one.sizes = {fmt::format("{}x{}", group.width, group.height)};
    one.culls = {group.cull};
    one.camera = group.camera;
    one.light = std::to_string(group.light);
    one.frame = std::to_string(group.frame);
    return one;
}

}  // namespace gno::study
