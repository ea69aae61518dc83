// SPDX-License-Identifier: MIT
#include "validation/oracle/definition.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace gno::host::oracle {

namespace {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

// fp32 to double is exact, so this is the input point itself.
Point point(glm::vec3 v) { return {double(v.x), double(v.y), double(v.z)}; }

// The vector from a to b as a point. Exact: both are multiples of 2^-40 and at most 2 in size, so b - a fits 43 bits of a double's 53.
Point difference(glm::vec3 a, glm::vec3 b) { return {double(b.x) - double(a.x), double(b.y) - double(a.y), double(b.z) - double(a.z)}; }

// Sign of det[u, v, w]. The predicate on four points, one of which is the origin, has CGAL's fast static filter; the one on vectors has not.
int determinantSign(const Point& u, const Point& v, const Point& w) { return int(CGAL::orientation(Point(0, 0, 0), u, v, w)); }

}  // namespace

int orient3d(glm::vec3 o, glm::vec3 a, glm::vec3 b, glm::vec3 c) { return int(CGAL::orientation(point(o), point(a), point(b), point(c))); }

int orient3d(glm::vec4 light, glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    const glm::vec3 l(light);
    return light.w != 0 ? orient3d(l, a, b, c) : -determinantSign(point(l), difference(a, b), difference(a, c));
}

int orient3d(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec4 light) {
    const glm::vec3 l(light);
    return light.w != 0 ? orient3d(a, b, c, l) : determinantSign(difference(a, b), difference(a, c), point(l));
}

VolumeSigns volumeSigns(const Triangle& t, glm::vec4 light, glm::vec3 p) {
    return {.facing = orient3d(t.a, t.b, t.c, light),
            .inside = orient3d(light, t.a, t.b, t.c),
            .side = {orient3d(light, t.a, t.b, p), orient3d(light, t.b, t.c, p), orient3d(light, t.c, t.a, p)},
            .cap = orient3d(t.a, t.b, t.c, p)};
}

bool inShadow(const VolumeSigns& s) {
    if (s.facing == 0) return false;
    for (const int side : s.side) {
        if (side != 0 && side != s.inside) return false;
    }
    return s.cap == -s.facing;
}

bool inShadowOf(const Triangle& caster, glm::vec4 light, glm::vec3 p) { return inShadow(volumeSigns(caster, light, p)); }

bool inShadowOf(const Triangle& t, glm::vec4 light, glm::vec3 p, int facing) {
    // inside = -facing: moving L from the fourth place to the first is an odd permutation.
    return orient3d(t.a, t.b, t.c, p) == -facing && orient3d(light, t.a, t.b, p) != facing && orient3d(light, t.b, t.c, p) != facing &&
           orient3d(light, t.c, t.a, p) != facing;
}

OracleAnswer bruteForce(const OracleQuestion& question) {
    OracleAnswer answer;
    const auto isCaster = [&](size_t i) { return question.isCaster.empty() || question.isCaster[i] != 0; };
    for (const OracleSample& sample : question.samples) {
        uint32_t found = kNoCaster;
        bool self = false;
        for (uint32_t i = 0; i < question.triangles.size() && found == kNoCaster; ++i) {
            if (!isCaster(i) || !inShadowOf(question.triangles[i], question.light, sample.position)) continue;
            if (i == sample.own) {
                self = true;
            } else {
                found = i;
            }
        }
        answer.inShadow.push_back(found != kNoCaster);
        answer.caster.push_back(found);
        if (self && found == kNoCaster) ++answer.selfShadowed;
    }
    return answer;
}

}  // namespace gno::host::oracle
