// SPDX-License-Identifier: MIT
// Makers of scene_families.hpp: what a renderer meets, large and small: fields, rooms, soups, slivers.
#include "validation/mutants/scene_families.hpp"

namespace gno::mutants {

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

}  // namespace gno::mutants
