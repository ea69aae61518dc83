// SPDX-License-Identifier: MIT
// Makers of scene_families.hpp: vertices and samples placed where one sign of one plane is zero or nearly so.
#include <algorithm>

#include "validation/mutants/scene_families.hpp"

namespace gno::mutants {

// Vertices of one caster on, or one unit beside, the plane of another; samples just behind it.
TinyScene nearlyCoplanar(Random& r) {
    TinyScene s;
    s.light = anyLight(r);
    const GnoCaster t{r.uniform(), r.uniform(), r.uniform()};
    const dvec3 a(t.a), ab = dvec3(t.b) - a, ac = dvec3(t.c) - a;
    const auto inside = [&] {
        const double x = 0.5 + 0.5 * r.real(), y = (1.0 - x) * (0.5 + 0.5 * r.real());
        const vec3 p = r.nudge(a + ab * x + ac * y);
        return r.below(2) == 0 ? r.neighbour(p) : p;
    };
    s.casters = {t, {inside(), inside(), inside()}, {inside(), inside(), inside()}};
    for (const GnoCaster& u : s.casters) {
        for (int i = 0; i < 8; ++i) addSample(s, r.neighbour(snap(behind(s.light, onCaster(r, u), 1.0 + std::ldexp(1.0, -r.below(8) - 18)))));
    }
    return s;
}

// Casters that share a vertex or an edge with another; their other vertices lie near its planes.
TinyScene touching(Random& r) {
    TinyScene s;
    s.light = anyLight(r);
    const bool fine = r.below(2) == 0;
    const auto point = [&] { return fine ? r.uniform(0.5) : r.lattice(2, 0.25); };
    if (!fine) s.light = latticeLight(r);
    const GnoCaster t{point(), point(), point()};
    s.casters.push_back(t);
    for (int i = 0; i < 4; ++i) {
        const vec3 v[3] = {t.a, t.b, t.c};
        const int j = r.below(3);
        const auto other = [&] {
            switch (r.below(5)) {
                case 0:
                    return v[(j + 1) % 3];
                case 1:
                    return snap(behind(s.light, onCaster(r, t), 1.0 + 0.5 * r.real()));
                case 2:
                    return r.neighbour(snap(dvec3(v[j]) + (dvec3(v[(j + 1) % 3]) - dvec3(v[j])) * (2.0 * r.real())));
                case 3:
                    return r.onPlane(t.a, t.b, t.c);
                default:
                    return point();
            }
        };
        const GnoCaster u{v[j], other(), other()};
        if (inScene(u.b) && inScene(u.c)) s.casters.push_back(u);
    }
    addEverywhere(r, s, 30);
    for (int i = 0; i < 8; ++i) addSample(s, snap(behind(s.light, dvec3(t.a) + (dvec3(t.b) - dvec3(t.a)) * (2.0 * r.real()), 1.0 + 0.8 * r.real())));
    return s;
}

namespace {

// A caster one vertex of which is as far from a lateral plane of another as the band and the margin reach; samples on the rays through that vertex.
TinyScene beside(Random& r, bool atTheBand) {
    TinyScene s;
    s.light = anyLight(r);
    const dvec3 l(vec3(s.light));
    const GnoCaster owner{r.uniform(), r.uniform(), r.uniform()};
    const dvec3 a(owner.a), e = dvec3(owner.b) - a, from = s.light.w != 0.0f ? a - l : -l;
    dvec3 n = glm::cross(from, e);
    const double slack = 8.0 * 0x1p-23 * glm::length(from) * glm::length(e) / glm::length(n) + 0x1p-20;  // the plane's own error and the band
    if (!(slack < 0.1)) return s;
    n = glm::normalize(n) * (r.below(2) == 0 ? 1.0 : -1.0);
    const double least = atTheBand ? 1.0 + 0.03 * (1.0 + r.real()) : r.below(2) == 0 ? 1.15 + 0.35 * r.real() : 2.0 * (1.0 + r.real());
    const auto beside = [&](double ratio) {
        const dvec3 on = (a - l * double(s.light.w)) * (s.light.w != 0.0f ? 0.6 + 0.4 * r.real() : 1.0) + e * (0.5 + r.real());
        const dvec3 moved = s.light.w != 0.0f ? on : on - l * (0.5 * r.real());
        const double scale = s.light.w != 0.0f ? glm::length(on) : 2.0 * 1.75;
        return snap(moved + l * double(s.light.w) + n * (ratio * slack * scale));
    };
    const auto more = [&] { return r.below(2) == 0 ? least : least + 3.0 * (1.0 + r.real()) * std::ldexp(1.0, r.below(16)); };
    const GnoCaster t{beside(least), beside(more()), beside(more())};
    if (!inScene(t.a) || !inScene(t.b) || !inScene(t.c)) return s;
    s.casters = {owner, t};
    for (int i = 0; i < (atTheBand ? 12 : 6); ++i) {
        const double k = 1.0 + (1.0 + r.real()) * (r.below(2) == 0 ? 1.0 : 0.1);
        const dvec3 v =
            r.below(2) == 0 ? dvec3(t.a) : dvec3(t.a) + (dvec3(r.below(2) == 0 ? t.b : t.c) - dvec3(t.a)) * std::ldexp(1.0, -r.below(20));
        addSample(s, snap(behind(s.light, v, k)));
    }
    return s;
}

}  // namespace

TinyScene besideLateralPlane(Random& r) { return beside(r, false); }

TinyScene besideBand(Random& r) { return beside(r, true); }

// An edge that points at the light; another caster touches it and has a vertex where a plane beside the whole first caster would be.
TinyScene touchingAtLight(Random& r) {
    TinyScene s;
    s.light = vec4(r.uniform(0.3), 1);
    const dvec3 l(vec3(s.light)), axis = glm::normalize(dvec3(r.real(), r.real(), r.real()) + 0.001);
    const auto thin = [&] { return std::ldexp(1.0, -8 - r.below(16)) * dvec3(r.real(), r.real(), r.real()); };
    const GnoCaster t{snap(l + axis * 0.3 + thin()), snap(l + axis * 0.6 + thin()),
                      snap(l + axis * (0.4 + 0.1 * r.real()) + (r.below(2) == 0 ? thin() : 0.2 * dvec3(r.real(), r.real(), r.real())))};
    const auto unit = [&](vec3 v) { return glm::normalize(dvec3(v) - l); };
    const dvec3 middle = glm::normalize(unit(t.a) + unit(t.b));
    const dvec3 across = unit(t.c) - middle * glm::dot(unit(t.c), middle);
    if (!(glm::length(across) > 1e-5)) return s;
    const dvec3 outward = -glm::normalize(across);
    const double tilt = std::fmax(std::fmax(glm::dot(outward, unit(t.a)), glm::dot(outward, unit(t.b))), 0.0) + (6.0 + 4.0 * r.real()) * 0x1p-20;
    const dvec3 n = glm::normalize(outward - middle * tilt), x(r.real(), r.real(), r.real());
    const vec3 onPlane = snap(l + 0.5 * (x - n * glm::dot(n, x))), free = snap(l + 0.5 * dvec3(r.real(), r.real(), r.real()));
    s.casters = {t, {r.below(2) == 0 ? t.a : t.b, onPlane, free}};
    addBehind(r, s, s.casters[1], 20);
    for (int i = 0; i < 20; ++i) {
        const dvec3 v(s.casters[1].a), to = dvec3(r.below(2) == 0 ? onPlane : free) - v;
        addSample(s, snap(behind(s.light, v + to * std::ldexp(1.0, -r.below(24)), 1.0 + 0.5 * (1.0 + r.real()))));
    }
    return s;
}

// Samples one unit behind the point of a caster that is nearest to the light.
TinyScene behindNearestPoint(Random& r) {
    TinyScene s;
    s.light = anyLight(r);
    const dvec3 l(vec3(s.light));
    const vec3 nearest = r.uniform(0.6);
    const dvec3 ray = s.light.w != 0.0f ? dvec3(nearest) - l : -l;
    const double tilt = r.below(3) == 0 ? 0.0 : r.below(2) == 0 ? std::ldexp(1.0, -r.below(24)) : 0.3;
    const auto corner = [&] {
        const dvec3 any(r.real(), r.real(), r.real());
        const dvec3 u = glm::normalize(ray);
        const dvec3 across = any - u * glm::dot(any, u);
        return snap(dvec3(nearest) + 0.3 * across + u * tilt * 0.3 * (1.0 + r.real()));
    };
    const bool atVertex = r.below(2) == 0;
    s.casters.push_back(atVertex ? GnoCaster{nearest, corner(), corner()} : GnoCaster{corner(), corner(), corner()});
    const GnoCaster& t = s.casters.front();
    for (int i = 0; i < 12; ++i) {
        const dvec3 on = tilt == 0.0 ? onCaster(r, t) : atVertex && i < 8 ? dvec3(nearest) : i % 3 == 0 ? dvec3(nearest) : onCaster(r, t);
        vec3 p = snap(behind(s.light, on, 1.0 + std::ldexp(1.0, -22 - r.below(3))));
        addSample(s, p);
        addSample(s, r.neighbour(p));
    }
    return s;
}

// A caster at a right angle to the light's direction whose vertices fp32 takes for deeper than they are, and samples just behind it that it takes
// for nearer.
TinyScene atRightAngle(Random& r) {
    TinyScene s;
    s.light = directional(dvec3(r.real(), r.real(), r.real()) + 0.01);
    const vec3 l(s.light);
    const auto roundedUp = [&](vec3 p) { return double(4.0f - ((l.x * p.x + l.y * p.y) + l.z * p.z)) - (4.0 - glm::dot(dvec3(l), dvec3(p))); };
    const auto best = [&](double sign, const auto& make) {
        vec3 chosen = make();
        for (int i = 0; i < 40; ++i) {
            const vec3 other = make();
            if (sign * roundedUp(other) > sign * roundedUp(chosen)) chosen = other;
        }
        return chosen;
    };
    const dvec3 o(r.uniform(0.5)), axis = glm::normalize(dvec3(l)), u = glm::normalize(glm::cross(axis, dvec3(0.6, 0.8, 0.1))),
                                   w = glm::cross(axis, u);
    const auto corner = [&](double x, double y) {
        return best(1.0, [&] { return snap(o + u * (x + 0.05 * r.real()) + w * (y + 0.05 * r.real())); });
    };
    const GnoCaster t{corner(0.3, 0.0), corner(-0.15, 0.25), corner(-0.15, -0.25)};
    s.casters.push_back(t);
    const dvec3 a(t.a), b(t.b), c(t.c);
    for (int i = 0; i < 4; ++i) {
        addSample(s, best(-1.0, [&] {
                      const double x = 0.5 + 0.4 * r.real(), y = (1.0 - x) * (0.5 + 0.4 * r.real());
                      return snap(a + (b - a) * x + (c - a) * y - axis * 0x1p-24);
                  }));
    }
    return s;
}

TinyScene oneQuestion(Random& r) {
    const auto& family = questions::kFamilies[r.below(int(std::size(questions::kFamilies)))];
    const questions::Question q = family.make(r);
    TinyScene s{q.light, {q.t}, {{q.p, GNO_NO_CASTER}}};
    for (int i = 0; i < 3; ++i) addBehind(r, s, q.t, 1);
    return s;
}

// Two large well-shaped casters on both sides of an edge: whatever fp32 thinks of the edge, one of them must have the sample.
TinyScene seam(Random& r) {
    TinyScene s;
    const dvec3 a(0.4 + 0.05 * r.real(), 0.05 * r.real(), 0.05 * r.real()), b(-0.4 + 0.05 * r.real(), 0.05 * r.real(), 0.05 * r.real());
    const dvec3 c(0.1 * r.real(), 0.1 * r.real(), 0.4), d(0.1 * r.real(), 0.1 * r.real(), -0.4);
    const dvec3 at(0.1 * r.real(), 0.5 + 0.1 * r.real(), 0.1 * r.real());
    s.light = r.below(2) == 0 ? vec4(snap(at), 1) : directional(at);
    const int turn = r.below(3);
    const double same = r.below(2) == 0 ? 1.0 : 0.0;  // 0: the end points agree in one coordinate, each of the three in turn
    const auto turned = [&](dvec3 v) { return dvec3(v[turn], v[(turn + 1) % 3], v[(turn + 2) % 3]); };
    const dvec3 sameB(b.x, glm::mix(a.y, b.y, same), glm::mix(a.z, b.z, same));
    const vec3 v[4] = {snap(turned(a)), snap(turned(sameB)), snap(turned(c)), snap(turned(d))};
    s.light = s.light.w != 0.0f ? vec4(snap(turned(at)), 1) : directional(turned(at));
    s.casters = {{v[0], v[1], v[2]}, {v[1], v[0], v[3]}};
    for (int i = 0; i < 8; ++i)
        addSample(s, snap(behind(s.light, dvec3(v[0]) + (dvec3(v[1]) - dvec3(v[0])) * (0.5 + 0.2 * r.real()), 1.5 + 0.3 * r.real())));
    return s;
}

TinyScene onOneCaster(Random& r) {
    TinyScene s;
    s.light = anyLight(r);
    s.casters.push_back({r.uniform(), r.uniform(), r.uniform()});
    addOwn(r, s, 0, 8);
    return s;
}

}  // namespace gno::mutants
