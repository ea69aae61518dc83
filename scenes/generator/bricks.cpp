// SPDX-License-Identifier: MIT
// An excavator of studded bricks on a studded plate, with a heap of loose bricks: a million small casters in thousands of objects.
// The model is a solid described by formulas, sampled on the grid of studs and tiled by bricks.
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "scenes/generator/catalogue.hpp"
#include "scenes/generator/shapes.hpp"

namespace gno::scenes {
namespace {

constexpr double kPitch = 0.1, kHeight = 0.12;  // metres from stud to stud and from brick to brick
constexpr int kStudSides = 12;
constexpr size_t kStud = 4 * kStudSides, kBox = 12;  // triangles

enum Color : int { kNone = -1, kYellow, kBlack, kGrey, kGlass, kBrown, kRed, kGreen, kColors };

double distance(double x, double y) { return std::sqrt(x * x + y * y); }

double toSegment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
    const double t = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    return glm::length(p - a - (b - a) * t);
}

/// The excavator in its own units, about 60 long (x), 28 high (y), 18 wide (z), standing on y = 0.
Color excavator(const glm::dvec3& p) {
    const glm::dvec2 side(p.x, p.y);
    const double z = std::abs(p.z);
    if (z > 4.5 && z < 9 && toSegment(side, {-9, 3.4}, {9, 3.4}) < 3.4) {
        const bool wheel = z > 7.5 && std::abs(std::abs(p.x) - 9) < 2 && std::abs(p.y - 3.4) < 2;
        return wheel ? kGrey : kBlack;
    }
    if (std::abs(p.x) < 8 && z < 5 && p.y > 2 && p.y < 6) return kGrey;
    if (distance(p.x + 1, p.z) < 5 && p.y >= 6 && p.y < 7.5) return kBlack;
    const bool cab = p.x > 0.5 && p.x < 8 && p.z > 1.5 && p.z < 7.5 && p.y >= 13 && p.y < 21;
    if (cab) {
        if (p.y > 19.5) return kYellow;
        const bool pillar = (p.x < 1.6 || p.x > 6.9) && (p.z < 2.6 || p.z > 6.4);
        return pillar || p.y < 14.2 ? kYellow : kGlass;
    }
    if (p.y >= 7.5 && p.y < 14 && z < 7.5 && p.x > -12 && p.x < 7.5) {
        if (distance(p.x + 4, p.z) > 8.8) return kNone;
        return p.x < -8 ? kBlack : (p.y < 8.7 ? kGrey : kYellow);
    }
    if (distance(p.x + 6, p.z + 4) < 0.9 && p.y < 18.5 && p.y > 13) return kBlack;
    if (z < 1.6 && std::min(toSegment(side, {4, 11}, {14, 26}), toSegment(side, {14, 26}, {23, 24})) < 1.7) return kYellow;
    if (z < 1.1 && toSegment(side, {22, 25.5}, {28, 9}) < 1.3) return kYellow;
    if (z < 0.8 && std::min(toSegment(side, {8, 10}, {15, 20}), toSegment(side, {17, 27}, {24, 27})) < 0.7) return kGrey;
    const double bucket = distance(p.x - 27.5, p.y - 6.5);
    if (z < 4.2 && bucket < 4.6 && p.x < 30.5 && (bucket > 3.2 || z > 3.2)) return kGrey;
    if (p.y < 7 * (1 - distance(p.x - 31, p.z * 0.8) / 11)) return kBrown;
    if (p.y < 4.5 * (1 - distance(p.x + 19, p.z - 13) / 8)) return kBrown;
    const double wall = std::abs(p.z + 15);
    if (wall < 1 && p.x > -24 && p.x < 16 && p.y < 5.5 + 3.5 * sine(0.45 * p.x)) return kRed;
    return kNone;
}

/// Brick models by width, depth and colour, made when first wanted.
class BrickBox {
public:
    explicit BrickBox(Draft& draft) : draft_(draft) {
        const glm::dvec3 colors[kColors] = {{0.80, 0.56, 0.04}, {0.07, 0.07, 0.08}, {0.42, 0.43, 0.44}, {0.25, 0.50, 0.62},
                                            {0.40, 0.24, 0.12}, {0.62, 0.09, 0.07}, {0.34, 0.50, 0.22}};
        for (const glm::dvec3& color : colors) materials_.push_back(draft.material("brick", color));
    }

    int get(int width, int depth, Color color) {
        const auto [entry, added] = models_.try_emplace({width, depth, color}, 0);
        if (added) entry->second = make(width, depth, color);
        return entry->second;
    }

    static size_t triangles(int width, int depth) { return kBox + kStud * static_cast<size_t>(width * depth); }

private:
    Draft& draft_;
    std::vector<uint32_t> materials_;
    std::map<std::tuple<int, int, int>, int> models_;

    // From the origin to +x, +y, +z; a small gap keeps neighbours from touching.
    int make(int width, int depth, Color color) {
        Model model;
        model.name = "brick " + std::to_string(width) + "x" + std::to_string(depth);
        Mesh& mesh = model.of(materials_[static_cast<size_t>(color)]);
        addBox(mesh, {0.001, 0.001, 0.001}, {width * kPitch - 0.001, kHeight - 0.0005, depth * kPitch - 0.001});
        for (int z = 0; z < depth; ++z)
            for (int x = 0; x < width; ++x) {
                const std::vector<glm::dvec2> stud{{0, kHeight - 0.004}, {0.03, kHeight - 0.004}, {0.03, kHeight + 0.02}, {0, kHeight + 0.02}};
                addLathe(mesh, stud, kStudSides, at({(x + 0.5) * kPitch, 0, (z + 0.5) * kPitch}));
            }
        return draft_.model(std::move(model));
    }
};

struct Placed {
    int width, depth;
    Color color;
    glm::dvec3 corner;
};

/// The tiled model at `scale` grid cells per unit of the formula.
class Builder {
public:
    std::vector<Placed> bricks;
    size_t triangles = 0;

    Builder(double scale, uint64_t seed) : scale_(scale), random_(seed) {
        nx_ = static_cast<int>(76 * scale);
        nz_ = static_cast<int>(52 * scale);
        plate();
        const int levels = static_cast<int>(29 * scale / 1.2) + 1;
        for (int y = 0; y < levels; ++y) level(y);
    }

private:
    double scale_;
    Random random_;
    int nx_, nz_;

    glm::dvec3 corner(int x, int y, int z) const { return {(x - 0.5 * nx_) * kPitch, y * kHeight, (z - 0.5 * nz_) * kPitch}; }

    void add(int width, int depth, Color color, const glm::dvec3& at) {
        bricks.push_back({width, depth, color, at});
        triangles += BrickBox::triangles(width, depth);
    }

    void plate() {
        for (int z = 0; z < nz_; z += 8)
            for (int x = 0; x < nx_; x += 8) add(std::min(8, nx_ - x), std::min(8, nz_ - z), kGreen, corner(x, -1, z));
    }

    Color sample(int x, int y, int z) const {
        return excavator({(x + 0.5 - 0.5 * nx_) / scale_ - 4, (y + 0.5) * 1.2 / scale_, (z + 0.5 - 0.5 * nz_) / scale_});
    }

    // Cells with two layers of others around them are left out, as in a real model.
    bool buried(int x, int y, int z) const {
        for (const glm::ivec3 step : {glm::ivec3(2, 0, 0), {-2, 0, 0}, {0, 2, 0}, {0, -2, 0}, {0, 0, 2}, {0, 0, -2}})
            if (y + step.y >= 0 && sample(x + step.x, y + step.y, z + step.z) == kNone) return false;
        return true;
    }

    void level(int y) {
        std::vector<Color> cells(static_cast<size_t>(nx_) * static_cast<size_t>(nz_), kNone);
        auto cell = [&](int x, int z) -> Color& { return cells[static_cast<size_t>(z) * static_cast<size_t>(nx_) + static_cast<size_t>(x)]; };
        for (int z = 0; z < nz_; ++z)
            for (int x = 0; x < nx_; ++x) {
                const Color color = sample(x, y, z);
                if (color != kNone && !buried(x, y, z)) cell(x, z) = color;
            }
        for (int z = 0; z < nz_; ++z)
            for (int x = 0; x < nx_; ++x) {
                const Color color = cell(x, z);
                if (color == kNone) continue;
                const bool along = ((y & 1) == 0) != random_.chance(0.15);
                const int longest = random_.chance(0.6) ? 4 : 2 + static_cast<int>(random_.below(2));
                const int broad = random_.chance(0.7) ? 2 : 1;
                const auto [width, depth] = largest(cell, x, z, along ? longest : broad, along ? broad : longest);
                for (int k = 0; k < depth; ++k)
                    for (int i = 0; i < width; ++i) cell(x + i, z + k) = kNone;
                add(width, depth, color, corner(x, y, z));
            }
    }

    template <class Cell>
    std::pair<int, int> largest(const Cell& cell, int x, int z, int width, int depth) const {
        const Color color = cell(x, z);
        int w = 1;
        while (w < width && x + w < nx_ && cell(x + w, z) == color) ++w;
        int d = 1;
        auto rowFits = [&](int row) {
            for (int i = 0; i < w; ++i)
                if (cell(x + i, row) != color) return false;
            return true;
        };
        while (d < depth && z + d < nz_ && rowFits(z + d)) ++d;
        return {w, d};
    }
};

}  // namespace

Draft buildBricks(double detail, uint64_t seed) {
    const double wanted = detail * 1150000;
    double scale = 1.8 * std::max(std::sqrt(detail), 0.6 * std::sqrt(std::sqrt(detail)));
    Builder best(scale, seed);
    while (static_cast<double>(best.triangles) > 0.93 * wanted && scale > 0.2) {
        scale *= 0.97;
        best = Builder(scale, seed);
    }
    Draft draft;
    BrickBox box(draft);
    for (const Placed& brick : best.bricks) draft.place(box.get(brick.width, brick.depth, brick.color), brick.corner);

    Random random(seed ^ 0x5bd1e995);
    auto placed = static_cast<double>(best.triangles);
    for (int i = 0; placed < wanted; ++i) {
        const int width = 1 + static_cast<int>(random.below(2));
        const int depth = 1 + static_cast<int>(random.below(4));
        const double angle = random.between(0, 2 * kPi);
        const double reach = random.between(0.2, 1) * 9 * scale * kPitch;
        const glm::dvec3 heap(-18 * scale * kPitch, 0, -3 * scale * kPitch);
        const double high = std::max(0.02, (1 - reach / (9 * scale * kPitch)) * 0.45 * scale) * random.between(0.6, 1);
        const double heading = random.between(0, 6);
        const glm::dvec3 axis = random.direction();
        const glm::dquat lie = turn({0, 1, 0}, heading) * turn(axis, random.between(0, 0.8));
        const int model = box.get(width, depth, static_cast<Color>(random.below(kColors)));
        draft.place(model, heap + glm::dvec3(reach * cosine(angle), 0.05 + high, reach * sine(angle)), lie);
        placed += static_cast<double>(BrickBox::triangles(width, depth));
    }

    const uint32_t table = draft.material("table", {0.52, 0.46, 0.40});
    Model ground;
    ground.name = "table";
    const double half = 20 * scale;
    addBox(ground.of(table), {-half, -0.6, -half}, {half, -kHeight - 0.002, half});
    draft.placeOnce(std::move(ground));

    const double u = kPitch * scale;
    draft.camera([u](double t) { return u * glm::dvec3(6 + 54 * sine(0.6 - 0.9 * t), 44 - 9 * t, 56 * cosine(0.6 - 0.9 * t)); },
                 [u](double t) { return u * glm::dvec3(6, 4.5 + t, 0); });
    draft.pointLight({1, 0.94, 0.86}, 56 * u, [u](double t) { return u * glm::dvec3(-40 + 24 * t, 44, 20 + 8 * t); });
    draft.sun({1, 0.96, 0.9}, [](double t) { return glm::dvec3(-0.9 + 0.7 * t, 0.8, -0.3 + 0.8 * t); });
    return draft;
}

}  // namespace gno::scenes
