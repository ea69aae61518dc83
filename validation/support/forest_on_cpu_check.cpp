// SPDX-License-Identifier: MIT
#include "validation/support/forest_on_cpu_check.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <set>

#include "validation/support/exact_reference.hpp"

namespace gno::cpu {
namespace {

using exact::Int128;
using exact::Vec;
using exact::operator-;
using Rational = mpq_class;
using Rational3 = std::array<Rational, 3>;

constexpr int64_t kBandsOne = int64_t(1) << 20;  // 1 / GNO_BAND
const Rational kSlack(2, kBandsOne);             // 2 GNO_BAND
const Rational kRadius(7, 4);                    // GNO_SCENE_RADIUS

/// On face f, z > 0 in front of it: written from the words of cells.glsl and with its own hands.
Vec onFace(uint face, const Vec& q) {
    const size_t axis = face / 2;
    Vec place{q[(axis + 1) % 3], q[(axis + 2) % 3], q[axis]};
    if (face % 2 == 1) place[2] = -place[2];
    return place;
}

Rational3 rational(vec3 v) { return {Rational(double(v.x)), Rational(double(v.y)), Rational(double(v.z))}; }
Rational dot(const Rational3& a, const Rational3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Rational3 cross(const Rational3& a, const Rational3& b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }
Rational3 minus(const Rational3& a, const Rational3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

struct Place {
    uint face, column, row;
};

Place placeOf(const GnoForestGrid& grid, uint cell) {
    return {cell / (grid.resolution * grid.resolution), cell % grid.resolution, cell / grid.resolution % grid.resolution};
}

/// Bounds of a column or row of a directional grid, widened; those at the border hold what lies beyond.
std::array<Rational, 2> boundsOf(vec4 axis, float step, uint resolution, uint at) {
    const Rational least{double(axis.w)}, width{double(step)}, slack = kSlack * kRadius, farthest = kRadius * (1 + kSlack);
    return {at == 0 ? Rational(-farthest) : Rational(least + int(at) * width - slack),
            at + 1 == resolution ? farthest : Rational(least + int(at + 1) * width + slack)};
}

bool holds(const CellQuestion& question, uint cell, vec3 p) {
    const GnoForestGrid& grid = question.grid;
    if (cell >= gnoCellCount(grid.resolution, grid.faces)) return false;
    const Place at = placeOf(grid, cell);
    if (question.light.w == 0.0f) {
        const Rational3 q = rational(p);
        const Rational x = dot(rational(vec3(grid.across)), q), y = dot(rational(vec3(grid.along)), q);
        const auto columns = boundsOf(grid.across, grid.stepAcross, grid.resolution, at.column),
                   rows = boundsOf(grid.along, grid.stepAlong, grid.resolution, at.row);
        return columns[0] <= x && x <= columns[1] && rows[0] <= y && y <= rows[1];
    }
    const Vec q = exact::fixed(p) - exact::fixed(vec3(question.light));
    if (q == Vec{0, 0, 0}) return true;  // the light itself is in no direction
    const Vec place = onFace(at.face, q);
    const auto within = [&](int64_t x, uint index) {  // x/z in [-1 + 2 index/R - 2E, -1 + 2 (index + 1)/R + 2E], times R z / 2E
        const int64_t r = grid.resolution, half = kBandsOne / 2;
        const Int128 scaled = Int128(x) * r * half, z = place[2];
        return scaled >= z * ((2 * int64_t(index) - r) * half - r) && scaled <= z * ((2 * int64_t(index) + 2 - r) * half + r);
    };
    return place[2] > 0 && within(place[0], at.column) && within(place[1], at.row);
}

/// Where p is, exactly, seen from the light: in the caster's closed cone, and strictly behind the caster.
struct Where {
    bool inCone, behind;
};

Where whereIs(vec4 light, const std::array<Vec, 3>& v, const Vec& p) {
    const int facing = exact::orient3dLight(light, v[0], v[1], v[2]);
    for (size_t i = 0; i < 3; ++i) {
        const int side = exact::orient3dLight(light, v[i], v[(i + 1) % 3], p);
        if (side != 0 && side != facing) return {false, false};
    }
    return {true, exact::inShadowOf(light, v[0], v[1], v[2], p)};
}

/// All directions of the cell, widened, pass through the inside of the caster.
bool covers(const CellQuestion& question, const std::array<Vec, 3>& v, uint face, uvec2 at) {
    const GnoForestGrid& grid = question.grid;
    const int facing = exact::orient3dLight(question.light, v[0], v[1], v[2]);
    if (question.light.w != 0.0f) {
        const Vec l = exact::fixed(vec3(question.light));
        const int64_t r = grid.resolution, half = kBandsOne / 2;
        for (int corner = 0; corner < 4; ++corner) {  // times R / 2E
            const auto bound = [&](uint index, bool upper) {
                return upper ? (2 * int64_t(index) + 2 - r) * half + r : (2 * int64_t(index) - r) * half - r;
            };
            const Vec place{bound(at.x, corner & 1), bound(at.y, corner & 2), (face % 2 ? -1 : 1) * r * half};
            Vec direction{};
            for (size_t i = 0; i < 3; ++i) direction[(face / 2 + 1 + i) % 3] = place[i];
            for (size_t i = 0; i < 3; ++i) {
                const exact::Wide n = exact::cross(v[i] - l, v[(i + 1) % 3] - l);
                if (exact::sign(direction[0] * n[0] + direction[1] * n[1] + direction[2] * n[2]) != facing) return false;
            }
        }
        return true;
    }
    const Rational3 u = rational(vec3(grid.across)), w = rational(vec3(grid.along)), d = rational(vec3(question.light));
    const auto columns = boundsOf(grid.across, grid.stepAcross, grid.resolution, at.x),
               rows = boundsOf(grid.along, grid.stepAlong, grid.resolution, at.y);
    const Rational farthest = kRadius * 7 / 4;  // |d.p| <= |d| |p|, |d| below sqrt(3)
    const Rational volume = dot(u, cross(w, d));
    for (int corner = 0; corner < 8; ++corner) {  // the point with these three products (Cramer)
        const Rational x = columns[corner & 1], y = rows[(corner >> 1) & 1], t = corner & 4 ? farthest : Rational(-farthest);
        const Rational3 wd = cross(w, d), du = cross(d, u), uw = cross(u, w);
        Rational3 p;
        for (size_t i = 0; i < 3; ++i) p[i] = (x * wd[i] + y * du[i] + t * uw[i]) / volume;
        for (size_t i = 0; i < 3; ++i) {
            const auto corners = std::array{question.t.a, question.t.b, question.t.c};
            const Rational3 a = rational(corners[i]), b = rational(corners[(i + 1) % 3]);
            if (-sgn(dot(d, cross(minus(b, a), minus(p, a)))) != facing) return false;
        }
    }
    return true;
}

std::string hex(vec3 v) {
    char line[96];
    std::snprintf(line, sizeof line, "(%a, %a, %a)", double(v.x), double(v.y), double(v.z));
    return line;
}

}  // namespace

CellTally& CellTally::operator+=(const CellTally& other) {
    points += other.points;
    shadowed += other.shadowed;
    alone += other.alone;
    missed += other.missed;
    covered += other.covered;
    return *this;
}

std::string wrongCells(const Forest& forest, const CellQuestion& question, uint floatMode, CellTally& tally) {
    const FloatMode mode(floatMode);
    const GnoForestGrid& grid = question.grid;
    const auto text = [&](const char* what, vec3 p, uint cell) {
        return std::string(what) + ", " + hex(p) + ", cell " + std::to_string(cell) + ", float mode " + std::to_string(floatMode);
    };
    std::vector<uint> asked(question.cells);
    for (const vec3 p : question.points) {
        ++tally.points;
        asked.push_back(forest.cellOf(question.light, grid, p));
        if (!holds(question, asked.back(), p)) return text("the point is not in its cell", p, asked.back());
    }
    const std::array<Vec, 3> v{exact::fixed(question.t.a), exact::fixed(question.t.b), exact::fixed(question.t.c)};
    if (forest.facing(question.light, question.t) == 0) return {};
    const CasterCells cells = forest.cellsOf(question.light, grid, question.t);
    for (size_t i = 0; i < question.points.size(); ++i) {
        const vec3 p = question.points[i];
        const Where where = whereIs(question.light, v, exact::fixed(p));
        if (!where.inCone) continue;
        const float depth = forest.depth(question.light, p);
        if (!where.behind) {
            if (depth > cells.most) return text("a point before the caster lies beyond `most`", p, 0);
            continue;
        }
        ++tally.shadowed;
        const uint cell = asked[question.cells.size() + i];
        const Place at = placeOf(grid, cell);
        const uvec4 r = cells.rectangles.at(at.face);
        if (at.column < r.x || at.column >= r.z || at.row < r.y || at.row >= r.w) return text("a shadowed point is outside the rectangle", p, cell);
        if (cells.missed(at.face, {at.column, at.row})) return text("a cell with a shadowed point is missed", p, cell);
        if (depth < cells.least) return text("a shadowed point is nearer than `least`", p, cell);
        tally.alone += (r.z - r.x) * (r.w - r.y) == 1;
    }
    for (const uint cell : std::set<uint>(asked.begin(), asked.end())) {
        const Place at = placeOf(grid, cell);
        tally.missed += cells.missed(at.face, {at.column, at.row});
        if (!cells.covered(at.face, {at.column, at.row})) continue;
        ++tally.covered;
        if (!covers(question, v, at.face, {at.column, at.row})) return text("the cell is not all covered", question.t.a, cell);
    }
    return {};
}

std::string wrongForest(Forest& forest, const TinyScene& scene, const GnoForestGrid& grid, const std::vector<uint8_t>& expected,
                        const ForestChoice& choice, uint floatMode) {
    const std::string how = "resolution " + std::to_string(grid.resolution) + ", view cull " + std::to_string(choice.viewCull) + ", cover " +
                            std::to_string(choice.cover) + ", float mode " + std::to_string(floatMode) + ": ";
    std::string doing = "build";
    try {
        const FloatMode mode(floatMode);
        forest.build(scene.casters, scene.light, grid, scene.samples, choice);
        std::set<std::pair<uint, uint>> seen;
        for (const GnoForestPair& pair : forest.pairs())
            if (pair.caster >= scene.casters.size() || pair.cell >= forest.cells().size() || !seen.insert({pair.caster, pair.cell}).second)
                return how + "a pair is missing, or there twice";
        if (seen.size() != std::min(forest.header().pairs, choice.capacity)) return how + "the pool is not filled";
        for (size_t i = 0; i < scene.samples.size(); ++i) {
            for (size_t q = 0; q < kTopQueries.size(); ++q) {
                doing = kTopQueryNames[q];
                const TopAnswer answer = forest.ask(kTopQueries[q], scene.samples[i]);
                if (answer.visibility == GNO_VISIBILITY_UNKNOWN) throw std::runtime_error("has no answer");
                const bool got = answer.inShadow;
                if (got != (expected[i] != 0))
                    return how + doing + ", sample " + std::to_string(i) + (got ? " is dark, should be lit" : " is lit, should be dark");
            }
        }
    } catch (const std::exception& error) {
        return how + doing + ": " + error.what();
    }
    return {};
}

std::string show(const CellQuestion& question) {
    TinyScene scene{question.light, {question.t}, {}};
    for (const vec3 p : question.points) scene.samples.push_back({p, GNO_NO_CASTER});
    const GnoForestGrid& g = question.grid;
    char line[256];
    std::snprintf(line, sizeof line, "resolution %u, across %a %a %a from %a by %a, along %a %a %a from %a by %a\n", g.resolution,
                  double(g.across.x), double(g.across.y), double(g.across.z), double(g.across.w), double(g.stepAcross), double(g.along.x),
                  double(g.along.y), double(g.along.z), double(g.along.w), double(g.stepAlong));
    return line + show(scene);
}

}  // namespace gno::cpu
