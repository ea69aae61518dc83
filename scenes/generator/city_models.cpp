// SPDX-License-Identifier: MIT
#include "scenes/generator/city_models.hpp"

#include "scenes/generator/shapes.hpp"

namespace gno::scenes {
namespace {

/// Something on a facade: `right` runs along it, `out` away from it, from the point `low` of the wall.
void addOnWall(Mesh& mesh, const glm::dvec3& low, const glm::dvec3& right, const glm::dvec3& out, const glm::dvec3& size) {
    const glm::dvec3 other = low + right * size.x + glm::dvec3(0, size.y, 0) + out * size.z;
    const glm::dvec3 inside = low - out * 0.15;
    addBox(mesh, glm::min(inside, other), glm::max(inside, other));
}

struct Facade {
    glm::dvec3 corner, right, out;
    double width;
};

void addWindows(Model& model, const CityPaints& paints, const Facade& facade, int columns, int floors, double storey, bool balconies) {
    const double pitch = facade.width / columns;
    for (int floor = 0; floor < floors; ++floor)
        for (int column = 0; column < columns; ++column) {
            const double bottom = storey * floor + (floor == 0 ? 0.7 : 0.95);
            const double wide = pitch * 0.46;
            const glm::dvec3 low = facade.corner + facade.right * (pitch * (column + 0.5) - wide / 2) + glm::dvec3(0, bottom, 0);
            addOnWall(model.of(paints.window), low, facade.right, facade.out, {wide, 1.55, 0.03});
            addOnWall(model.of(paints.trim), low - facade.right * 0.11 - glm::dvec3(0, 0.13, 0), facade.right, facade.out,
                      {wide + 0.22, 0.12, 0.22});
            addOnWall(model.of(paints.trim), low - facade.right * 0.08 + glm::dvec3(0, 1.56, 0), facade.right, facade.out,
                      {wide + 0.16, 0.14, 0.14});
            if (!balconies || floor == 0 || column % 2 == 0) continue;
            const glm::dvec3 slab = low - facade.right * 0.4 - glm::dvec3(0, 0.75, 0);
            addOnWall(model.of(paints.trim), slab, facade.right, facade.out, {wide + 0.8, 0.14, 1.15});
            for (int i = 0; i < 7; ++i) {
                const glm::dvec3 foot = slab + facade.right * (0.05 + (wide + 0.7) * i / 6) + facade.out * 1.10 + glm::dvec3(0, 0.1, 0);
                addBox(model.of(paints.metal), foot - glm::dvec3(0.02, 0, 0.02), foot + glm::dvec3(0.02, 0.92, 0.02));
            }
            const glm::dvec3 rail = slab + facade.out * 1.10 + glm::dvec3(0, 1.0, 0);
            const glm::dvec3 end = rail + facade.right * (wide + 0.8);
            addBox(model.of(paints.metal), glm::min(rail, end) - glm::dvec3(0.03), glm::max(rail, end) + glm::dvec3(0.03));
        }
}

void addFacades(Model& model, const CityPaints& paints, double x, double z, int columns, int sideColumns, int floors, double storey,
                bool balconies) {
    const Facade facades[] = {{{-x, 0, z}, {1, 0, 0}, {0, 0, 1}, 2 * x},
                              {{x, 0, -z}, {-1, 0, 0}, {0, 0, -1}, 2 * x},
                              {{x, 0, z}, {0, 0, -1}, {1, 0, 0}, 2 * z},
                              {{-x, 0, -z}, {0, 0, 1}, {-1, 0, 0}, 2 * z}};
    for (int i = 0; i < 4; ++i) addWindows(model, paints, facades[i], i < 2 ? columns : sideColumns, floors, storey, balconies && i == 0);
}

void addFlatRoof(Model& model, const CityPaints& paints, double x, double z, double top, Random& random) {
    for (const double side : {-1.0, 1.0}) {
        addBox(model.of(paints.trim), {-x - 0.1, top - 0.1, side * (z - 0.1) - 0.2}, {x + 0.1, top + 0.8, side * (z - 0.1) + 0.2});
        addBox(model.of(paints.trim), {side * (x - 0.1) - 0.2, top - 0.11, -z + 0.05}, {side * (x - 0.1) + 0.2, top + 0.78, z - 0.05});
    }
    for (int i = 0; i < 5; ++i) {
        const glm::dvec3 size{random.between(0.8, 2.4), random.between(0.5, 1.9), random.between(0.8, 2.2)};
        const glm::dvec3 low{random.between(-x + 1, x - 3.4), top - 0.05, random.between(-z + 1, z - 3.2)};
        addBox(model.of(paints.metal), low, low + size);
    }
    const glm::dvec3 mast{random.between(-x + 1, x - 1), top - 0.02, random.between(-z + 1, z - 1)};
    addCylinder(model.of(paints.metal), mast, mast + glm::dvec3(0, 4.5, 0), 0.07, 0.03, 6);
    for (int i = 0; i < 4; ++i) {
        const glm::dvec3 at = mast + glm::dvec3(0, 2.4 + 0.5 * i, 0);
        addCylinder(model.of(paints.metal), at - glm::dvec3(0.8 - 0.12 * i, 0, 0), at + glm::dvec3(0.8 - 0.12 * i, 0, 0), 0.025, 0.025, 4);
    }
}

}  // namespace

Model makeHouse(const CityPaints& paints, int floors, bool gabled, Random& random) {
    Model model;
    model.name = "house";
    const double storey = random.between(3.0, 3.5);
    const double x = random.between(6.4, 7.2);
    const double z = random.between(5.4, 6.4);
    const double top = storey * floors + 0.4;
    const uint32_t wall = paints.walls[random.below(static_cast<uint32_t>(paints.walls.size()))];
    addBox(model.of(wall), {-x, -0.3, -z}, {x, top, z});
    addBox(model.of(paints.trim), {-x - 0.12, -0.31, -z - 0.12}, {x + 0.12, 0.45, z + 0.12});
    for (int floor = 1; floor <= floors; ++floor) {
        const double y = storey * floor - (floor == floors ? 0.0 : 0.1);
        addBox(model.of(paints.trim), {-x - 0.1, y, -z - 0.1}, {x + 0.1, y + 0.16, z + 0.1});
    }
    const int columns = 4 + static_cast<int>(random.below(3));
    const int sideColumns = 3 + static_cast<int>(random.below(2));
    addFacades(model, paints, x, z, columns, sideColumns, floors, storey, random.chance(0.5));
    if (gabled) {
        addGable(model.of(paints.tiles), {-x - 0.6, top - 0.05, -z - 0.5}, {x + 0.6, top + random.between(3.0, 4.6), z + 0.5});
        for (int i = 0; i < 2; ++i) {
            const double at = random.between(-z + 1, z - 1.8);
            addBox(model.of(wall), {2.0 - 5.1 * i, top + 0.3, at}, {2.8 - 5.1 * i, top + 4.9, at + 0.9});
        }
    } else {
        addFlatRoof(model, paints, x, z, top, random);
    }
    return model;
}

Model makeTower(const CityPaints& paints, int floors, Random& random) {
    Model model;
    model.name = "tower";
    double bottom = -0.3;
    double x = 7.4;
    double z = 6.6;
    const double storey = 3.2;
    const uint32_t wall = paints.walls[random.below(static_cast<uint32_t>(paints.walls.size()))];
    for (int step = 0; step < 2; ++step) {
        const double top = storey * (step == 0 ? floors * 2 / 3 : floors) + 0.4;
        addBox(model.of(wall), {-x, bottom, -z}, {x, top, z});
        addBox(model.of(paints.trim), {-x - 0.2, top - 0.5, -z - 0.2}, {x + 0.2, top + 0.35, z + 0.2});
        for (int i = 0; i < 12; ++i) {
            const double along = -x + 0.6 + (2 * x - 1.2) * i / 11;
            addBox(model.of(paints.trim), {along - 0.16, bottom + 0.2, -z - 0.14}, {along + 0.16, top - 0.4, z + 0.14});
        }
        if (step == 1) addFlatRoof(model, paints, x, z, top + 0.35, random);
        bottom = top - 0.6;
        x -= 1.6;
        z -= 1.5;
    }
    addFacades(model, paints, 7.4, 6.6, 11, 6, floors * 2 / 3, storey, false);
    return model;
}

Model makeCar(const CityPaints& paints, uint32_t color) {
    Model model;
    model.name = "car";
    addBox(model.of(color), {-2.05, 0.32, -0.86}, {2.05, 0.86, 0.86});
    Mesh cabin;
    addPrism(cabin, {{-1.45, 0.84}, {1.05, 0.84}, {0.45, 1.42}, {-1.15, 1.42}}, -0.76, 0.76);
    model.of(paints.window).append(cabin, {glm::dmat3(glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1), glm::dvec3(0, 1, 0)), glm::dvec3(0)});
    addBox(model.of(color), {-1.12, 1.41, -0.73}, {0.42, 1.46, 0.73});
    for (const double x : {-1.25, 1.3})
        for (const double z : {-0.8, 0.8}) addCylinder(model.of(paints.rubber), {x, 0.34, z - 0.11}, {x, 0.34, z + 0.11}, 0.34, 0.34, 12);
    return model;
}

Model makeStreetLamp(const CityPaints& paints) {
    Model model;
    model.name = "street lamp";
    Mesh& mesh = model.of(paints.metal);
    addTaperedTube(mesh, {{0, -0.1, 0}, {0, 3, 0}, {0, 5.2, 0}, {0.25, 5.75, 0}, {0.9, 6.0, 0}, {1.6, 6.0, 0}}, 0.09, 0.045, 7);
    addBox(mesh, {1.45, 5.88, -0.16}, {2.15, 6.02, 0.16});
    addCylinder(mesh, {0, -0.05, 0}, {0, 0.7, 0}, 0.15, 0.12, 7);
    return model;
}

Model makeBollard(const CityPaints& paints) {
    Model model;
    model.name = "bollard";
    addLathe(model.of(paints.metal), {{0, -0.05}, {0.09, -0.05}, {0.075, 0.8}, {0.10, 0.9}, {0, 0.97}}, 6);
    return model;
}

}  // namespace gno::scenes
