// SPDX-License-Identifier: MIT
#include <cmath>

#include "scenes/generator/catalogue.hpp"
#include "scenes/generator/shapes.hpp"
#include "scenes/generator/show_parts.hpp"

namespace gno::scenes {
namespace {

void addCorner(Draft& draft) {
    const uint32_t boards = draft.material("floor boards", {0.50, 0.36, 0.22});
    const uint32_t plaster = draft.material("plaster", {0.74, 0.72, 0.66});
    const uint32_t cupboard = draft.material("cupboard", {0.42, 0.50, 0.52});
    const uint32_t top = draft.material("worktop", {0.62, 0.58, 0.52});
    Model floor;
    floor.name = "floor";
    for (int i = 0; i < 48; ++i) addBox(floor.of(boards), {-3 + 0.25 * i, -0.2, -3}, {-3 + 0.25 * i + 0.245, -0.001 * (i % 3), 7});
    draft.placeOnce(std::move(floor));
    placeBoxes(draft, "walls", plaster,
               {{{-3.3, -0.2, -3.3}, {-2.99, 4.6, 7}}, {{-3.2, -0.2, -3.29}, {9, 4.6, -2.98}}, {{-2.98, 0.01, -2.97}, {9, 0.1, -2.95}}});
    Model kitchen;
    kitchen.name = "kitchen";
    for (int i = 0; i < 4; ++i) {
        const double z = -0.3 + 0.62 * i;
        addBox(kitchen.of(cupboard), {-2.97, 0.08, z}, {-2.38, 0.86, z + 0.6});
        addBox(kitchen.of(top), {-2.385, 0.72, z + 0.15}, {-2.34, 0.74, z + 0.45});
    }
    addBox(kitchen.of(top), {-2.98, 0.865, -0.33}, {-2.33, 0.905, 2.2});
    draft.placeOnce(std::move(kitchen));
}

}  // namespace

Draft showStairs(const std::filesystem::path& models, uint64_t) {
    Draft draft;
    addCorner(draft);
    const ShippedProp stairs(draft, models, "spiral_staircase", {6.5, 0, -8.3},
                             {{"Baluster", {0.16, 0.16, 0.17}}, {"Handrail", {0.42, 0.24, 0.12}}, {"Tread", {0.62, 0.44, 0.26}}});
    stairs.place({-1.25, 0.003, -1.55}, turn({0, 1, 0}, 0.9), 1.15);
    const ShippedProp crib(draft, models, "crib", {0.15, -41.619, -39},
                           {{"White", {0.80, 0.78, 0.74}}, {"Mattress", {0.30, 0.46, 0.62}}, {"Bottom", {0.55, 0.40, 0.26}}});
    crib.place({1.55, 0.003, -1.75}, turn({0, 1, 0}, 1.2), 1.35);
    const ShippedProp football(draft, models, "table_football", {1.1, -40.082, -0.2},
                               {{"player_red", {0.62, 0.08, 0.07}},
                                {"player_blue", {0.08, 0.20, 0.55}},
                                {"red_plastic", {0.62, 0.10, 0.08}},
                                {"blue_plastic", {0.10, 0.22, 0.55}},
                                {"black_plastic", {0.05, 0.05, 0.05}},
                                {"metal", {0.62, 0.63, 0.65}},
                                {"wood", {0.36, 0.22, 0.11}},
                                {"ball", {0.85, 0.85, 0.80}},
                                {"pitch", {0.16, 0.42, 0.16}}});
    football.place({1.15, 0.003, 0.75}, turn({0, 1, 0}, 0.35), 1.1);
    const ShippedProp cooktop(
        draft, models, "cooktop", {29, 0, 25.7},
        {{"cooktop_main", {0.08, 0.08, 0.09}}, {"cooktop_main_001", {0.45, 0.45, 0.46}}, {"cooktop_burner", {0.30, 0.30, 0.31}}});
    cooktop.place({-2.65, 0.906, 0.85}, turn({0, 1, 0}, kPi / 2), 1.0);

    const uint32_t rubber = draft.material("ball", {0.75, 0.35, 0.08});
    Model ball;
    ball.name = "ball";
    addBall(ball.of(rubber), {0, 0, 0}, glm::dvec3(0.16), 24);
    const int rolling = draft.place(draft.model(std::move(ball)), {});
    draft.animate(rolling, true, true, [](double t) {
        const double bounce = 0.45 * std::abs(cosine(2.5 * kPi * t)) * (1 - 0.7 * t);
        return Pose{{-0.9 + 1.1 * t, 0.165 + bounce, 1.9 - 0.3 * t}, turn({0, 0, 1}, -4 * t)};
    });

    draft.yfov = 0.85;
    draft.camera([](double t) { return glm::dvec3(3.4 - 2.2 * ease(t), 2.7 + 0.5 * t, 4.6); },
                 [](double t) { return glm::dvec3(-0.05 - 0.2 * t, 1.05, -0.8); });
    draft.pointLight({1, 0.92, 0.8}, 3.6, [](double t) { return glm::dvec3(2.3 - 2.2 * t, 3.1, 2.0 - 0.6 * sine(kPi * t)); });
    draft.sun({1, 0.97, 0.92}, [](double t) { return glm::dvec3(0.8 - 0.5 * t, 0.9, 0.8); });
    draft.spotLight(
        {0.95, 0.95, 1}, 4.2, 0.6, [](double t) { return glm::dvec3(-0.6 + 2 * t, 4.2, 2.8); }, [](double) { return glm::dvec3(-0.6, 0.8, -0.8); });
    return draft;
}

}  // namespace gno::scenes
