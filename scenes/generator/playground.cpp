// SPDX-License-Identifier: MIT
// Bars, nets, chains, large smooth slides and trees in one small place: shadows of every complexity.
#include <algorithm>
#include <cmath>

#include "scenes/generator/catalogue.hpp"
#include "scenes/generator/play_structures.hpp"
#include "scenes/generator/shapes.hpp"
#include "scenes/generator/trees.hpp"

namespace gno::scenes {
namespace {

void addGround(Draft& draft) {
    const uint32_t lawn = draft.material("lawn", {0.36, 0.46, 0.18});
    const uint32_t sand = draft.material("sand", {0.76, 0.66, 0.46});
    const uint32_t rubber = draft.material("rubber", {0.58, 0.36, 0.28});
    const uint32_t kerb = draft.material("kerb", {0.60, 0.58, 0.55});
    Model ground;
    ground.name = "ground";
    addBox(ground.of(lawn), {-26, -0.5, -24}, {26, 0, 16});
    addBox(ground.of(sand), {-3.4, -0.4, -3.6}, {5.1, 0.012, 2.3});
    addBox(ground.of(rubber), {-9.6, -0.4, -2.9}, {-4.3, 0.014, 3.4});
    for (const double z : {-3.75, 2.45}) addBox(ground.of(kerb), {-3.71, -0.3, z - 0.12}, {5.41, 0.11, z + 0.12});
    for (const double x : {-3.55, 5.25}) addBox(ground.of(kerb), {x - 0.13, -0.31, -3.86}, {x + 0.13, 0.105, 2.56});
    draft.placeOnce(std::move(ground));
}

void addFence(Draft& draft, uint32_t wood, int sides) {
    Model panel;
    panel.name = "fence panel";
    for (int i = 0; i < 12; ++i)
        addCylinder(panel.of(wood), {-1.1 + 0.2 * i, 0.04, 0}, {-1.1 + 0.2 * i, 1.0 + 0.07 * (i & 1), 0}, 0.03, 0.026, sides);
    for (const double y : {0.3, 0.8}) addBox(panel.of(wood), {-1.2, y, -0.05}, {1.2, y + 0.08, -0.01});
    const int model = draft.model(std::move(panel));
    for (int i = -5; i <= 5; ++i) draft.place(model, {2.42 * i, 0, -7.5});
    for (int i = 0; i < 5; ++i) {
        draft.place(model, {-13.4, 0, -6.2 + 2.42 * i}, turn({0, 1, 0}, kPi / 2));
        draft.place(model, {13.4, 0, -6.2 + 2.42 * i}, turn({0, 1, 0}, kPi / 2));
    }
}

}  // namespace

Draft buildPlayground(double detail, uint64_t seed) {
    Random random(seed);
    Draft draft;
    addGround(draft);
    const PlayPaints paints{draft.material("wood", {0.52, 0.34, 0.18}),   draft.material("red", {0.66, 0.10, 0.08}),
                            draft.material("yellow", {0.80, 0.60, 0.08}), draft.material("blue", {0.10, 0.28, 0.60}),
                            draft.material("steel", {0.55, 0.57, 0.60}),  draft.material("rope", {0.70, 0.60, 0.42})};
    const int sides = std::clamp(static_cast<int>(8 * std::sqrt(detail)), 4, 20);
    addFence(draft, paints.wood, std::min(sides, 8));
    draft.place(draft.model(playTower(paints, sides)), {-1.6, 0, -1.3}, turn({0, 1, 0}, 0.2));
    draft.place(draft.model(climbingDome(paints, sides)), {3.2, 0.02, 0.4});
    draft.place(draft.model(monkeyBars(paints, sides)), {-7.0, 0, -1.7}, turn({0, 1, 0}, 0.2));
    const glm::dvec3 swings(-0.6, 0, -5.6);
    draft.place(draft.model(swingFrame(paints, sides)), swings);
    const int seat = draft.model(swingSeat(paints, sides));
    for (int i = 0; i < 2; ++i) {
        const glm::dvec3 hook = swings + glm::dvec3(i == 0 ? -0.9 : 0.9, 2.4, 0);
        const int swing = draft.place(seat, hook);
        draft.animate(swing, false, true, [&](double t) { return Pose{hook, turn({1, 0, 0}, 0.6 * sine(2 * kPi * t * 0.8 + 2.2 * i))}; });
    }
    const int rider = draft.model(springRider(paints, paints.red, sides));
    for (int i = 0; i < 3; ++i) draft.place(rider, {-5.3 - 1.5 * i, 0, 1.3 + 0.5 * (i & 1)}, turn({0, 1, 0}, 0.8 * i));
    const glm::dvec3 hub(7.6, 0, 0.4);
    const int round = draft.place(draft.model(merryGoRound(paints, sides)), hub);
    draft.animate(round, false, true, [&](double t) { return Pose{hub, turn({0, 1, 0}, 1.6 * t)}; });
    const glm::dvec3 pivot(5.4, 0.1, -5.6);
    const int plank = draft.place(draft.model(seesaw(paints, sides)), pivot);
    draft.animate(plank, false, true, [&](double t) { return Pose{pivot, turn({0, 0, 1}, 0.12 * cosine(2 * kPi * t))}; });
    const int bench = draft.model(parkBench(paints));
    draft.place(bench, {9.6, 0, -3.4}, turn({0, 1, 0}, -0.9));
    draft.place(bench, {-10.6, 0, 2.6}, turn({0, 1, 0}, 1.4));
    draft.place(bench, {1.4, 0, 4.2}, turn({0, 1, 0}, kPi));

    constexpr int kTrees = 9;
    const double left = detail * 131000 - static_cast<double>(draft.triangleCount());
    const auto perTree = static_cast<size_t>(std::max(260.0, left / kTrees));
    const uint32_t bark = draft.material("bark", {0.26, 0.19, 0.12});
    const glm::dvec2 feet[kTrees] = {{-4.2, -6.4}, {3.2, -6.6},   {8.9, -6.0}, {-9.4, -5.2}, {-11.2, 0.2},
                                     {11.0, -0.6}, {-15.5, -9.5}, {0.3, -11},  {14.5, -9.8}};
    for (int i = 0; i < 3; ++i) {
        const uint32_t green = draft.material("leaves", {0.20 + 0.08 * i, 0.42 - 0.03 * i, 0.10});
        const int tree = draft.model(makeTree(bark, green, 4.4 + 0.7 * i, perTree, random));
        for (int k = i; k < kTrees; k += 3) {
            const double heading = random.between(0, 6);
            draft.place(tree, {feet[k].x, 0, feet[k].y}, turn({0, 1, 0}, heading), glm::dvec3(random.between(0.85, 1.15)));
        }
    }

    draft.camera([](double t) { return glm::dvec3(9.5 * sine(0.55 - 1.0 * t), 7.4 - 1.4 * t, 9.6 * cosine(0.55 - 1.0 * t)); },
                 [](double t) { return glm::dvec3(0.2 - 0.6 * t, 0.1, -1.0); });
    draft.pointLight({1, 0.93, 0.82}, 8.5, [](double t) { return glm::dvec3(-8.0 + 5.0 * ease(t), 6.2, 1.5 - 2.5 * t); });
    draft.sun({1, 0.95, 0.85}, [](double t) { return glm::dvec3(-0.9 + 0.8 * t, 0.85, -0.45); });
    return draft;
}

}  // namespace gno::scenes
