// SPDX-License-Identifier: MIT
// Thousands of blades that pierce a ground of two large triangles. The ground is the first mesh: in a tree built in file order it is the root.
#include <cmath>

#include "scenes/generator/catalogue.hpp"
#include "scenes/generator/shapes.hpp"

namespace gno::scenes {
namespace {

constexpr double kHalf = 12;  // the ground's half width, metres

void addStones(Draft& draft, Random& random) {
    const uint32_t grey = draft.material("stone", {0.48, 0.47, 0.45});
    Model stone;
    stone.name = "stone";
    addBall(stone.of(grey), {0, 0, 0}, {1, 0.62, 0.8}, 10);
    const int shared = draft.model(std::move(stone));
    for (int i = 0; i < 7; ++i) {
        const double size = random.between(0.12, 0.42);
        const glm::dvec3 foot{random.between(-2.6, 2.6), size * 0.2, random.between(-3.0, 1.8)};
        draft.place(shared, foot, turn({0, 1, 0}, random.between(0, 6)), glm::dvec3(size));
    }
}

// A square metre of the lawn. Roots lie below the ground, so every blade crosses it.
Model tile(uint32_t material, size_t blades, Random& random) {
    Model model;
    model.name = "lawn";
    Mesh& mesh = model.of(material);
    for (size_t i = 0; i < blades; ++i) {
        const double angle = random.between(0, 2 * kPi);
        const glm::dvec3 side(cosine(angle), 0, sine(angle));
        const glm::dvec3 lean(-side.z, 0, side.x);
        const double height = random.between(0.07, 0.26);
        const glm::dvec3 root{random.between(-0.5, 0.5), -0.05, random.between(-0.5, 0.5)};
        const double width = random.between(0.010, 0.022);
        addBlade(mesh, root, {0, height + 0.05, 0}, side, lean * (height * random.between(0.1, 0.75)), width, 3);
    }
    return model;
}

}  // namespace

Draft buildGrass(double detail, uint64_t seed) {
    Random random(seed);
    Draft draft;
    const uint32_t soil = draft.material("soil", {0.46, 0.40, 0.28});
    Model ground;
    ground.name = "ground";
    Mesh& mesh = ground.of(soil);
    const uint32_t a = mesh.vertex({-kHalf, 0, -kHalf});
    const uint32_t b = mesh.vertex({-kHalf, 0, kHalf});
    const uint32_t c = mesh.vertex({kHalf, 0, kHalf});
    const uint32_t d = mesh.vertex({kHalf, 0, -kHalf});
    mesh.quad(a, b, c, d);
    draft.placeOnce(std::move(ground));

    constexpr int kTiles = 6;
    const double perTile = detail * 40000 / 36;
    std::vector<int> tiles;
    for (int i = 0; i < kTiles; ++i) {
        const double hue = random.between(0, 1);
        const uint32_t green = draft.material({.name = "grass", .color = {0.20 + 0.14 * hue, 0.42 + 0.08 * hue, 0.10}, .doubleSided = true});
        tiles.push_back(draft.model(tile(green, static_cast<size_t>(perTile * (0.7 + 0.12 * i)) + 2, random)));
    }
    for (int z = -4; z < 2; ++z)
        for (int x = -3; x < 3; ++x) {
            const int which = tiles[static_cast<size_t>((x + 3 + 2 * (z + 4)) % kTiles)];
            const glm::dvec3 centre{x + 0.5 + random.between(-0.1, 0.1), 0, z + 0.5 + random.between(-0.1, 0.1)};
            draft.place(which, centre, turn({0, 1, 0}, kPi / 2 * random.below(4)));
        }
    addStones(draft, random);

    draft.camera([](double t) { return glm::dvec3(-1.4 + 2.4 * t, 2.5 - 0.5 * t, 2.6 - 0.5 * t); },
                 [](double t) { return glm::dvec3(0.2 * t, 0, -0.4); });
    draft.pointLight({1, 0.95, 0.85}, 3.4, [](double t) { return glm::dvec3(2.4 - 3 * t, 2.4, -2.2 + 0.5 * t); });
    draft.sun({1, 0.96, 0.88}, [](double t) { return glm::dvec3(0.9 - 0.5 * t, 0.8, -0.7); });
    return draft;
}

}  // namespace gno::scenes
