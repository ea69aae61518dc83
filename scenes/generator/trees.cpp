// SPDX-License-Identifier: MIT
#include "scenes/generator/trees.hpp"

#include <algorithm>
#include <cmath>

#include "scenes/generator/shapes.hpp"

namespace gno::scenes {

Model makeTree(uint32_t bark, uint32_t leaf, double height, size_t triangles, Random& random) {
    Model model;
    model.name = "tree";
    const double crown = 0.30 * height;
    const glm::dvec3 middle(0, 0.66 * height, 0);
    Mesh wood;
    Path trunk{{0, -0.15, 0}};
    for (int i = 1; i <= 3; ++i) trunk.push_back({random.between(-0.03, 0.03) * height, 0.24 * height * i, random.between(-0.03, 0.03) * height});
    addTaperedTube(wood, trunk, 0.030 * height, 0.010 * height, 7);

    std::vector<glm::dvec3> clusters;
    for (int i = 0; i < 9; ++i) {
        const double start = random.between(0.30, 0.68) * height;
        const double angle = 2 * kPi * (i + random.between(-0.3, 0.3)) / 9;
        const double reach = crown * random.between(0.55, 0.95);
        const glm::dvec3 from(0, start, 0);
        const glm::dvec3 to(reach * cosine(angle), middle.y + crown * random.between(-0.55, 0.85), reach * sine(angle));
        const glm::dvec3 knee = (from + to) / 2.0 + glm::dvec3(0, -0.04 * height, 0);
        addTaperedTube(wood, {from, knee, to}, 0.011 * height, 0.004 * height, 4);
        clusters.push_back(to);
        clusters.push_back((knee + to) / 2.0 + crown * 0.3 * random.direction());
    }
    for (int i = 0; i < 8; ++i) {
        const double reach = crown * random.between(0.2, 0.75);
        clusters.push_back(middle + reach * random.direction());
    }

    const size_t leaves = triangles > wood.triangleCount() + 4 ? (triangles - wood.triangleCount()) / 4 : 1;
    const double size = crown * std::min(0.6, std::sqrt(34.0 / static_cast<double>(leaves)));
    Mesh foliage;
    for (size_t i = 0; i < leaves; ++i) {
        const glm::dvec3& cluster = clusters[random.below(static_cast<uint32_t>(clusters.size()))];
        const double reach = crown * 0.42 * std::sqrt(random.unit());
        const glm::dvec3 offset = random.direction() * reach;
        const glm::dvec3 along = glm::normalize(random.direction() + glm::dvec3(0, -0.35, 0) + 0.6 * offset / crown);
        glm::dvec3 up = random.direction();
        if (std::abs(glm::dot(along, up)) > 0.9) up = {along.y, along.z, -along.x};
        const double length = size * random.between(0.75, 1.3);
        addLeaf(foliage, cluster + offset, along * length, up, 0.5 * length);
    }
    model.of(bark) = std::move(wood);
    model.of(leaf) = std::move(foliage);
    return model;
}

}  // namespace gno::scenes
