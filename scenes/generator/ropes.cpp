// SPDX-License-Identifier: MIT
// A three-master in a dry dock: hundreds of ropes, each of several straight strands, that are long thin triangles for any technique.
#include <algorithm>
#include <cmath>

#include "scenes/generator/catalogue.hpp"
#include "scenes/generator/shapes.hpp"
#include "scenes/generator/ship_hull.hpp"

namespace gno::scenes {
namespace {

struct Mast {
    double x, top, rake;
    glm::dvec3 at(double height) const { return {x - rake * height, height, 0}; }
};

constexpr Mast kMasts[] = {{9.2, 22.5, 0.01}, {-0.6, 26.0, 0.02}, {-9.4, 19.0, 0.05}};

class Rigging {
public:
    Rigging(Mesh& mesh, double detail) : mesh_(mesh) {
        strands_ = detail < 0.15 ? 1 : (detail < 0.5 ? 3 : 7);
        perMetre_ = 4.6 * detail * 7 / strands_;
    }

    /// A rope of parallel strands that wind around each other once every few metres.
    void rope(const glm::dvec3& a, const glm::dvec3& b, double thickness, double sag) {
        const double length = glm::length(b - a);
        const int parts = std::max(1, static_cast<int>(length * perMetre_ * 0.5 + 0.5));
        const glm::dvec3 along = (b - a) / length;
        const glm::dvec3 u = glm::normalize(glm::cross(along, std::abs(along.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)));
        const glm::dvec3 v = glm::cross(along, u);
        const Path core = hangingPath(a, b, sag * length, parts);
        for (int s = 0; s < strands_; ++s) {
            const bool middle = s == 0;
            const double radius = strands_ == 1 ? thickness : thickness * 0.36;
            const double around = middle ? 0 : thickness * 0.66;
            Path path;
            for (int i = 0; i <= parts; ++i) {
                const double angle = 2 * kPi * s / std::max(1, strands_ - 1) + 1.5 * length * i / parts;
                path.push_back(core[static_cast<size_t>(i)] + around * (cosine(angle) * u + sine(angle) * v));
            }
            addTube(mesh_, path, radius, 4);
        }
    }

    void shrouds(const Mast& mast) {
        for (const double side : {-1.0, 1.0}) {
            std::vector<glm::dvec3> feet;
            const glm::dvec3 head = mast.at(0.62 * mast.top);
            const int count = 8;
            for (int i = 0; i < count; ++i) {
                const double x = mast.x + 0.4 - 0.55 * i;
                feet.push_back({x, deckHeight(x) + 0.3, side * (deckHalfWidth(x) + 0.25)});
                rope(feet.back(), head, 0.03, 0);
                const glm::dvec3 knee = feet.back() + (head - feet.back()) * 0.93;
                if (i < 5) rope(knee + glm::dvec3(0, 0, side * 0.5), mast.at(0.93 * mast.top), 0.022, 0);
            }
            for (int r = 1; r < 40; ++r) {  // ratlines, from shroud to shroud
                const double t = 0.88 * r / 40;
                for (int i = 0; i + 1 < count; ++i)
                    rope(feet[static_cast<size_t>(i)] + (head - feet[static_cast<size_t>(i)]) * t,
                         feet[static_cast<size_t>(i) + 1] + (head - feet[static_cast<size_t>(i) + 1]) * t, 0.011, 0.02);
            }
        }
    }

    void net(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d, int across, int along) {
        for (int i = 0; i <= across; ++i) {
            const double t = static_cast<double>(i) / across;
            rope(a + (b - a) * t, d + (c - d) * t, 0.010, 0.03);
        }
        for (int i = 1; i < along; ++i) {
            const double t = static_cast<double>(i) / along;
            rope(a + (d - a) * t, b + (c - b) * t, 0.010, 0.02);
        }
    }

private:
    Mesh& mesh_;
    int strands_ = 1;
    double perMetre_ = 1;
};

/// A sail between two yards, blown towards +x; a surface without thickness.
void addSail(Mesh& mesh, const glm::dvec3& top, double topHalf, const glm::dvec3& foot, double footHalf, double belly) {
    constexpr uint32_t kAcross = 14, kDown = 10;
    const auto base = static_cast<uint32_t>(mesh.positions.size());
    for (uint32_t r = 0; r <= kDown; ++r)
        for (uint32_t i = 0; i <= kAcross; ++i) {
            const double t = static_cast<double>(r) / kDown;
            const double s = 2.0 * i / kAcross - 1;
            glm::dvec3 p = top + (foot - top) * t;
            p.z = s * (topHalf + (footHalf - topHalf) * t);
            p.x += belly * (1 - s * s) * sine(kPi * (0.1 + 0.8 * t));
            p.y += 0.5 * t * (1 - s * s);
            mesh.vertex(p);
        }
    for (uint32_t r = 0; r < kDown; ++r)
        for (uint32_t i = 0; i < kAcross; ++i) {
            const uint32_t a = base + r * (kAcross + 1) + i;
            mesh.quad(a, a + kAcross + 1, a + kAcross + 2, a + 1);
        }
}

void addMasts(Model& model, uint32_t spars, uint32_t canvas, Rigging& rigging) {
    for (const Mast& mast : kMasts) {
        Mesh& mesh = model.of(spars);
        addTaperedTube(mesh, {mast.at(1.5), mast.at(0.6 * mast.top), mast.at(mast.top)}, 0.36, 0.10, 14);
        addLathe(mesh, {{0, -0.1}, {0.5, -0.1}, {1.0, 0.1}, {1.0, 0.2}, {0, 0.22}}, 14, at(mast.at(0.62 * mast.top)));
        glm::dvec3 before(0);
        double halfBefore = 0;
        for (int y = 0; y < 3; ++y) {
            const double height = mast.top * (0.94 - 0.22 * y);
            const double half = mast.top * (0.13 + 0.065 * y);
            const glm::dvec3 centre = mast.at(height) + glm::dvec3(0.42, 0, 0);
            addTaperedTube(model.of(spars), {centre, centre + glm::dvec3(0, 0, half)}, 0.16, 0.06, 8);
            addTaperedTube(model.of(spars), {centre, centre - glm::dvec3(0, 0, half)}, 0.155, 0.06, 8);
            if (y > 0)
                addSail(model.of(canvas), before - glm::dvec3(0, 0.25, 0), halfBefore * 0.92, centre + glm::dvec3(0.1, 0.3, 0), half * 0.9, 1.3);
            for (const double side : {-1.0, 1.0}) {
                const glm::dvec3 tip = centre + glm::dvec3(0, 0, side * half * 0.97);
                rigging.rope(tip, mast.at(std::min(mast.top, height + 3.2)), 0.016, 0);
                rigging.rope(tip, {mast.x - 6.5, deckHeight(mast.x - 6.5) + 1, side * deckHalfWidth(mast.x - 6.5)}, 0.014, 0.015);
                for (int i = 0; i < 5; ++i) {
                    const double z = side * half * (0.2 + 0.17 * i);
                    rigging.rope(centre + glm::dvec3(-0.1, -0.1, z), centre + glm::dvec3(-0.1, -0.75, z + side * 0.12 * half), 0.012, 0.05);
                }
            }
            before = centre;
            halfBefore = half;
        }
    }
    const glm::dvec3 bow(21.5, 7.4, 0);
    addTaperedTube(model.of(spars), {{11.5, 4.9, 0}, {17, 6.3, 0}, bow}, 0.30, 0.10, 12);
    for (const double height : {0.98, 0.8, 0.62}) {
        rigging.rope(kMasts[0].at(height * kMasts[0].top), bow - glm::dvec3(6 * (1 - height), 1.5 * (1 - height), 0), 0.03, 0.01);
        rigging.rope(kMasts[1].at(height * kMasts[1].top), kMasts[0].at((height - 0.18) * kMasts[0].top), 0.028, 0.012);
        rigging.rope(kMasts[2].at(height * kMasts[2].top), kMasts[1].at((height - 0.3) * kMasts[1].top), 0.026, 0.012);
    }
    rigging.net({16.5, 5.6, -0.4}, {21, 7.0, -0.1}, {21, 7.0, 0.1}, {16.5, 5.6, 0.4}, 14, 5);
}

void addDock(Draft& draft) {
    const uint32_t stone = draft.material("dock", {0.58, 0.55, 0.50});
    const uint32_t timber = draft.material("timber", {0.38, 0.27, 0.17});
    Model dock;
    dock.name = "dock";
    addBox(dock.of(stone), {-170, -1.5, -170}, {170, 0, 170});
    for (int i = 0; i < 12; ++i) addBox(dock.of(timber), {-14.5 + 2.5 * i, 0.001, -0.6}, {-14 + 2.5 * i, 2.5, 0.6});
    for (int i = 0; i < 7; ++i)
        for (const double side : {-1.0, 1.0})
            addCylinder(dock.of(timber), {-12 + 4.0 * i, -0.2, side * 7.5}, {-12 + 4.0 * i, 2.9, side * 2.9}, 0.16, 0.13, 8);
    draft.placeOnce(std::move(dock));
    Random random(7);
    Model crates;
    crates.name = "crates";
    for (int i = 0; i < 26; ++i) {
        const double size = random.between(0.5, 1.3);
        const glm::dvec3 place{random.between(-18, 20), size / 2 + 0.003, 9 + random.between(0, 7)};
        const glm::dvec3 whole(size, size, size * random.between(0.8, 1.6));
        addBox(crates.of(timber), place, whole, turn({0, 1, 0}, random.between(0, 3)));
    }
    draft.placeOnce(std::move(crates));
}

}  // namespace

Draft buildRopes(double detail, uint64_t seed) {
    Random random(seed);
    Draft draft;
    addDock(draft);
    addShipHull(draft);
    const uint32_t spars = draft.material("spars", {0.46, 0.30, 0.16});
    const uint32_t canvas = draft.material({.name = "canvas", .color = {0.80, 0.74, 0.62}, .doubleSided = true});
    const uint32_t hemp = draft.material("hemp", {0.50, 0.40, 0.26});
    Model rigged;
    rigged.name = "rigging";
    Mesh ropes;
    Rigging rigging(ropes, detail);
    Model masts;
    masts.name = "masts and sails";
    addMasts(masts, spars, canvas, rigging);
    for (const Mast& mast : kMasts) rigging.shrouds(mast);
    rigging.net({-6, 0.4, 9.6}, {4, 0.4, 9.6}, {3.4, deckHeight(3) + 0.9, 3.7}, {-5.4, deckHeight(-5) + 0.9, 3.7}, 24, 16);
    for (int i = 0; i < 9; ++i) {  // mooring lines
        const double x = -14 + 3.6 * i;
        const glm::dvec3 ring{x + random.between(-4, 4), 0.05, random.between(11, 17)};
        rigging.rope({x, deckHeight(x) + 0.4, deckHalfWidth(x)}, ring, 0.045, 0.06);
        rigging.rope({x, deckHeight(x) + 0.4, -deckHalfWidth(x)}, ring * glm::dvec3(1, 1, -1), 0.045, 0.06);
    }
    rigged.of(hemp) = std::move(ropes);
    draft.placeOnce(std::move(masts));
    draft.placeOnce(std::move(rigged));

    draft.znear = 0.2;
    draft.camera([](double t) { return glm::dvec3(24 - 34 * t, 28 - 5 * ease(t), 31); },
                 [](double t) { return glm::dvec3(1.5 - 4 * t, 4.5 + t, 3); });
    draft.pointLight({1, 0.93, 0.82}, 34, [](double t) { return glm::dvec3(-20 + 26 * t, 34, -19 + 8 * t); });
    draft.sun({1, 0.95, 0.85}, [](double t) { return glm::dvec3(-0.7 + 1.0 * t, 1.0, -0.75); });
    return draft;
}

}  // namespace gno::scenes
