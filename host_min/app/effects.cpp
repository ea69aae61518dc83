// SPDX-License-Identifier: MIT
#include "host_min/app/effects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "host_min/scene/notices.hpp"
#include "host_min/scene/one_line.hpp"

namespace gno::host {
namespace {

const char* kindName(Light::Kind kind) {
    switch (kind) {
        case Light::Kind::point:
            return "point_light";
        case Light::Kind::directional:
            return "directional_light";
        case Light::Kind::spot:
            return "spot_light";
    }
    return "";
}

const char* switchedOnBy(Light::Kind kind) {
    switch (kind) {
        case Light::Kind::point:
            return "light with w = 1: planes through the light, bands relative to the distance from it";
        case Light::Kind::directional:
            return "light with w = 0: planes along the direction, bands relative to the scene's radius";
        case Light::Kind::spot:
            return "light with w = 1; the cone belongs to shading";
    }
    return "";
}

}  // namespace

std::vector<Effect> effectsOf(const SceneFile& file, const Frame& frame, int light) {
    std::vector<Effect> effects;
    for (const Light::Kind kind : {Light::Kind::point, Light::Kind::directional, Light::Kind::spot}) {
        uint64_t count = 0, defaults = 0;
        for (size_t i = 0; i < frame.lights.size(); ++i) {
            if (light >= 0 && i != size_t(light)) continue;
            count += frame.lights[i].kind == kind;
            defaults += frame.lights[i].kind == kind && frame.lights[i].isDefault;
        }
        if (count > 0)
            effects.push_back({kindName(kind),
                               fmt::format("{}{}", counted(count, "such light"), defaults ? " (made by us: the scene has none)" : ""),
                               switchedOnBy(kind)});
    }
    const uint64_t triangles = frame.triangles.size(), closed = frame.facts.closedTriangles;
    if (closed > 0)
        effects.push_back({"closed_casters", fmt::format("{} of {} in closed, consistently oriented meshes", closed, counted(triangles, "triangle")),
                           "--set cull=front may drop those of them that face the light"});
    if (closed < triangles)
        effects.push_back({"open_casters", fmt::format("{} of {} in others", triangles - closed, counted(triangles, "triangle")),
                           "they cast from both sides and are never dropped by cull=front"});
    uint64_t mask = 0, coloured = 0;
    for (const Surface& surface : frame.surfaces) {
        const Material& material = frame.look->materials[surface.material];
        mask += material.alpha == Material::Alpha::mask;
        coloured += material.alpha == Material::Alpha::blend || material.transmission > 0;
    }
    constexpr const char* kByMaterial =
        "techniques with this effect look up material and texture where the light crosses a caster; others take it for opaque";
    if (mask > 0)
        effects.push_back({"alpha_tested_casters", fmt::format("{} with an alpha-tested material", counted(mask, "triangle")), kByMaterial});
    if (coloured > 0)
        effects.push_back(
            {"coloured_casters", fmt::format("{} with a blended or transmitting material", counted(coloured, "triangle")), kByMaterial});
    if (frame.facts.animations > 0)
        effects.push_back({"animation",
                           fmt::format("{}, {} applied, last keyframe at {:.2f} s", counted(frame.facts.animations, "animation"),
                                       file.clip() ? fmt::format("number {}", *file.clip()) : "all of them", file.lastKeyframe()),
                           "casters, camera and lights are evaluated anew for every --frame; structures are rebuilt every frame"});
    if (frame.facts.skins > 0) effects.push_back({"skins", counted(frame.facts.skins, "skin"), "vertices are skinned on the CPU"});
    if (frame.facts.morphTargets > 0)
        effects.push_back({"morph_targets", counted(frame.facts.morphTargets, "morph target"), "vertices are morphed on the CPU"});
    return effects;
}

namespace {

Choice bestFor(const Frame& frame, Precision precision) {
    if (!frame.surfaces.empty())
        return {&techniqueByName("ptsv"), fmt::format("ptsv: {} of {} alpha-tested or coloured, which the faster forest takes for opaque",
                                                      frame.surfaces.size(), counted(frame.triangles.size(), "caster"))};
    if (precision == Precision::published)
        return {&techniqueByName("d-hybrid"), fmt::format("d-hybrid: {}, precision published, which the faster forest does not have: of the "
                                                          "published queries it visits fewest nodes without the risk "
                                                          "of a full stack",
                                                          counted(frame.triangles.size(), "caster"))};
    return {&techniqueByName("forest"), fmt::format("forest: {}, precision {}: in our measurements it took less time than d-hybrid in every "
                                                    "scene, build and query together, and its worst sample stays "
                                                    "near the mean, unlike that of the lists of light-grid",
                                                    counted(frame.triangles.size(), "caster"), name(precision))};
}

/// Those that answer for every scene, the best first. For casters that are not opaque, those come first that know of them.
std::vector<Technique*> inOrder(const Frame& frame, Precision precision) {
    std::vector<const char*> names{"forest", "d-hybrid", "light-grid", "ptsv", "light-bvh", "d-stackless", "d-psv", "psv", "ptsv-2011"};
    if (!frame.surfaces.empty()) names.insert(names.begin(), {"ptsv", "ptsv-2011"});
    std::vector<Technique*> order{bestFor(frame, precision).technique};
    for (const char* name : names) {
        Technique* technique = &techniqueByName(name);
        const auto& rungs = technique->info().precisions;
        if (std::find(rungs.begin(), rungs.end(), precision) == rungs.end()) continue;
        if (std::find(order.begin(), order.end(), technique) == order.end()) order.push_back(technique);
    }
    return order;
}

/// Why it cannot be asked; empty: it can.
std::string obstacle(const Technique& technique, const Frame& frame, const ChoiceFacts& facts) {
    const TechniqueInfo& info = technique.info();
    if (facts.refused.contains(&technique)) return "it refused";
    const std::string missing = missingFor(info, facts.device);
    if (!missing.empty()) return "the device lacks " + missing;
    return technique.overLimit(facts.device, {frame.triangles.size(), facts.width, facts.height, !frame.surfaces.empty()},
                               Settings(info.settings, facts.settings));
}

}  // namespace

Choice chooseAutomatically(const Frame& frame, Precision precision, const ChoiceFacts& facts) {
    const Choice best = bestFor(frame, precision);
    const std::string why = obstacle(*best.technique, frame, facts);
    if (why.empty()) return best;
    for (Technique* next : inOrder(frame, precision)) {
        if (!obstacle(*next, frame, facts).empty()) continue;
        const auto& effects = next->info().effects;
        const bool opaque = !frame.surfaces.empty() && std::find(effects.begin(), effects.end(), "alpha_tested_casters") == effects.end();
        return {next, fmt::format("{}: {} would be better here, but {}{}", next->info().name, best.technique->info().name, why,
                                  opaque ? "; alpha-tested and coloured casters are taken for opaque" : "")};
    }
    return {nullptr, fmt::format("no technique holds this scene on this device; {}: {}", best.technique->info().name, why)};
}

void printNotices(const std::vector<std::string>& notices, std::set<std::string, std::less<>>& told) {
    for (const std::string& notice : notices)
        if (told.emplace(subjectOf(notice)).second) fmt::print("note: {}\n", notice);
}

void printEffects(const SceneFile& file, const Frame& frame, bool quiet) {
    fmt::print("{}: {} in {}, {}, {}\n", oneLine(file.path().string()), counted(frame.triangles.size(), "triangle"),
               counted(frame.facts.objects, "object"), counted(frame.lights.size(), "light"), counted(file.cameraCount(), "camera"));
    if (frame.facts.duplicates > 0) fmt::print("{} there twice: kept\n", counted(frame.facts.duplicates, "triangle"));
    const auto oneSided = static_cast<uint64_t>(std::count(frame.oneSided.begin(), frame.oneSided.end(), uint8_t{1}));
    if (oneSided > 0)
        fmt::print("{} (doubleSided is false): the camera sees their fronts only; they cast from both sides\n",
                   counted(oneSided, "one-sided triangle"));
    std::set<std::string, std::less<>> told;
    if (!quiet) printNotices(frame.facts.notices, told);
    const std::vector<Clip> clips = file.clips();
    for (size_t i = 0; i < clips.size(); ++i)
        fmt::print("animation {}{} ends at {:.2f} s{}\n", i, clips[i].name.empty() ? "" : " (" + clips[i].name + ")", clips[i].lastKeyframe,
                   !file.clip() || *file.clip() == i ? ", applied" : "");
    for (const Effect& effect : effectsOf(file, frame, -1))
        fmt::print("{:20} {}\n{:20} -> {}\n", effect.name, effect.because, "", effect.switchesOn);
    fmt::print("auto would run {}\n", chooseAutomatically(frame, Precision::certified).why);
}

}  // namespace gno::host
