// SPDX-License-Identifier: MIT
// Blocks of houses around a small square, filled from the middle outwards until the wanted number of triangles is reached.
#include <algorithm>
#include <cmath>

#include "scenes/generator/catalogue.hpp"
#include "scenes/generator/city_models.hpp"
#include "scenes/generator/shapes.hpp"
#include "scenes/generator/trees.hpp"

namespace gno::scenes {
namespace {

constexpr double kPitchX = 66, kPitchZ = 50;  // from block to block, metres; streets are 14 m wide

class City {
public:
    City(Draft& draft, Random& random, double wanted) : draft_(draft), random_(random), wanted_(wanted) { makeModels(); }

    /// Returns the number of blocks that were begun.
    int fill() {
        std::vector<std::pair<double, glm::ivec2>> blocks;
        for (int z = -40; z <= 40; ++z)
            for (int x = -40; x <= 40; ++x) blocks.push_back({x * kPitchX * x * kPitchX + (z + 0.3) * kPitchZ * (z + 0.3) * kPitchZ, {x, z}});
        std::sort(blocks.begin(), blocks.end(), [](const auto& a, const auto& b) {
            return std::tuple(a.first, a.second.x, a.second.y) < std::tuple(b.first, b.second.x, b.second.y);
        });
        int begun = 0;
        for (const auto& [distance, at] : blocks) {
            if (full()) break;
            ++begun;
            block({at.x * kPitchX, 0, at.y * kPitchZ}, at == glm::ivec2(0, 0));
        }
        return begun;
    }

private:
    Draft& draft_;
    Random& random_;
    double wanted_;
    double placed_ = 24;  // ground and streets are placed by the caller
    std::vector<int> houses_, towers_, cars_, trees_;
    int lamp_ = 0, bollard_ = 0, pavement_ = 0, lawn_ = 0;

    bool full() const { return placed_ >= wanted_; }

    void put(int model, const glm::dvec3& position, double angle) {
        const auto count = static_cast<double>(draft_.models[static_cast<size_t>(model)].triangleCount());
        if (placed_ + count / 2 > wanted_) return;
        draft_.place(model, position, turn({0, 1, 0}, angle));
        placed_ += count;
    }

    void putTree(const glm::dvec3& position) {
        const int tree = trees_[random_.below(3)];
        put(tree, position, random_.between(0, 6));
    }

    int flat(const std::string& name, uint32_t material, const glm::dvec3& half) {
        Model model;
        model.name = name;
        addBox(model.of(material), -half, half);
        return draft_.model(std::move(model));
    }

    void makeModels() {
        CityPaints paints{{},
                          {},
                          draft_.material("window", {0.16, 0.20, 0.25}),
                          draft_.material("trim", {0.70, 0.67, 0.60}),
                          draft_.material("roof tiles", {0.48, 0.20, 0.13}),
                          draft_.material("metal", {0.30, 0.31, 0.33}),
                          draft_.material("rubber", {0.06, 0.06, 0.06})};
        for (const glm::dvec3 color : {glm::dvec3(0.72, 0.62, 0.46), {0.66, 0.44, 0.34}, {0.60, 0.60, 0.58}, {0.74, 0.70, 0.60}, {0.52, 0.58, 0.52}})
            paints.walls.push_back(draft_.material("wall", color));
        for (const glm::dvec3 color : {glm::dvec3(0.60, 0.08, 0.06), {0.10, 0.20, 0.45}, {0.75, 0.75, 0.72}, {0.15, 0.16, 0.17}})
            cars_.push_back(draft_.model(makeCar(paints, draft_.material("car", color))));
        for (int i = 0; i < 9; ++i) houses_.push_back(draft_.model(makeHouse(paints, 2 + i % 5, i % 3 != 0, random_)));
        for (int i = 0; i < 3; ++i) towers_.push_back(draft_.model(makeTower(paints, 9 + 3 * i, random_)));
        const uint32_t bark = draft_.material("bark", {0.26, 0.19, 0.12});
        for (int i = 0; i < 3; ++i) {
            const uint32_t green = draft_.material("leaves", {0.20 + 0.07 * i, 0.40, 0.12});
            trees_.push_back(draft_.model(makeTree(bark, green, 6.5 + 1.5 * i, 420, random_)));
        }
        lamp_ = draft_.model(makeStreetLamp(paints));
        bollard_ = draft_.model(makeBollard(paints));
        pavement_ = flat("pavement", draft_.material("pavement", {0.56, 0.54, 0.50}), {26, 0.2, 18});
        lawn_ = flat("lawn", draft_.material("lawn", {0.32, 0.44, 0.18}), {20.5, 0.22, 12.5});
    }

    void block(const glm::dvec3& centre, bool square) {
        put(pavement_, centre - glm::dvec3(0, 0.03, 0), 0);
        const double ground = 0.16;
        auto at = [&](double x, double z) { return centre + glm::dvec3(x, ground, z); };
        if (square) {
            put(lawn_, centre, 0);
            for (int i = 0; i < 16; ++i) putTree(at(-18 + 5.1 * (i % 8), i < 8 ? -8.5 : 8.5));
        } else {
            for (int i = 0; i < 6; ++i) {
                const bool front = i < 3;
                const bool tower = random_.chance(0.10);
                const std::vector<int>& kinds = tower ? towers_ : houses_;
                const int house = kinds[random_.below(static_cast<uint32_t>(kinds.size()))];
                const double x = -16.4 + 16.4 * (i % 3) + random_.between(-0.3, 0.3);
                const double z = (front ? 8.6 : -8.6) + random_.between(-0.4, 0.4);
                put(house, at(x, z), front ? 0 : kPi);
            }
        }
        for (int i = 0; i < 8; ++i) {
            const bool front = i < 4;
            put(lamp_, at(-22.5 + 15 * (i % 4), front ? 17.3 : -17.3), front ? -kPi / 2 : kPi / 2);
            putTree(at(-15 + 15 * (i % 4) - 1.5, front ? 16.4 : -16.4));
        }
        for (int i = 0; i < 60; ++i) put(bollard_, at(i < 30 ? -25.4 : 25.4, -16.6 + 1.15 * (i % 30)), 0);
        for (int i = 0; i < 20; ++i) {
            const bool along = i < 12;
            const double lane = (i & 1) ? 1 : -1;
            const glm::dvec3 place = along ? centre + glm::dvec3(random_.between(-24, 24), 0.04, 25 + lane * 2.4)
                                           : centre + glm::dvec3(33 + lane * 2.4, 0.04, random_.between(-17, 17));
            const int car = cars_[random_.below(4)];
            put(car, place, (along ? 0 : kPi / 2) + (lane > 0 ? 0 : kPi) + random_.between(-0.03, 0.03));
        }
    }
};

}  // namespace

Draft buildCity(double detail, uint64_t seed) {
    Random random(seed);
    Draft draft;
    const double wanted = detail * 620000;
    const uint32_t asphalt = draft.material("asphalt", {0.36, 0.36, 0.37});
    const uint32_t fields = draft.material("fields", {0.42, 0.44, 0.30});
    City city(draft, random, wanted);
    const int blocks = city.fill();
    const double reach = std::max(1.0, std::sqrt(blocks * kPitchX * kPitchZ / 4));  // half width of the built part
    Model ground;
    ground.name = "ground";
    addBox(ground.of(fields), {-3.4 * reach, -4, -3.4 * reach}, {3.4 * reach, -0.06, 3.4 * reach});
    addBox(ground.of(asphalt), {-1.25 * reach, -1, -1.25 * reach}, {1.25 * reach, 0.03, 1.25 * reach});
    draft.placeOnce(std::move(ground));

    const double far = std::min(reach, 190.0) / 190;
    draft.znear = 0.5;
    draft.yfov = 0.75;
    draft.camera([far](double t) { return far * glm::dvec3(-70 + 130 * t, 98 - 22 * ease(t), 165 - 35 * t); },
                 [far](double t) { return far * glm::dvec3(-8 + 20 * t, 0, 14); });
    draft.pointLight({1, 0.93, 0.85}, 95 * far, [far](double t) { return far * glm::dvec3(70 - 120 * t, 75, -30 + 25 * t); });
    draft.sun({1, 0.94, 0.82}, [](double t) { return glm::dvec3(0.9 - 0.9 * t, 0.75, -0.35); });
    return draft;
}

}  // namespace gno::scenes
