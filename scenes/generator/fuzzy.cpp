// SPDX-License-Identifier: MIT
// Fur: very dense small casters on balls and on a rug.
#include <cmath>

#include "scenes/generator/catalogue.hpp"
#include "scenes/generator/shapes.hpp"

namespace gno::scenes {
namespace {

constexpr int kParts = 2;  // 3 triangles a hair

// `lengths` and `widths` are ranges.
void addHair(Mesh& mesh, const glm::dvec3& root, const glm::dvec3& normal, const glm::dvec2& lengths, const glm::dvec2& widths, Random& random) {
    const double length = random.between(lengths.x, lengths.y);
    const double width = random.between(widths.x, widths.y);
    const glm::dvec3 random3 = random.direction();
    const glm::dvec3 side =
        glm::normalize(glm::cross(normal, std::abs(glm::dot(normal, random3)) > 0.95 ? glm::dvec3(normal.y, normal.z, -normal.x) : random3));
    const glm::dvec3 comb = glm::dvec3(0.25, -0.55, 0.15) + 0.35 * random.direction();
    addBlade(mesh, root, normal * length, side, comb * length * 0.7, width, kParts);
}

// A furry ball of radius 1 around the origin.
Model furBall(const std::string& name, uint32_t skin, uint32_t fur, size_t hairs, Random& random) {
    Model model;
    model.name = name;
    addBall(model.of(skin), {0, 0, 0}, glm::dvec3(0.97), 24);
    Mesh mesh;
    for (size_t i = 0; i < hairs; ++i) {
        const glm::dvec3 normal = random.direction();
        const glm::dvec3 growth = glm::normalize(normal + 0.35 * random.direction());
        addHair(mesh, normal * 0.96, growth, {0.22, 0.42}, {0.010, 0.018}, random);
    }
    model.of(fur) = std::move(mesh);
    return model;
}

Model rug(uint32_t cloth, size_t hairs, Random& random) {
    Model model;
    model.name = "rug";
    Mesh mesh;
    for (size_t i = 0; i < hairs; ++i) {
        const double angle = random.between(0, 2 * kPi);
        const double radius = 2.9 * std::sqrt(random.unit());
        const glm::dvec3 normal = glm::normalize(glm::dvec3(0, 1, 0) + 0.5 * random.direction());
        addHair(mesh, {radius * cosine(angle), 0.001, radius * sine(angle)}, normal, {0.10, 0.24}, {0.008, 0.016}, random);
    }
    model.of(cloth) = std::move(mesh);
    return model;
}

}  // namespace

Draft buildFuzzy(double detail, uint64_t seed) {
    Random random(seed);
    Draft draft;
    const uint32_t floor = draft.material("floor", {0.62, 0.55, 0.46});
    const uint32_t skin = draft.material("skin", {0.30, 0.20, 0.14});
    const uint32_t orange = draft.material("orange fur", {0.80, 0.42, 0.12});
    const uint32_t grey = draft.material("grey fur", {0.55, 0.55, 0.60});
    const uint32_t cloth = draft.material("rug", {0.42, 0.14, 0.18});
    Model ground;
    ground.name = "floor";
    addBox(ground.of(floor), {-15, -0.4, -15}, {15, 0, 15});
    draft.placeOnce(std::move(ground));

    const double hairs = detail * 131000;
    draft.placeOnce(rug(cloth, static_cast<size_t>(hairs * 0.40) + 1, random));
    const int large = draft.model(furBall("large ball", skin, orange, static_cast<size_t>(hairs * 0.36) + 1, random));
    const int small = draft.model(furBall("small ball", skin, grey, static_cast<size_t>(hairs * 0.08) + 1, random));
    const int rolling = draft.place(large, {0.1, 1.12, -0.2});
    draft.place(small, {1.75, 0.52, 0.7}, turn({0, 0, 1}, 0.7), glm::dvec3(0.48));
    draft.place(small, {-1.7, 0.60, 0.5}, turn({1, 0, 0}, 1.9), glm::dvec3(0.56));
    draft.place(small, {0.7, 0.38, 1.6}, turn({1, 0, 0}, 4.0), glm::dvec3(0.36));
    draft.animate(rolling, true, true, [](double t) { return Pose{{0.1 - 0.5 * t, 1.12, -0.2}, turn({0, 0, 1}, 0.45 * t)}; });

    draft.camera([](double t) { return glm::dvec3(4.2 * sine(0.5 - 0.9 * t), 4.1 - 0.6 * t, 5.2 * cosine(0.5 - 0.9 * t)); },
                 [](double) { return glm::dvec3(-0.1, 0.35, 0.2); });
    draft.pointLight({1, 0.94, 0.86}, 5, [](double t) { return glm::dvec3(-2.9 + 2.6 * t, 3.4, 3.1); });
    draft.sun({1, 1, 0.95}, [](double t) { return glm::dvec3(-0.9 + 1.2 * t, 0.9, 0.5); });
    return draft;
}

}  // namespace gno::scenes
