// SPDX-License-Identifier: MIT
#include "scenes/generator/catalogue.hpp"
#include "scenes/generator/shapes.hpp"
#include "scenes/generator/show_parts.hpp"

namespace gno::scenes {
namespace {

void addCrates(Draft& draft, Random& random) {
    const uint32_t pine = draft.material("crate", {0.55, 0.38, 0.20});
    Model crate;
    crate.name = "crate";
    addBox(crate.of(pine), {-0.46, 0.02, -0.46}, {0.46, 0.96, 0.46});
    for (const double x : {-0.5, 0.42})
        for (const double z : {-0.5, 0.42}) addBox(crate.of(pine), {x, 0, z}, {x + 0.08, 1, z + 0.08});
    for (const double y : {0.03, 0.46, 0.89})
        for (const double side : {-0.485, 0.485}) {
            addBox(crate.of(pine), {-0.49, y, side - 0.02}, {0.49, y + 0.08, side + 0.02});
            addBox(crate.of(pine), {side - 0.021, y + 0.001, -0.489}, {side + 0.021, y + 0.081, 0.489});
        }
    const int model = draft.model(std::move(crate));
    const glm::dvec3 piles[] = {{5.2, 0, 2.2},  {6.5, 0, 2.6},   {5.9, 1.21, 2.4},   {4.6, 0, 0.6},  {6.9, 0, 6.6},
                                {-5.6, 0, 9.4}, {-5.0, 0, 10.9}, {-5.4, 1.21, 10.1}, {-6.9, 0, 8.2}, {3.9, 0, 13.6}};
    for (const glm::dvec3& foot : piles)
        draft.place(model, foot + glm::dvec3(0, 0.004, 0), turn({0, 1, 0}, random.between(-0.5, 0.5)), glm::dvec3(1.2));
}

void addYard(Draft& draft) {
    const uint32_t asphalt = draft.material("asphalt", {0.40, 0.39, 0.38});
    const uint32_t paint = draft.material("road paint", {0.80, 0.78, 0.70});
    const uint32_t brick = draft.material("warehouse", {0.50, 0.26, 0.18});
    const uint32_t steel = draft.material("steel", {0.40, 0.42, 0.44});
    placeBoxes(draft, "yard", asphalt, {{{-45, -0.5, -45}, {45, 0, 45}}});
    Model lines;
    lines.name = "lines";
    for (int i = 0; i < 9; ++i) addBox(lines.of(paint), {-3.4, -0.05, -16 + 4.0 * i}, {-3.22, 0.006, -13.6 + 4.0 * i});
    for (int i = 0; i < 9; ++i) addBox(lines.of(paint), {3.3, -0.05, -16 + 4.0 * i}, {3.48, 0.006, -13.6 + 4.0 * i});
    draft.placeOnce(std::move(lines));
    Model house;
    house.name = "warehouse";
    addBox(house.of(brick), {-34, -0.2, -31}, {34, 8, -23});
    for (int i = 0; i < 9; ++i) {
        addBox(house.of(steel), {-31 + 7.0 * i, -0.1, -23.2}, {-26.5 + 7.0 * i, 4.6, -22.9});
        addBox(house.of(brick), {-33 + 7.0 * i, -0.1, -23.3}, {-32.3 + 7.0 * i, 8.3, -22.7});
    }
    draft.placeOnce(std::move(house));
    Model lamp;
    lamp.name = "yard lamp";
    addCylinder(lamp.of(steel), {0, -0.1, 0}, {0, 7, 0}, 0.12, 0.08, 12);
    addCylinder(lamp.of(steel), {-1.4, 6.95, 0}, {1.4, 6.95, 0}, 0.05, 0.05, 8);
    for (const double x : {-1.4, 1.4}) addBox(lamp.of(steel), {x - 0.3, 6.82, -0.15}, {x + 0.3, 6.92, 0.15});
    const int model = draft.model(std::move(lamp));
    for (const glm::dvec3& foot : {glm::dvec3(-7.5, 0, -4), {8.5, 0, -6}, {-8, 0, 14}}) draft.place(model, foot, turn({0, 1, 0}, 0.3 * foot.x));
}

}  // namespace

Draft showTruck(const std::filesystem::path& models, uint64_t seed) {
    Random random(seed);
    Draft draft;
    addYard(draft);
    addCrates(draft, random);
    const ShippedProp truck(draft, models, "truck_peterbilt", {0, -189.33, -646},
                            {{"body", {0.52, 0.05, 0.05}},
                             {"bodyTrailer", {0.66, 0.68, 0.70}},
                             {"metalTrailer", {0.50, 0.52, 0.54}},
                             {"metal", {0.60, 0.60, 0.62}},
                             {"black", {0.05, 0.05, 0.05}},
                             {"blackTrailer", {0.06, 0.06, 0.06}},
                             {"tires", {0.04, 0.04, 0.04}},
                             {"tiresTrailer", {0.04, 0.04, 0.04}},
                             {"glass", {0.10, 0.14, 0.18}},
                             {"reflector", {0.75, 0.38, 0.06}},
                             {"reflectorTrailer", {0.70, 0.15, 0.05}},
                             {"support", {0.22, 0.22, 0.23}}});
    truck.place({-0.4, 0.003, 0}, turn({0, 1, 0}, 0.10), 1.0);
    const ShippedProp fence(draft, models, "fence", {0, -3.39, 0}, {{"Feet", {0.35, 0.33, 0.32}}, {"Material", {0.18, 0.22, 0.20}}});
    fence.place({6.6, 0.003, 9.6}, turn({0, 1, 0}, 0.5), 1.9);
    fence.place({9.6, 0.003, 7.8}, turn({0, 1, 0}, 0.6), 1.9);

    draft.camera([](double t) { return glm::dvec3(10.0 - 3.5 * t, 6.6 - 1.0 * ease(t), 18.5 - 0.8 * t); },
                 [](double t) { return glm::dvec3(1.9 - 0.8 * t, 0.2, 6.6); });
    draft.pointLight({1, 0.85, 0.65}, 9.5, [](double t) { return glm::dvec3(-6.5 + 3.5 * t, 6.8, 13.5 - 5 * t); });
    draft.sun({1, 0.80, 0.55}, [](double t) { return glm::dvec3(-1.0, 0.48 - 0.1 * t, 0.25 + 0.5 * t); });
    draft.spotLight(
        {0.9, 0.93, 1}, 12, 0.7, [](double t) { return glm::dvec3(9, 7 - t, 2); }, [](double t) { return glm::dvec3(1, 0.5, 7 + 3 * t); });
    return draft;
}

}  // namespace gno::scenes
