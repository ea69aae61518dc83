// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "host_min/error.hpp"
#include "host_min/techniques/clusters.hpp"
#include "host_min/techniques/forest.hpp"
#include "host_min/techniques/light_bvh.hpp"
#include "host_min/techniques/light_grid.hpp"
#include "host_min/techniques/ray_query.hpp"
#include "host_min/techniques/shadow_map.hpp"
#include "host_min/techniques/technique.hpp"
#include "host_min/techniques/top.hpp"

namespace gno::host {

const std::vector<std::unique_ptr<Technique>>& techniques() {
    static const auto list = [] {
        std::vector<std::unique_ptr<Technique>> made;
        for (const auto name : {TopTechniqueName::psv, TopTechniqueName::dPsv, TopTechniqueName::dStackless, TopTechniqueName::dHybrid})
            made.push_back(makeTopTechnique(name));
        made.push_back(makeClusterTechnique(false));
        made.push_back(makeClusterTechnique(true));
        made.push_back(makeForestTechnique());
        made.push_back(makeLightBvhTechnique());
        made.push_back(makeLightGridTechnique());
        made.push_back(makeShadowMapTechnique());
        made.push_back(makeRayQueryTechnique());
        return made;
    }();
    return list;
}

std::string missingFor(const TechniqueInfo& info, const DeviceFacts& device) {
    if (info.rayQuery && !device.rayQuery)
        return "VkPhysicalDeviceRayQueryFeaturesKHR::rayQuery with accelerationStructure and bufferDeviceAddress (VK_KHR_ray_query)";
    return info.subgroupBallot && !device.subgroupBallot
               ? "VkPhysicalDeviceSubgroupProperties::supportedOperations: VK_SUBGROUP_FEATURE_BALLOT_BIT in compute shaders"
               : "";
}

const std::vector<std::pair<std::string, std::string>>& plannedTechniques() {
    static const std::vector<std::pair<std::string, std::string>> list{{"zpass", "stencil shadow volumes, depth pass"},
                                                                       {"zfail", "stencil shadow volumes, depth fail"},
                                                                       {"zp+", "stencil shadow volumes, ZP+"},
                                                                       {"++zp", "stencil shadow volumes, ++ZP"},
                                                                       {"atomic-zp", "stencil shadow volumes, AtomicZP 2019"}};
    return list;
}

Technique& techniqueByName(const std::string& name) {
    std::vector<std::string> names;
    for (const auto& technique : techniques()) {
        if (technique->info().name == name) return *technique;
        names.push_back(technique->info().name);
    }
    for (const auto& [planned, what] : plannedTechniques())
        if (planned == name)
            throw InputError(fmt::format("technique {} ({}) is not in this build yet; there are: {}", name, what, fmt::join(names, ", ")));
    throw InputError(fmt::format("no technique is called {}; there are: {}", name, fmt::join(names, ", ")));
}

const std::vector<SettingInfo>& frameSettings() {
    static const std::vector<SettingInfo> list{
        {"cull",
         "casters left out: front (those of closed meshes that face the light), hull (outside the hull of view and light)",
         0,
         0,
         {"none", "front", "hull", "all"},
         "none"},
        {"grid",
         "a picture that snapping positions to the grid moves by a pixel or more: refuse it (strict) or shade it (anyway)",
         0,
         0,
         {"strict", "anyway"},
         "strict"}};
    return list;
}

const char* name(Precision precision) {
    switch (precision) {
        case Precision::published:
            return "published";
        case Precision::conservative:
            return "conservative";
        case Precision::certified:
            return "certified";
    }
    return "";
}

Precision precisionByName(const std::string& text) {
    for (const Precision precision : {Precision::published, Precision::conservative, Precision::certified})
        if (text == name(precision)) return precision;
    throw InputError(fmt::format("--precision {}: must be published, conservative or certified", text));
}

}  // namespace gno::host
