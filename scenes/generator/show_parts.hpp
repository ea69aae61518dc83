// SPDX-License-Identifier: MIT
// What the shows share: shipped models as painted nodes, and scenery of boxes.
#pragma once
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "scenes/generator/draft.hpp"

namespace gno::scenes {

/// Linear base colours by material name; the shipped files have none. The last entry is for all names that are not listed.
using Paint = std::vector<std::pair<std::string, glm::dvec3>>;

/// A shipped model in the draft: read once, placed as often as wanted.
class ShippedProp {
public:
    /// `anchor` is the point of the file (centimetres, y up) that is put where a copy is placed.
    ShippedProp(Draft& draft, const std::filesystem::path& models, const std::string& name, const glm::dvec3& anchor, const Paint& paint);

    /// One node with all meshes below it. `size` scales after centimetres became metres.
    int place(const glm::dvec3& position, const glm::dquat& rotation = {1, 0, 0, 0}, double size = 1) const;
    /// As `place`; the meshes whose name begins with one of `names` hang below a node at `pivot` (in the file's units), which is returned.
    int placeWithPivot(const glm::dvec3& position, const glm::dquat& rotation, double size, const glm::dvec3& pivot,
                       const std::vector<std::string>& names) const;

private:
    Draft& draft_;
    glm::dvec3 anchor_;
    std::vector<int> models_;
};

/// A model of one material made of boxes: pairs of low and high corner.
int placeBoxes(Draft& draft, const std::string& name, uint32_t material, const std::vector<std::pair<glm::dvec3, glm::dvec3>>& boxes);

}  // namespace gno::scenes
