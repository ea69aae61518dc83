// SPDX-License-Identifier: MIT
#include "validation/mutants/cases.hpp"

#include <algorithm>

#include "validation/mutants/scene_parts.hpp"

namespace gno::mutants {
namespace {

vec4 anyLight(Random& r) {
    if (r.below(2) == 0) return vec4(r.uniform(), 1.0f);
    dvec3 towards(0);
    while (glm::length(towards) < 0.1) towards = dvec3(r.real(), r.real(), r.real());
    return directional(towards);
}

vec4 latticeLight(Random& r) {
    const vec3 at = r.lattice(4, 0.25);
    return r.below(2) == 0 || at == vec3(0) ? vec4(at, 1.0f) : directional(at);
}

TinyScene sharedEdges(Random& r) {
    TinyScene s;
    s.light =
        r.below(2) == 0 ? vec4(snap(dvec3(r.below(5) - 2, 3, r.below(5) - 2) * 0.25), 1.0f) : directional(dvec3(r.below(5) - 2, 2, r.below(5) - 2));
    addField(r, s, 3, 0.5, 0.0, 0.25);
    addEverywhere(r, s, 60);
    return s;
}

// The receiver is caster 0 and is inserted first in one of the orders.
TinyScene largeReceiver(Random& r) {
    TinyScene s;
    s.light = r.below(2) == 0 ? vec4(r.real(), 0.9, r.real(), 1) : directional(dvec3(r.real(), 1.5, r.real()));
    s.light = vec4(snap(dvec3(vec3(s.light))), s.light.w);
    s.casters.push_back({snap(dvec3(-1, -0.5, -1)), snap(dvec3(0, -0.5 + 0.1 * r.real(), 1)), snap(dvec3(1, -0.5 + 0.1 * r.real(), -1))});
    for (int i = 0; i < 16; ++i) {
        const dvec3 at(0.6 * r.real(), 0.3 * r.real(), 0.6 * r.real());
        const auto corner = [&] { return snap(at + 0.15 * dvec3(r.real(), r.real(), r.real())); };
        s.casters.push_back({corner(), corner(), corner()});
    }
    addOwn(r, s, 0, 40);
    for (int i = 0; i < 40; ++i) addSample(s, r.onPlane(s.casters[0].a, s.casters[0].b, s.casters[0].c));
    return s;
}

// Seen from so near, the arc between two vertices bulges far beyond both.
TinyScene largeNearLight(Random& r) {
    TinyScene s;
    s.light = vec4(snap(dvec3(0.01 * r.real(), 0.2, 0.01 * r.real())), 1);
    for (int i = 0; i < 10; ++i) {
        const double y = 0.2 - std::ldexp(1.0 + r.real() * 0.5, -r.below(7) - 1);
        const auto corner = [&] { return snap(dvec3(r.real(), y + 0.01 * r.real(), r.real())); };
        s.casters.push_back({corner(), corner(), corner()});
    }
    for (int i = 0; i < 6; ++i) {
        const dvec3 at(r.real(), -0.5, r.real());
        const auto corner = [&] { return snap(at * 0.8 + 0.1 * dvec3(r.real(), r.real(), r.real())); };
        s.casters.push_back({corner(), corner(), corner()});
    }
    addEverywhere(r, s, 60);
    for (int i = 0; i < 30; ++i) addSample(s, r.uniform());
    return s;
}

TinyScene room(Random& r) {
    TinyScene s;
    s.light = vec4(r.uniform(0.4), 1);
    addBox(s, dvec3(-0.95), dvec3(0.95));
    const dvec3 at(r.real() * 0.6, -0.7, r.real() * 0.6);
    addBox(s, at - 0.2, at + 0.2);
    addEverywhere(r, s, 60);
    for (int i = 0; i < 40; ++i) addSample(s, r.uniform());
    return s;
}

TinyScene sliversAtLight(Random& r) {
    TinyScene s;
    s.light = vec4(r.uniform(0.3), 1);
    for (int i = 0; i < 16; ++i) {
        const dvec3 o(r.real(), r.real(), r.real()), d = 0.2 * dvec3(r.real(), r.real(), r.real());
        const dvec3 b = r.below(2) == 0 ? o + d : dvec3(vec3(s.light)) + (o - dvec3(vec3(s.light))) * 0.5;
        s.casters.push_back({snap(o), snap(b), snap(o + d * std::ldexp(1.0, -10 - r.below(12)))});
    }
    addEverywhere(r, s, 60);
    return s;
}

// Edges along the light's direction, exactly or nearly: some casters are edge-on.
TinyScene edgesAlongDirection(Random& r) {
    TinyScene s;
    s.light = r.below(2) == 0 ? directional(dvec3(r.lattice(1, 1.0)) + dvec3(0, 0.5, 0)) : directional(dvec3(r.real(), r.real(), r.real()) + 0.01);
    if (r.below(3) == 0) s.light = directional(dvec3(0, 0, r.below(2) == 0 ? 1 : -1));
    const double size = std::ldexp(1.0, -r.below(8));
    for (int i = 0; i < 8; ++i) {
        const dvec3 a = size * dvec3(r.real(), r.real(), r.real()), along = dvec3(vec3(s.light)) * (size * r.real());
        const dvec3 off = size * std::ldexp(1.0, -r.below(24)) * dvec3(r.real(), r.real(), r.real());
        const dvec3 c = a + along * r.real() + size * std::ldexp(1.0, -r.below(20)) * dvec3(r.real(), r.real(), r.real());
        s.casters.push_back(
            {snap(a), snap(r.below(3) == 0 ? a + along : a + along + off), snap(r.below(2) == 0 ? c : size * dvec3(r.real(), r.real(), r.real()))});
    }
    addEverywhere(r, s, 40);
    for (int i = 0; i < 10; ++i) addSample(s, snap(size * dvec3(r.real(), r.real(), r.real())));
    return s;
}

TinyScene stacks(Random& r) {
    TinyScene s;
    s.light = anyLight(r);
    for (int i = 0; i < 28; ++i) s.casters.push_back({r.uniform(), r.uniform(), r.uniform()});
    addEverywhere(r, s, 40);
    return s;
}

// Big triangles that hardly shadow anything at the samples: the search goes through everything.
TinyScene crossedSlivers(Random& r) {
    TinyScene s;
    s.light = anyLight(r);
    for (int i = 0; i < 28; ++i) {
        const vec3 a = r.uniform(), b = r.uniform();
        s.casters.push_back({a, b, snap(dvec3(a) + 0.02 * dvec3(r.real(), r.real(), r.real()))});
    }
    addEverywhere(r, s, 60);
    return s;
}

TinyScene latticeSoup(Random& r) {
    TinyScene s;
    s.light = latticeLight(r);
    for (int i = 0; i < 9; ++i) s.casters.push_back({r.lattice(3, 0.25), r.lattice(3, 0.25), r.lattice(3, 0.25)});
    addEverywhere(r, s, 12);
    for (int i = 0; i < 12; ++i) addSample(s, r.lattice(8, 0.125));
    return s;
}

TinyScene anyExponent(Random& r) {
    TinyScene s;
    const double unit = std::ldexp(1.0, -r.below(38));
    const auto v = [&] { return r.below(2) == 0 ? r.anyExponent() : snap(unit * dvec3(r.real(), r.real(), r.real())); };
    const vec3 l = v();
    s.light = r.below(2) == 0 || l == vec3(0) ? vec4(l, 1.0f) : directional(l);
    for (int i = 0; i < 6; ++i) s.casters.push_back({v(), v(), v()});
    addEverywhere(r, s, 16);
    for (int i = 0; i < 4; ++i) addSample(s, v());
    return s;
}

TinyScene smallestUnits(Random& r) {
    TinyScene s;
    const double unit = questions::kUnit * std::ldexp(1.0, r.below(3) * 8);
    const vec3 l = r.lattice(4, unit);
    s.light = r.below(2) == 0 || l == vec3(0) ? vec4(l, 1.0f) : directional(l);
    for (int i = 0; i < 6; ++i) s.casters.push_back({r.lattice(4, unit), r.lattice(4, unit), r.lattice(4, unit)});
    for (int i = 0; i < 20; ++i) addSample(s, r.lattice(8, unit));
    return s;
}

// Casters in one another's shadow, many with exactly or nearly the same lateral planes.
TinyScene nested(Random& r) {
    TinyScene s;
    s.light = anyLight(r);
    const GnoCaster t{r.uniform(0.5), r.uniform(0.5), r.uniform(0.5)};
    for (int i = 0; i < 8; ++i) {
        const double k = r.below(4) == 0 ? 1.0 : 1.0 + 0.8 * r.real(), shrink = r.below(2) == 0 ? 1.0 : 0.3 + 0.6 * r.real();
        const dvec3 centre = (dvec3(t.a) + dvec3(t.b) + dvec3(t.c)) / 3.0;
        const auto corner = [&](vec3 v) { return snap(behind(s.light, centre + (dvec3(v) - centre) * shrink, k)); };
        const GnoCaster u{corner(t.a), corner(t.b), corner(t.c)};
        if (inScene(u.a) && inScene(u.b) && inScene(u.c)) s.casters.push_back(r.below(2) == 0 ? u : GnoCaster{u.b, u.a, u.c});
    }
    s.casters.push_back(t);
    addEverywhere(r, s, 30);
    return s;
}

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

struct Family {
    const char* name;
    Check check;
    int scenes;
    TinyScene (*make)(Random&);
};

constexpr Family kFamilies[] = {
    {"lattice soup", Check::tree, 1500, latticeSoup},
    {"shared edges of a height field", Check::tree, 150, sharedEdges},
    {"large receiver with casters above it", Check::tree, 150, largeReceiver},
    {"large casters near the light", Check::tree, 300, largeNearLight},
    {"light in a closed room", Check::tree, 150, room},
    {"slivers that point at the light", Check::tree, 400, sliversAtLight},
    {"edges along the light's direction", Check::tree, 800, edgesAlongDirection},
    {"many large casters, stacks overflow", Check::tree, 150, stacks},
    {"crossed slivers, stacks overflow", Check::tree, 150, crossedSlivers},
    {"casters in one another's shadow", Check::tree, 800, nested},
    {"nearly coplanar casters", Check::tree, 2500, nearlyCoplanar},
    {"casters that touch", Check::tree, 2500, touching},
    {"numbers of every size", Check::tree, 2000, anyExponent},
    {"smallest units of the grid", Check::tree, 1500, smallestUnits},
    {"touching an edge that points at the light", Check::tree, 3000, touchingAtLight},
    {"at a right angle to the light's direction", Check::tree, 1000, atRightAngle},
    {"just behind the nearest point", Check::tree, 5000, behindNearestPoint},
    {"vertex beside a lateral plane", Check::tree, 10000, besideLateralPlane},
    {"one caster and one point", Check::decision, 20000, oneQuestion},
    {"vertex at the band of a lateral plane, conservative", Check::nothingLost, 20000, besideBand},
    {"lattice soup, conservative", Check::nothingLost, 300, latticeSoup},
    {"seam between two casters, conservative", Check::conservative, 3000, seam},
    {"samples on one caster, conservative", Check::conservative, 3000, onOneCaster},
};

TinyScene alone(const TinyScene& s, size_t caster) {
    TinyScene result{s.light, {s.casters[caster]}, s.samples};
    for (GnoViewSample& sample : result.samples) sample.own = sample.own == caster ? 0 : GNO_NO_CASTER;
    return result;
}

std::vector<uint8_t> oneByOne(const TinyScene& s) {
    std::vector<uint8_t> all;
    for (size_t i = 0; i < s.casters.size(); ++i) {
        const std::vector<uint8_t> answers = exactAnswers(alone(s, i));
        all.insert(all.end(), answers.begin(), answers.end());
    }
    return all;
}

// Index of a sample that is lit among all casters and dark with one of them alone; the number of samples when there is none.
size_t firstLost(const TinyScene& s, const std::vector<uint8_t>& expected, cpu::TopTree& tree, uint mode) {
    const cpu::FloatMode floatMode(mode);
    const size_t count = s.samples.size();
    std::vector<uint8_t> dark(count);
    for (size_t i = 0; i < s.casters.size(); ++i) {
        const auto first = expected.begin() + std::ptrdiff_t(i * count);
        if (std::find(first, first + std::ptrdiff_t(count), 1) == first + std::ptrdiff_t(count)) continue;
        const TinyScene one = alone(s, i);
        tree.build(one.casters, one.light, GNO_PRECISION_CONSERVATIVE, std::vector<uint>{0});
        for (size_t k = 0; k < count; ++k) dark[k] |= expected[i * count + k] != 0 && tree.ask(cpu::TopQuery::dPsv, one.samples[k]).inShadow;
    }
    tree.build(s.casters, s.light, GNO_PRECISION_CONSERVATIVE, cpu::insertionOrder(uint(s.casters.size()), mode));
    for (size_t k = 0; k < count; ++k) {
        for (const cpu::TopQuery query : cpu::kTopQueries) {
            if (dark[k] && !tree.ask(query, s.samples[k]).inShadow) return k;
        }
    }
    return count;
}

std::string where(size_t scene, const std::string& what, const TinyScene& s) {
    std::string text = "scene ";
    text += std::to_string(scene);
    text += ", ";
    text += what;
    text += '\n';
    text += show(s);
    return text;
}

}  // namespace

std::vector<Case> makeCases() {
    std::vector<Case> cases;
    for (const Family& family : kFamilies) {
        uint64_t seed = 2016;  // of the name: a new family leaves the others as they are
        for (const char* letter = family.name; *letter != 0; ++letter) seed = seed * 1099511628211u + uint64_t(*letter);
        Random r(seed);
        Case c{family.name, family.check, {}, {}};
        for (int i = 0; i < family.scenes; ++i) {
            c.scenes.push_back(family.make(r));
            c.expected.push_back(family.check == Check::nothingLost ? oneByOne(c.scenes.back()) : exactAnswers(c.scenes.back()));
        }
        cases.push_back(std::move(c));
    }
    return cases;
}

std::string failure(const Case& c, cpu::TopTree& tree, size_t scenes) {
    for (size_t i = 0; i < std::min(c.scenes.size(), scenes); ++i) {
        const TinyScene& s = c.scenes[i];
        const uint mode = uint(i) % cpu::kFloatModes;
        if (c.check == Check::decision) {
            const cpu::FloatMode floatMode(mode);
            for (size_t k = 0; k < s.samples.size(); ++k) {
                const bool got = tree.decide(s.light, s.casters[0], s.samples[k].position, GNO_PRECISION_CERTIFIED);
                if (got != (c.expected[i][k] != 0)) return where(i, "decision on sample " + std::to_string(k), s);
            }
            continue;
        }
        if (c.check == Check::nothingLost) {
            const size_t lost = firstLost(s, c.expected[i], tree, mode);
            if (lost < s.samples.size()) return where(i, "sample " + std::to_string(lost) + " is lost", s);
            continue;
        }
        const uint precision = c.check == Check::conservative ? GNO_PRECISION_CONSERVATIVE : GNO_PRECISION_CERTIFIED;
        const uint count = uint(s.casters.size());
        std::vector<uint> order(count);
        for (uint way = 0; way < 3 && (way == 0 || count > 1); ++way) {  // forwards, backwards, the program's own
            for (uint k = 0; k < count; ++k) order[k] = way == 0 ? k : count - 1 - k;
            if (way == 2) order = cpu::insertionOrder(count, uint(i));
            const std::string wrong = firstWrong(tree, s, c.expected[i], precision, order, mode);
            if (!wrong.empty()) return where(i, wrong + ", order " + std::to_string(way), s);
        }
    }
    return {};
}

}  // namespace gno::mutants
