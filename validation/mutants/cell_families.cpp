// SPDX-License-Identifier: MIT
#include <algorithm>

#include "validation/mutants/forest_cases.hpp"
#include "validation/mutants/light_face.hpp"

namespace gno::mutants {
namespace {

using cpu::CellQuestion;

constexpr double kBand = 0x1p-20;  // GNO_BAND
constexpr uint kResolutions[] = {1, 2, 4, 16, 64, 256, 1024};

double nudge(Random& r) { return r.below(3) == 0 ? 0.0 : std::ldexp(r.real(), -14 - r.below(14)); }

/// Points on the caster, and in its shadow or beside it, by a unit or an ulp.
void addPoints(Random& r, CellQuestion& question, int count) {
    cpu::TinyScene scene{question.light, {question.t}, {}};
    addBehind(r, scene, question.t, count);
    for (int i = 0; i < count / 4; ++i) addSample(scene, snap(onCaster(r, question.t)));
    for (const GnoViewSample& s : scene.samples) question.points.push_back(s.position);
}

CellQuestion ask(Random& r, const Face& f, const GnoCaster& t, int points) {
    CellQuestion question{f.light, f.grid, t, {}, {}};
    addPoints(r, question, points);
    return question;
}

/// Casters of any kind, and points of the families that are hard for single signs.
CellQuestion anything(Random& r, uint resolution) {
    constexpr int kCount = int(std::size(questions::kFamilies));
    questions::Question q = questions::kFamilies[r.below(kCount)].make(r);
    while (!inScene(q.t) || !mutants::inScene(q.p) || !mutants::inScene(vec3(q.light)) || vec3(q.light) == vec3(0))
        q = questions::kFamilies[r.below(kCount)].make(r);
    if (q.light.w == 0.0f) q.light = directional(dvec3(vec3(q.light)));
    Face f{q.light, host::forestGrid(q.light, vec3(-1), vec3(1), resolution), 0};
    CellQuestion question = ask(r, f, q.t, 4);
    question.points.push_back(q.p);
    return question;
}

/// Points where cells meet, on the cube's edges and in its corners; some at the light.
CellQuestion borders(Random& r, uint resolution) {
    const Face f = anyFace(r, resolution);
    CellQuestion question{f.light, f.grid, {r.uniform(), r.uniform(), r.uniform()}, {}, {}};
    for (int i = 0; i < 8; ++i) {
        const int n = int(resolution);
        const double column = r.below(4) == 0 ? (r.below(2) == 0 ? 0 : n) : r.below(n + 1),
                     row = r.below(3) == 0 ? (r.below(2) == 0 ? 0 : n) : r.below(n + 1);
        const double t = r.below(2) == 0 ? std::ldexp(1.0, -1 - r.below(6)) : f.depth(r);
        vec3 p = snap(f.at(f.x(column) + nudge(r) * r.below(2), f.y(r.below(2) == 0 ? row : row + r.real()) + nudge(r) * r.below(2), t));
        if (r.below(2) == 0) p = r.neighbour(p);
        if (mutants::inScene(p)) question.points.push_back(p);
    }
    question.points.push_back(vec3(f.light));
    question.points.push_back(snap(dvec3(vec3(f.light)) * 0.75 + dvec3(r.anyExponent()) * 0x1p-24));
    if (f.light.w != 0.0f) question.points.push_back(snap(dvec3(vec3(f.light)) + dvec3(r.anyExponent()) * 0x1p-20));
    return question;
}

/// The caster stands on one side of a border and touches it with a vertex: a shadowed point behind that vertex may be rounded to the other side.
CellQuestion vertexAtBorder(Random& r, uint resolution) {
    for (;;) {
        const Face f = anyFace(r, resolution);
        const double side = r.below(2) == 0 ? 1 : -1, width = 2.0 / resolution * (0.3 + 3 * (r.real() + 1));
        const bool turned = r.below(2) == 0;
        const double border = r.below(int(resolution) + 1), other = (r.real() + 1) / 2 * resolution;
        const double x = (turned ? f.y(border) : f.x(border)) + nudge(r) * r.below(2), y = turned ? f.x(other) : f.y(other);
        const auto place = [&](double over, double along) {
            const double t = f.light.w == 0.0f || r.below(2) == 0 ? f.depth(r) : 0.3 + 0.2 * r.real();
            return snap(turned ? f.at(along, over, t) : f.at(over, along, t));
        };
        const GnoCaster t{place(x, y), place(x + side * width, y + width * r.real()),
                          place(x + side * width * (r.real() + 1.2), y + width * r.real())};
        if (!inScene(t)) continue;
        CellQuestion question = ask(r, f, t, 4);
        for (int i = 0; i < 4; ++i) {
            const vec3 p = r.neighbour(snap(behind(f.light, dvec3(t.a), 1.0 + std::ldexp(1.0, -r.below(20)))));
            if (mutants::inScene(p)) question.points.push_back(p);
        }
        return question;
    }
}

/// An edge that points almost at the light, so that its plane is worth little, runs along a border of cells or through a corner of one.
CellQuestion longEdgeAtBorder(Random& r, uint resolution) {
    for (;;) {
        const Face f = anyFace(r, resolution);
        const double side = r.below(2) == 0 ? 1 : -1, lean = std::ldexp(1.0 + r.real() * 0.5, -3 - r.below(4));
        const double x = f.x(r.below(int(resolution) + 1)) + side * nudge(r), y = f.y((r.real() + 1) / 2 * resolution),
                     slope = r.below(2) == 0 ? 0 : r.real();
        const double near = std::ldexp(0.7 + 0.3 * r.real(), -4 - r.below(4)), far = 0.9 + 0.1 * r.real();
        const auto depth = [&](bool isNear) { return f.light.w == 0.0f ? (isNear ? -1 : 1) * (0.6 + 0.3 * r.real()) : isNear ? near : far; };
        const GnoCaster t{snap(f.at(x, y, depth(true))), snap(f.at(x + slope * lean, y + lean, depth(false))),
                          snap(f.at(x + side * 0.4, y + 0.5 * lean, depth(r.below(2) == 0)))};
        if (!inScene(t)) continue;
        CellQuestion question = ask(r, f, t, 2);
        for (int i = 0; i < 8; ++i) {
            const dvec3 on = dvec3(t.a) + (dvec3(t.b) - dvec3(t.a)) * (0.5 + 0.5 * r.real());
            const vec3 p = snap(behind(f.light, on, 1.0 + std::ldexp(1.0, -r.below(12))));
            if (mutants::inScene(p)) question.points.push_back(r.below(2) == 0 ? p : r.neighbour(p));
        }
        return question;
    }
}

/// The caster covers a cell, and one of its edges, of any lean, runs by two of the cell's corners at the distance that is in question.
CellQuestion edgeAtCorners(Random& r, uint resolution) {
    for (;;) {
        const Face f = anyFace(r, resolution);
        const int n = int(resolution);
        const uint column = uint(r.below(n)), row = uint(r.below(n));
        const double step = f.x(1) - f.x(0), rise = f.y(1) - f.y(0), slack = (f.light.w == 0.0f ? 1.75 : 1.0) * kBand;
        const double x0 = f.x(column) - slack * (2 + 5 * (r.real() + 1)), y0 = f.y(row) - slack * 6;
        const double x1 = x0 + slack * r.real() * r.below(2), y1 = f.y(row + 1) + slack * 6;
        const auto line = [&](double s) { return std::pair(x0 + (x1 - x0) * s, y0 + (y1 - y0) * s); };
        const double longer = std::ldexp(1.0, r.below(3));
        const auto [ax, ay] = line(-(0.2 + longer * (r.real() + 1.1)));
        const auto [bx, by] = line(1.2 + longer * (r.real() + 1.1));
        const double beyond = step * (3 + 3 * longer * (r.real() + 1.5)), middle = y0 + rise * (0.5 + 0.3 * r.real());
        const bool same = r.below(3) == 0;  // all at one depth: no edge points at the light
        const auto depth = [&] {
            return f.light.w == 0.0f ? (same ? 0.2 : 0.7 * r.real()) : same ? 0.3 : std::ldexp(0.8 + 0.2 * r.real(), -r.below(7));
        };
        const GnoCaster t{snap(f.at(ax, ay, depth())), snap(f.at(bx, by, depth())), snap(f.at(x0 + beyond, middle, depth()))};
        if (!inScene(t)) continue;
        CellQuestion question = ask(r, f, t, 3);
        question.cells.push_back(f.cell(column, row));
        if (column + 1 < resolution) question.cells.push_back(f.cell(column + 1, row));
        return question;
    }
}

/// A caster near the light: it covers many cells, and each of its bounds of depth is far from the others.
CellQuestion large(Random& r, uint resolution) {
    Face f = anyFace(r, resolution);
    const dvec3 near = f.light.w == 0.0f ? dvec3(0) : dvec3(vec3(f.light));
    const double size = std::ldexp(1.0, -r.below(4)), gap = std::ldexp(1.0, -r.below(12));
    const auto corner = [&] {
        return snap(glm::clamp(near + gap * dvec3(r.real(), r.real(), r.real()) + size * dvec3(r.real(), r.real(), r.real()), -1.0, 1.0));
    };
    CellQuestion question = ask(r, f, {corner(), corner(), corner()}, 8);
    for (int i = 0; i < 6; ++i) question.cells.push_back(uint(r.below(int(gnoCellCount(resolution, f.grid.faces)))));
    return question;
}

/// All of the caster is as far from the light as fp32 can tell: small, or at a right angle to a direction. Points on it and a hair before it.
CellQuestion oneDepth(Random& r, uint resolution) {
    for (;;) {
        const Face f = anyFace(r, resolution);
        const double size = f.light.w == 0.0f ? 0.3 : std::ldexp(1.0, -10 - r.below(12)), x = 0.9 * r.real(), y = 0.9 * r.real(),
                     t = f.light.w == 0.0f ? 0.5 * r.real() : 0.5 + 0.3 * r.real();
        const auto corner = [&] { return snap(f.at(x + size * r.real(), y + size * r.real(), t)); };
        const GnoCaster c{corner(), corner(), corner()};
        if (!inScene(c)) continue;
        CellQuestion question = ask(r, f, c, 4);
        for (int i = 0; i < 12; ++i) {
            const vec3 p = snap(behind(f.light, onCaster(r, c), 1.0 - std::ldexp(1.0, -22 - r.below(12))));
            if (mutants::inScene(p)) question.points.push_back(r.below(2) == 0 ? p : r.neighbour(p));
        }
        return question;
    }
}

struct Maker {
    const char* name;
    CellQuestion (*make)(Random&, uint resolution);
};
constexpr Maker kMakers[] = {{"anything", anything},
                             {"points where cells meet", borders},
                             {"vertex at a cell's border", vertexAtBorder},
                             {"long edge at a cell's border", longEdgeAtBorder},
                             {"edge at a cell's corners", edgeAtCorners},
                             {"large caster near the light", large},
                             {"caster all at one depth", oneDepth}};

}  // namespace

std::vector<CellFamily> makeCellFamilies(uint questions) {
    std::vector<CellFamily> families;
    uint64_t seed = 64;
    for (const Maker& maker : kMakers) {
        Random r(++seed);
        families.push_back({maker.name, {}});
        for (uint i = 0; i < questions; ++i) families.back().questions.push_back(maker.make(r, kResolutions[i % std::size(kResolutions)]));
    }
    return families;
}

std::string failure(const CellFamily& family, const cpu::Forest& forest, cpu::CellTally& tally, size_t questions) {
    for (size_t i = 0; i < std::min(family.questions.size(), questions); ++i) {
        for (uint mode = 0; mode < cpu::kFloatModes; ++mode) {
            const std::string wrong = cpu::wrongCells(forest, family.questions[i], mode, tally);
            if (!wrong.empty()) return family.name + ", question " + std::to_string(i) + ": " + wrong + "\n" + show(family.questions[i]);
        }
    }
    return {};
}

}  // namespace gno::mutants
