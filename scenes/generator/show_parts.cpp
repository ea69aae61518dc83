// SPDX-License-Identifier: MIT
#include "scenes/generator/show_parts.hpp"

#include <algorithm>

#include "scenes/generator/glb.hpp"
#include "scenes/generator/shapes.hpp"

namespace gno::scenes {

ShippedProp::ShippedProp(Draft& draft, const std::filesystem::path& models, const std::string& name, const glm::dvec3& anchor, const Paint& paint)
    : draft_(draft), anchor_(anchor) {
    ShippedModel shipped = readShippedModel(models / name / (name + ".glb"));
    std::vector<uint32_t> materials;
    for (const std::string& material : shipped.materialNames) {
        const auto found = std::find_if(paint.begin(), paint.end() - 1, [&](const auto& entry) { return entry.first == material; });
        materials.push_back(draft.material(name + " " + material, found->second));
    }
    for (Model& model : shipped.models) {
        for (Part& part : model.parts) part.material = materials.at(part.material);
        models_.push_back(draft.model(std::move(model)));
    }
}

int ShippedProp::place(const glm::dvec3& position, const glm::dquat& rotation, double size) const {
    return placeWithPivot(position, rotation, size, anchor_, {});
}

int ShippedProp::placeWithPivot(const glm::dvec3& position, const glm::dquat& rotation, double size, const glm::dvec3& pivot,
                                const std::vector<std::string>& names) const {
    const int root = draft_.place(-1, position, rotation, glm::dvec3(0.01 * size));
    const int turning = names.empty() ? root : draft_.place(-1, pivot - anchor_, {1, 0, 0, 0}, glm::dvec3(1), root);
    for (const int model : models_) {
        const std::string& name = draft_.models[static_cast<size_t>(model)].name;
        const bool turns = std::any_of(names.begin(), names.end(), [&](const std::string& start) { return name.starts_with(start); });
        draft_.place(model, turns ? -pivot : -anchor_, {1, 0, 0, 0}, glm::dvec3(1), turns ? turning : root);
    }
    return turning;
}

int placeBoxes(Draft& draft, const std::string& name, uint32_t material, const std::vector<std::pair<glm::dvec3, glm::dvec3>>& boxes) {
    Model model;
    model.name = name;
    for (const auto& [low, high] : boxes) addBox(model.of(material), low, high);
    return draft.placeOnce(std::move(model));
}

}  // namespace gno::scenes
