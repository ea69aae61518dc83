// SPDX-License-Identifier: MIT
#include "scenes/generator/play_structures.hpp"

#include <cmath>

#include "scenes/generator/shapes.hpp"

namespace gno::scenes {
namespace {

void bar(Mesh& mesh, const glm::dvec3& a, const glm::dvec3& b, double radius, int sides) { addCylinder(mesh, a, b, radius, radius, sides); }

void addNet(Mesh& mesh, const glm::dvec3& low, const glm::dvec3& across, const glm::dvec3& upwards, int columns, int rows, int sides) {
    for (int i = 0; i <= columns; ++i) {
        const glm::dvec3 foot = low + across * (static_cast<double>(i) / columns);
        addTube(mesh, hangingPath(foot, foot + upwards, 0.05, 6), 0.014, sides);
    }
    for (int i = 1; i < rows; ++i) {
        const glm::dvec3 start = low + upwards * (static_cast<double>(i) / rows) - glm::dvec3(0, 0.04, 0);
        addTube(mesh, hangingPath(start, start + across, 0.03, 6), 0.013, sides);
    }
}

}  // namespace

Model playTower(const PlayPaints& paints, int sides) {
    Model model;
    model.name = "tower";
    for (int i = 0; i < 4; ++i) {
        const double x = (i & 1) ? 0.8 : -0.8;
        const double z = (i & 2) ? 0.8 : -0.8;
        bar(model.of(paints.wood), {x, -0.1, z}, {x, 3.1, z}, 0.07, sides);
    }
    for (int i = 0; i < 8; ++i) addBox(model.of(paints.wood), {-0.88, 1.5, -0.88 + 0.222 * i}, {0.88, 1.56, -0.675 + 0.222 * i});
    addGable(model.of(paints.red), {-1.1, 2.95, -1.15}, {1.1, 3.85, 1.15});
    for (const double z : {-0.8, 0.8}) {
        bar(model.of(paints.yellow), {-0.8, 2.3, z}, {0.8, 2.3, z}, 0.03, sides);
        for (int i = 1; i < 8; ++i) bar(model.of(paints.yellow), {-0.8 + 0.2 * i, 1.52, z}, {-0.8 + 0.2 * i, 2.31, z}, 0.017, sides);
    }
    Path slide;
    for (int i = 0; i <= 3 * sides; ++i) {
        const double t = static_cast<double>(i) / (3 * sides);
        slide.push_back({0.75 + 3.1 * t, 1.86 - 1.56 * ease(t) + 0.10 * sine(3 * kPi * t), 0});
    }
    addGutter(model.of(paints.blue), slide, 0.30, 0.03, sides);
    for (const double z : {-0.25, 0.25}) bar(model.of(paints.steel), {2.3, -0.1, z}, {2.3, 0.72, z}, 0.03, sides);
    for (const double z : {-0.3, 0.3}) bar(model.of(paints.steel), {-1.5, -0.05, z}, {-0.8, 2.4, z}, 0.03, sides);
    for (int i = 1; i < 7; ++i) {
        const double t = i / 8.0;
        bar(model.of(paints.steel), {-1.5 + 0.7 * t, -0.05 + 2.45 * t, -0.33}, {-1.5 + 0.7 * t, -0.05 + 2.45 * t, 0.33}, 0.018, sides);
    }
    addNet(model.of(paints.rope), {-0.75, 0.0, 1.9}, {1.5, 0, 0}, {0, 1.6, -1.05}, 7, 7, 4);
    return model;
}

Model climbingDome(const PlayPaints& paints, int sides) {
    Model model;
    model.name = "dome";
    constexpr int kRings = 4;
    const double radius = 1.7;
    auto knot = [&](int ring, int i) {
        const double up = kPi / 2 * ring / kRings;
        const double angle = 2 * kPi * (i + 0.5 * ring) / 10;
        const double out = ring == kRings ? 0.04 : radius * cosine(up);  // bars do not meet in one point
        return glm::dvec3(out * cosine(angle), radius * sine(up), out * sine(angle));
    };
    for (int ring = 0; ring < kRings; ++ring)
        for (int i = 0; i < 10; ++i) {
            const uint32_t color = (ring & 1) ? paints.red : paints.yellow;
            const glm::dvec3 here = knot(ring, i);
            auto strut = [](Mesh& mesh, const glm::dvec3& a, const glm::dvec3& b, double thick, int count) {
                const glm::dvec3 gap = 0.008 * glm::normalize(b - a);  // ends of neighbours inside a knot must not coincide
                addCylinder(mesh, a + gap, b - gap, thick, thick, count);
            };
            strut(model.of(color), here, knot(ring, i + 1), 0.022, sides);
            strut(model.of(color), here, knot(ring + 1, i), 0.022, sides);
            if (ring + 1 < kRings) strut(model.of(color), here, knot(ring + 1, i - 1), 0.022, sides);
            addBall(model.of(paints.steel), here, glm::dvec3(0.045), sides);
        }
    addBall(model.of(paints.steel), {0, radius, 0}, glm::dvec3(0.07), sides);
    return model;
}

Model monkeyBars(const PlayPaints& paints, int sides) {
    Model model;
    model.name = "monkey bars";
    for (const double z : {-0.45, 0.45}) {
        Path arch;
        for (int i = 0; i <= 24; ++i) {
            const double angle = kPi * i / 24;
            arch.push_back({-1.9 * cosine(angle), 2.3 * std::sqrt(sine(angle)) - 0.05, z});
        }
        addTube(model.of(paints.blue), arch, 0.035, sides);
        for (int i = 3; i <= 21; ++i)
            if (z < 0) bar(model.of(paints.steel), arch[static_cast<size_t>(i)], arch[static_cast<size_t>(i)] + glm::dvec3(0, 0, 0.9), 0.018, sides);
    }
    return model;
}

Model swingFrame(const PlayPaints& paints, int sides) {
    Model model;
    model.name = "swing frame";
    bar(model.of(paints.red), {-2, 2.4, 0}, {2, 2.4, 0}, 0.06, sides);
    for (const double x : {-1.95, 1.95})
        for (const double z : {-1.0, 1.0}) {
            bar(model.of(paints.red), {x, 2.42, 0.05 * z}, {x * 1.08, -0.1, z}, 0.05, sides);
            if (z < 0) bar(model.of(paints.red), {x * 1.05, 0.8, -0.68}, {x * 1.05, 0.8, 0.68}, 0.03, sides);
        }
    return model;
}

Model swingSeat(const PlayPaints& paints, int sides) {
    Model model;
    model.name = "swing";
    addBox(model.of(paints.wood), {-0.26, -1.96, -0.1}, {0.26, -1.92, 0.1});
    const int links = 6 * sides;
    for (const double x : {-0.22, 0.22})
        for (int i = 0; i < links; ++i) {
            const glm::dvec3 centre(x, -1.92 * (i + 0.5) / links, 0);
            const glm::dvec3 wide = (i & 1) ? glm::dvec3(0.012, 0, 0) : glm::dvec3(0, 0, 0.012);
            addTube(model.of(paints.steel), arcPath(centre, wide, {0, 1.25 * 1.92 / links / 2, 0}, 0, 2 * kPi, 6), 0.004, 3, true);
        }
    return model;
}

Model springRider(const PlayPaints& paints, uint32_t body, int sides) {
    Model model;
    model.name = "spring rider";
    Path spring;
    const int steps = 6 * sides;
    for (int i = 0; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        spring.push_back({0.11 * cosine(10 * kPi * t), 0.02 + 0.42 * t, 0.11 * sine(10 * kPi * t)});
    }
    addTube(model.of(paints.steel), spring, 0.016, 5);
    addBall(model.of(body), {0, 0.62, 0}, {0.46, 0.2, 0.14}, 2 * sides);
    addBall(model.of(body), {0.46, 0.86, 0}, {0.19, 0.16, 0.12}, 2 * sides);
    bar(model.of(paints.steel), {0.30, 0.85, -0.24}, {0.30, 0.85, 0.24}, 0.016, sides);
    bar(model.of(paints.steel), {0.0, 0.50, -0.26}, {0.0, 0.50, 0.26}, 0.016, sides);
    return model;
}

Model merryGoRound(const PlayPaints& paints, int sides) {
    Model model;
    model.name = "merry-go-round";
    addLathe(model.of(paints.blue), {{0, 0.20}, {1.25, 0.20}, {1.25, 0.27}, {0, 0.28}}, 5 * sides);
    addCylinder(model.of(paints.steel), {0, -0.05, 0}, {0, 1.05, 0}, 0.06, 0.05, sides);
    for (int i = 0; i < 6; ++i) {
        const double angle = 2 * kPi * i / 6;
        const glm::dvec3 out(cosine(angle), 0, sine(angle));
        addTube(model.of(paints.yellow),
                {out * 0.03 + glm::dvec3(0, 1.0, 0), out * 0.9 + glm::dvec3(0, 1.02, 0), out * 1.1 + glm::dvec3(0, 0.9, 0),
                 out * 1.15 + glm::dvec3(0, 0.22, 0)},
                0.022, sides);
    }
    return model;
}

Model seesaw(const PlayPaints& paints, int sides) {
    Model model;
    model.name = "seesaw";
    addBox(model.of(paints.yellow), {-1.7, 0.55, -0.12}, {1.7, 0.61, 0.12});
    for (const double x : {-1.3, 1.3}) {
        bar(model.of(paints.steel), {x, 0.56, 0}, {x, 0.92, 0}, 0.018, sides);
        bar(model.of(paints.steel), {x, 0.9, -0.2}, {x, 0.9, 0.2}, 0.018, sides);
    }
    return model;
}

Model parkBench(const PlayPaints& paints) {
    Model model;
    model.name = "bench";
    for (int i = 0; i < 4; ++i) addBox(model.of(paints.wood), {-0.8, 0.42, -0.2 + 0.11 * i}, {0.8, 0.45, -0.11 + 0.11 * i});
    for (int i = 0; i < 3; ++i) addBox(model.of(paints.wood), {-0.8, 0.56 + 0.12 * i, -0.26 - 0.03 * i}, {0.8, 0.65 + 0.12 * i, -0.23 - 0.03 * i});
    for (const double x : {-0.62, 0.62}) {
        addBox(model.of(paints.steel), {x - 0.03, -0.05, -0.18}, {x + 0.03, 0.43, 0.2});
        addBox(model.of(paints.steel), {x - 0.025, 0.4, -0.34}, {x + 0.025, 0.95, -0.27});
    }
    return model;
}

}  // namespace gno::scenes
