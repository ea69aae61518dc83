// SPDX-License-Identifier: MIT
#include "scenes/generator/catalogue.hpp"
#include "scenes/generator/shapes.hpp"
#include "scenes/generator/show_parts.hpp"

namespace gno::scenes {
namespace {

void addTerrace(Draft& draft, Random& random) {
    const uint32_t earth = draft.material("lawn", {0.30, 0.42, 0.16});
    const uint32_t slab = draft.material("paving", {0.62, 0.56, 0.47});
    const uint32_t plaster = draft.material("plaster", {0.78, 0.70, 0.58});
    const uint32_t wood = draft.material("bench wood", {0.45, 0.28, 0.14});
    placeBoxes(draft, "lawn", earth, {{{-5, -0.3, -2.4}, {5, -0.02, 4.5}}});
    Model paving;
    paving.name = "paving";
    for (int row = 0; row < 9; ++row)
        for (int column = 0; column < 12; ++column) {
            const glm::dvec3 low(-2.95 + column * 0.5 - 0.21 * (row & 1), -0.06, -1.52 + row * 0.5);
            addBox(paving.of(slab), low, low + glm::dvec3(0.48, 0.06 + random.between(0, 0.006), 0.48));
        }
    draft.placeOnce(std::move(paving));
    placeBoxes(draft, "wall", plaster, {{{-5, -0.1, -2.0}, {5, 2.1, -1.75}}, {{-5, 2.05, -2.06}, {5, 2.14, -1.69}}});
    placeBoxes(draft, "bench", wood,
               {{{0.40, 0.40, -0.62}, {1.65, 0.44, -0.46}},
                {{0.40, 0.40, -0.44}, {1.65, 0.44, -0.28}},
                {{0.40, 0.40, -0.26}, {1.65, 0.44, -0.10}},
                {{0.50, 0.01, -0.58}, {0.57, 0.41, -0.14}},
                {{1.48, 0.01, -0.58}, {1.55, 0.41, -0.14}}});
}

}  // namespace

Draft showGarden(const std::filesystem::path& models, uint64_t seed) {
    Random random(seed);
    Draft draft;
    addTerrace(draft, random);

    const ShippedProp plant(draft, models, "plant_decorative", {0.7, 105.145, -0.8},
                            {{"PotMat", {0.60, 0.25, 0.14}},
                             {"GroundMat", {0.12, 0.08, 0.05}},
                             {"Wood", {0.30, 0.19, 0.10}},
                             {"Branches", {0.33, 0.24, 0.12}},
                             {"Leaves", {0.16, 0.40, 0.10}}});
    plant.place({-0.50, 0.004, -0.15}, turn({0, 1, 0}, 0.4), 1.25);

    const ShippedProp fence(draft, models, "fence", {0, -3.39, 0}, {{"Feet", {0.35, 0.33, 0.32}}, {"Material", {0.82, 0.80, 0.74}}});
    fence.place({0.50, 0.004, -1.05}, turn({0, 1, 0}, -0.06), 1.2);

    const ShippedProp flowers(draft, models, "flower_box", {-30.2, 44.218, 1.4},
                              {{"Blume_Weiss", {0.88, 0.86, 0.82}},
                               {"Blume_Staub", {0.85, 0.62, 0.10}},
                               {"Blume_Dotter", {0.80, 0.45, 0.05}},
                               {"Blume_Blatt", {0.18, 0.42, 0.12}},
                               {"Erde", {0.13, 0.09, 0.06}},
                               {"Blumenkasten", {0.42, 0.16, 0.10}}});
    flowers.place({1.03, 0.441, -0.36}, turn({0, 1, 0}, 0.0), 1.7);

    const ShippedProp fan(draft, models, "table_fan", {0, 0, 0}, {{"FAN_BLADE", {0.15, 0.42, 0.60}}, {"BODY", {0.75, 0.76, 0.78}}});
    const glm::dvec3 hub(-0.1065, 26.512, 5.3);
    const int blades = fan.placeWithPivot({0.22, 0.006, 0.62}, turn({0, 1, 0}, 0.5), 1.5, hub, {"FEATHER", "Cylinder.003"});
    const glm::dvec3 atHub = draft.nodes[static_cast<size_t>(blades)].translation;
    draft.animate(blades, false, true, [&](double t) { return Pose{atHub, turn({0, 0, 1}, 2.5 * t)}; });

    draft.camera([](double t) { return glm::dvec3(1.55 - 2.0 * ease(t), 1.55 + 0.25 * t, 2.75); },
                 [](double t) { return glm::dvec3(0.42 - 0.17 * t, 0.42, -0.15); });
    draft.pointLight({1, 0.93, 0.82}, 3.0, [](double t) { return glm::dvec3(-2.4 + 1.3 * ease(t), 2.0 + 0.2 * t, 0.9 + 1.3 * t); });
    draft.sun({1, 0.97, 0.9}, [](double t) { return glm::dvec3(-1.2 + 0.9 * t, 0.8, 0.8); });
    draft.spotLight(
        {0.9, 0.95, 1}, 3.4, 0.62, [](double t) { return glm::dvec3(2.2, 2.6, 1.2 - t); }, [](double) { return glm::dvec3(0.1, 0.3, -0.3); });
    return draft;
}

}  // namespace gno::scenes
