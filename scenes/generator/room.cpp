// SPDX-License-Identifier: MIT
// A closed room with the light inside. The shell is one box whose normals point outwards: inside, camera and light see its back faces.
#include <algorithm>
#include <cmath>

#include "scenes/generator/catalogue.hpp"
#include "scenes/generator/shapes.hpp"

namespace gno::scenes {
namespace {

struct Item {
    std::string model;
    uint32_t material;
    glm::dvec3 low, high;
};

struct Paints {
    uint32_t shell, oak, walnut, cloth, white;
    std::vector<uint32_t> books;
};

class Furniture {
public:
    std::vector<Item> items;

    Furniture(const Paints& paints, Random& random) : paints_(paints), random_(random) {}

    void legs(const std::string& model, uint32_t material, glm::dvec2 low, glm::dvec2 high, double top, double thick) {
        for (int i = 0; i < 4; ++i) {
            const double x = (i & 1) ? high.x - thick : low.x;
            const double z = (i & 2) ? high.y - thick : low.y;
            items.push_back({model, material, {x, 0.002, z}, {x + thick, top, z + thick}});
        }
    }

    void table() {
        items.push_back({"table", paints_.oak, {-0.95, 0.72, -0.50}, {0.95, 0.765, 0.50}});
        legs("table", paints_.oak, {-0.90, -0.45}, {0.90, 0.45}, 0.725, 0.06);
    }

    void chair(const std::string& name, double x, double z, bool faceBack) {
        const double back = faceBack ? 0.21 : -0.25;
        items.push_back({name, paints_.walnut, {x - 0.23, 0.44, z - 0.23}, {x + 0.23, 0.475, z + 0.23}});
        legs(name, paints_.walnut, {x - 0.21, z - 0.21}, {x + 0.21, z + 0.21}, 0.445, 0.035);
        items.push_back({name, paints_.walnut, {x - 0.225, 0.47, z + back}, {x + 0.225, 0.93, z + back + 0.035}});
    }

    void bench() {
        items.push_back({"sofa", paints_.cloth, {-2.75, 0.08, 0.4}, {-1.95, 0.42, 2.2}});
        items.push_back({"sofa", paints_.cloth, {-2.85, 0.05, 0.35}, {-2.6, 0.85, 2.25}});
        items.push_back({"sofa", paints_.cloth, {-2.80, 0.06, 0.18}, {-1.90, 0.60, 0.38}});
        items.push_back({"sofa", paints_.cloth, {-2.80, 0.06, 2.22}, {-1.90, 0.60, 2.42}});
    }

    /// A book case of five boards at the back wall, from x on; its books come later.
    void bookCase(int number) {
        const double x = -2.9 + 0.98 * number;
        const std::string name = "book case " + std::to_string(number);
        items.push_back({name, paints_.walnut, {x, 0.004, -2.46}, {x + 0.03, 2.2, -2.14}});
        items.push_back({name, paints_.walnut, {x + 0.90, 0.004, -2.46}, {x + 0.93, 2.2, -2.14}});
        for (int board = 0; board < 6; ++board) {
            const double y = 0.08 + 0.41 * board;
            items.push_back({name, paints_.walnut, {x + 0.015, y, -2.45}, {x + 0.915, y + 0.025, -2.15}});
        }
    }

    void books(int number) {
        const double x = -2.9 + 0.98 * number;
        for (int board = 0; board < 5; ++board) {
            double at = x + 0.045;
            while (at < x + 0.86) {
                const double width = random_.between(0.018, 0.048);
                const double y = 0.1055 + 0.41 * board;
                const uint32_t color = paints_.books[random_.below(static_cast<uint32_t>(paints_.books.size()))];
                items.push_back({"books " + std::to_string(number),
                                 color,
                                 {at, y, -2.44},
                                 {at + width, y + random_.between(0.2, 0.34), random_.between(-2.26, -2.18)}});
                at += width + (random_.chance(0.08) ? 0.07 : 0.0015);
            }
        }
    }

    /// Small things on table and floor, endless: what fills up a wanted number of triangles.
    void block(int number) {
        const bool onTable = random_.chance(0.5);
        const double x = onTable ? random_.between(-0.85, 0.8) : random_.between(-1.8, 2.6);
        const double z = onTable ? random_.between(-0.42, 0.38) : random_.between(-1.8, 2.2);
        const glm::dvec3 size{random_.between(0.03, 0.09), random_.between(0.03, 0.12), random_.between(0.03, 0.09)};
        const glm::dvec3 low(x, onTable ? 0.767 : 0.003, z);
        items.push_back(
            {"blocks " + std::to_string(number / 500), paints_.books[static_cast<size_t>(number) % paints_.books.size()], low, low + size});
    }

private:
    const Paints& paints_;
    Random& random_;
};

void addItems(Draft& draft, const std::vector<Item>& items, size_t count) {
    Model model;
    for (size_t i = 0; i < count; ++i) {
        if (items[i].model != model.name) {
            draft.placeOnce(std::move(model));
            model = {};
            model.name = items[i].model;
        }
        addBox(model.of(items[i].material), items[i].low, items[i].high);
    }
    draft.placeOnce(std::move(model));
}

// A vase, a bowl and a globe of about `triangles` together.
void addRoundThings(Draft& draft, double triangles, uint32_t white, uint32_t color) {
    const int sides = std::max(6, static_cast<int>(std::sqrt(triangles / 3.1)));
    Model model;
    model.name = "vase and globes";
    std::vector<glm::dvec2> vase{{0, 0.767}};
    for (int i = 0; i <= sides / 2; ++i) {
        const double t = static_cast<double>(i) / (sides / 2);
        vase.emplace_back(0.05 + 0.06 * sine(kPi * (0.15 + 0.95 * t)) + 0.01 * t, 0.767 + 0.36 * t);
    }
    vase.emplace_back(0, 1.127);
    addLathe(model.of(white), vase, sides, at({-0.25, 0, 0.1}));
    addBall(model.of(color), {0.45, 0.767 + 0.131, -0.12}, glm::dvec3(0.13), sides);
    addBall(model.of(white), {-2.3, 0.305, -1.5}, glm::dvec3(0.3), sides);
    draft.placeOnce(std::move(model));
}

}  // namespace

Draft buildRoom(double detail, uint64_t seed) {
    Random random(seed);
    Draft draft;
    Paints paints{draft.material({.name = "walls", .color = {0.74, 0.70, 0.62}, .doubleSided = true}),
                  draft.material("oak", {0.55, 0.36, 0.18}),
                  draft.material("walnut", {0.30, 0.18, 0.10}),
                  draft.material("cloth", {0.20, 0.30, 0.42}),
                  draft.material("porcelain", {0.85, 0.85, 0.82}),
                  {}};
    for (const glm::dvec3 color : {glm::dvec3(0.55, 0.12, 0.10), {0.12, 0.30, 0.45}, {0.62, 0.50, 0.16}, {0.16, 0.36, 0.18}, {0.70, 0.66, 0.58}})
        paints.books.push_back(draft.material("book", color));
    Model shell;
    shell.name = "shell";
    addBox(shell.of(paints.shell), {-3, 0, -2.5}, {3, 2.8, 2.5});
    draft.placeOnce(std::move(shell));

    const double wanted = detail * 6000;
    const double round = wanted < 1500 ? 0 : 0.25 * wanted;
    if (round > 0) addRoundThings(draft, round, paints.white, paints.books[0]);
    const double rest = (wanted - static_cast<double>(draft.triangleCount())) / 12;
    const size_t boxes = rest > 0 ? static_cast<size_t>(rest + 0.5) : 0;
    Furniture furniture(paints, random);
    furniture.table();
    furniture.chair("chair 0", -0.45, 0.75, true);
    furniture.chair("chair 1", 0.45, 0.82, true);
    furniture.chair("chair 2", 0.5, -0.78, false);
    furniture.chair("chair 3", -0.5, -0.70, false);
    furniture.bench();
    for (int i = 0; i < 6; ++i) furniture.bookCase(i);
    for (int i = 0; i < 6; ++i) furniture.books(i);
    for (int i = 0; furniture.items.size() < boxes; ++i) furniture.block(i);
    addItems(draft, furniture.items, boxes);

    draft.yfov = 1.05;
    draft.camera([](double t) { return glm::dvec3(2.5 - 1.2 * t, 1.95, 2.15); }, [](double t) { return glm::dvec3(-0.5 + 0.3 * t, 0.55, -0.6); });
    draft.pointLight({1, 0.9, 0.75}, 1.9, [](double t) { return glm::dvec3(-0.5 + 1.1 * ease(t), 2.2 - 0.25 * sine(kPi * t), 0.3 - 0.5 * t); });
    draft.spotLight(
        {0.85, 0.9, 1}, 2.6, 0.7, [](double t) { return glm::dvec3(2.2, 2.4, -0.8 + t); }, [](double) { return glm::dvec3(-0.4, 0.5, 0); });
    return draft;
}

}  // namespace gno::scenes
