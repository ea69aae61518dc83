// SPDX-License-Identifier: MIT
#include "viz/charts/palette.hpp"

#include <set>

namespace gno::viz {
namespace {

constexpr std::array<Color, 14> kColors{{{0, 114, 178},
                                         {213, 94, 0},
                                         {0, 158, 115},
                                         {204, 121, 167},
                                         {230, 159, 0},
                                         {86, 180, 233},
                                         {0, 0, 0},
                                         {204, 187, 119},
                                         {0, 17, 136},
                                         {85, 0, 68},
                                         {0, 0, 255},
                                         {187, 85, 255},
                                         {170, 0, 51},
                                         {120, 120, 120}}};

uint32_t hashOf(const std::string& name) {  // FNV-1a
    uint32_t hash = 2166136261u;
    for (const char c : name) hash = (hash ^ uint8_t(c)) * 16777619u;
    return hash;
}

}  // namespace

std::map<std::string, Color> colorsOf(std::span<const std::string> names) {
    std::map<std::string, Color> colors;
    std::set<size_t> taken;
    for (const std::string& name : std::set<std::string>(names.begin(), names.end())) {
        size_t index = hashOf(name) % kColors.size();
        if (taken.size() == kColors.size()) taken.clear();
        while (taken.contains(index)) index = (index + 1) % kColors.size();
        taken.insert(index);
        colors[name] = kColors[index];
    }
    return colors;
}

}  // namespace gno::viz
