// SPDX-License-Identifier: MIT
// Thin bars close to the camera, trees and ground far behind them: depth jumps at every bar.
#include <algorithm>
#include <cmath>

#include "scenes/generator/catalogue.hpp"
#include "scenes/generator/shapes.hpp"
#include "scenes/generator/trees.hpp"

namespace gno::scenes {
namespace {

constexpr double kLeaf = 1.7;  // width of one leaf of the gate, metres

void addScroll(Mesh& mesh, const glm::dvec3& centre, double size, double hand, int steps, int sides) {
    Path path;
    for (int i = 0; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        const double angle = 2.3 * 2 * kPi * t;
        const double radius = size * (0.12 + 0.88 * t);
        path.push_back(centre + glm::dvec3(hand * radius * cosine(angle), radius * sine(angle), 0));
    }
    addTaperedTube(mesh, path, 0.006, 0.012, sides);
}

// One leaf, hinged at x = 0, reaching to x = kLeaf.
Model gateLeaf(uint32_t iron, uint32_t gold, int sides) {
    Model model;
    model.name = "gate leaf";
    Mesh bars;
    Mesh tips;
    for (const double y : {0.15, 0.95, 1.15, 2.0}) addBox(bars, {0, y, -0.02}, {kLeaf, y + 0.035, 0.02});
    const int count = 13;
    for (int i = 0; i <= count; ++i) {
        const double x = 0.04 + (kLeaf - 0.08) * i / count;
        const double top = 2.15 + 0.35 * sine(kPi / 2 * i / count);
        addCylinder(bars, {x, 0.08, 0}, {x, top, 0}, 0.013, 0.013, sides);
        addLathe(tips, {{0, 0}, {0.02, 0.015}, {0.016, 0.05}, {0.028, 0.09}, {0.012, 0.15}, {0, 0.2}}, sides, at({x, top - 0.01, 0}));
        if (i == count) continue;
        const double between = x + (kLeaf - 0.08) / count / 2;
        addCylinder(bars, {between, 0.1, 0}, {between, 0.97, 0}, 0.008, 0.008, sides);
        addTube(bars, arcPath({between, 1.065, 0}, {0.045, 0, 0}, {0, 0.045, 0}, 0, 2 * kPi, 3 * sides), 0.007, sides, true);
        addScroll(bars, {between, 1.32 + 0.06 * (i & 1), 0.004}, 0.052, (i & 1) ? 1 : -1, 6 * sides, std::max(4, sides - 2));
        addScroll(bars, {between, 1.76 - 0.06 * (i & 1), -0.004}, 0.052, (i & 1) ? -1 : 1, 6 * sides, std::max(4, sides - 2));
    }
    model.of(iron) = std::move(bars);
    model.of(gold) = std::move(tips);
    return model;
}

void addWalls(Draft& draft) {
    const uint32_t stone = draft.material("stone", {0.66, 0.60, 0.50});
    const uint32_t gravel = draft.material("gravel", {0.56, 0.51, 0.41});
    const uint32_t lawn = draft.material("lawn", {0.28, 0.42, 0.14});
    const uint32_t villa = draft.material("villa", {0.80, 0.66, 0.50});
    Model ground;
    ground.name = "ground";
    addBox(ground.of(lawn), {-40, -0.6, -55}, {40, 0, 14});
    addBox(ground.of(gravel), {-2.1, -0.5, -30}, {2.1, 0.015, 13.5});
    draft.placeOnce(std::move(ground));
    Model wall;
    wall.name = "wall";
    for (const double side : {-1.0, 1.0}) {
        auto box = [&](double near, double far, double low, double high, double half) {
            addBox(wall.of(stone), {std::min(side * near, side * far), low, -half}, {std::max(side * near, side * far), high, half});
        };
        box(1.76, 2.30, -0.1, 2.45, 0.27);
        box(1.70, 2.36, 2.44, 2.56, 0.33);
        box(2.28, 9.0, -0.1, 0.7, 0.16);
        addBall(wall.of(stone), {side * 2.03, 2.76, 0}, glm::dvec3(0.22), 16);
    }
    draft.placeOnce(std::move(wall));
    Model house;
    house.name = "villa";
    addBox(house.of(villa), {-9, -0.2, -38}, {9, 7, -30});
    addGable(house.of(stone), {-9.6, 7, -38.5}, {9.6, 10, -29.5});
    for (int i = 0; i < 14; ++i) {
        const double x = -7.9 + 2.4 * (i % 7);
        const double y = i < 7 ? 0.9 : 4.1;
        addBox(house.of(stone), {x, y, -30.1}, {x + 1.3, y + 2.1, -29.85});
    }
    draft.placeOnce(std::move(house));
}

}  // namespace

Draft buildGate(double detail, uint64_t seed) {
    Random random(seed);
    Draft draft;
    addWalls(draft);
    const uint32_t iron = draft.material("iron", {0.10, 0.11, 0.12});
    const uint32_t gold = draft.material("gilding", {0.72, 0.52, 0.16});
    const int sides = std::clamp(static_cast<int>(6 * std::sqrt(detail)), 3, 12);
    const int leaf = draft.model(gateLeaf(iron, gold, sides));
    const glm::dquat mirrored = turn({0, 1, 0}, kPi);
    const int left = draft.place(leaf, {-kLeaf - 0.03, 0, 0});
    const int right = draft.place(leaf, {kLeaf + 0.03, 0, 0}, mirrored);
    draft.animate(left, false, true, [](double t) { return Pose{glm::dvec3(0), turn({0, 1, 0}, 0.02 + 0.75 * ease(t))}; });
    draft.animate(right, false, true, [&](double t) { return Pose{glm::dvec3(0), turn({0, 1, 0}, -0.02 - 0.55 * ease(t)) * mirrored}; });
    Model fence;
    fence.name = "railing";
    Mesh& bars = fence.of(iron);
    for (int i = 0; i < 96; ++i) {
        const double side = i < 48 ? -1 : 1;
        const double x = side * (2.4 + 0.135 * (i % 48));
        addCylinder(bars, {x, 0.6, 0}, {x, 1.95, 0}, 0.012, 0.012, sides);
    }
    for (const double side : {-1.0, 1.0})
        for (const double y : {0.85, 1.75}) addCylinder(bars, {side * 2.2, y, 0}, {side * 8.9, y, 0}, 0.018, 0.018, sides);
    draft.placeOnce(std::move(fence));

    const double left4trees = detail * 100000 - static_cast<double>(draft.triangleCount());
    constexpr int kTrees = 14;
    const auto perTree = static_cast<size_t>(std::max(260.0, left4trees / kTrees));
    const uint32_t bark = draft.material("bark", {0.26, 0.19, 0.12});
    std::vector<int> trees;
    for (int i = 0; i < 4; ++i) {
        const uint32_t green = draft.material("leaves", {0.16 + 0.05 * i, 0.38 - 0.02 * i, 0.10});
        trees.push_back(draft.model(makeTree(bark, green, 5.0 + 0.8 * i, perTree, random)));
    }
    for (int i = 0; i < kTrees; ++i) {
        const double side = (i & 1) ? 1 : -1;
        const glm::dvec3 foot{side * random.between(3.2, 4.2 + 0.35 * i), 0, -3.0 - 1.75 * i + random.between(-0.5, 0.5)};
        const int tree = trees[random.below(4)];
        const double heading = random.between(0, 6);
        draft.place(tree, foot, turn({0, 1, 0}, heading), glm::dvec3(random.between(0.85, 1.2)));
    }

    draft.camera([](double t) { return glm::dvec3(-1.1 + 1.6 * t, 2.15, 3.5 - 0.9 * ease(t)); },
                 [](double t) { return glm::dvec3(0.1 + 0.1 * t, 0.75, -1.2); });
    draft.pointLight({1, 0.9, 0.75}, 5.2, [](double t) { return glm::dvec3(2.6 - 3.4 * t, 4.3, -4.6); });
    draft.sun({1, 0.95, 0.85}, [](double t) { return glm::dvec3(0.7 - 0.8 * t, 0.75, -0.9); });
    return draft;
}

}  // namespace gno::scenes
