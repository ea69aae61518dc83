// SPDX-License-Identifier: MIT
// A face of a light's grid of cells, any light and any grid, for whoever places casters and samples in cells.
#pragma once
#include "host_min/techniques/cell_assignment.hpp"
#include "validation/mutants/scene_parts.hpp"

namespace gno::mutants {

/// Places on a face of a light's grid, in the coordinates of cells.glsl, and the points there.
struct Face {
    vec4 light{0, 0, 0, 1};
    GnoForestGrid grid{};
    uint face = 0;

    /// x and y on the face; t: how far in front of the light, in multiples of the face's distance (directional: along the light, from -1 to 1).
    [[nodiscard]] dvec3 at(double x, double y, double t) const {
        if (light.w == 0.0f) return dvec3(vec3(grid.across)) * x + dvec3(vec3(grid.along)) * y - glm::normalize(dvec3(vec3(light))) * t;
        dvec3 q;
        const int axis = int(face / 2);
        q[axis] = face % 2 == 0 ? t : -t;
        q[(axis + 1) % 3] = x * t;
        q[(axis + 2) % 3] = y * t;
        return dvec3(vec3(light)) + q;
    }
    [[nodiscard]] double x(double column) const { return double(grid.across.w) + column * double(grid.stepAcross); }
    [[nodiscard]] double y(double row) const { return double(grid.along.w) + row * double(grid.stepAlong); }
    [[nodiscard]] uint cell(uint column, uint row) const { return (face * grid.resolution + row) * grid.resolution + column; }
    /// Somewhere in front of the light; sometimes very near.
    [[nodiscard]] double depth(Random& r) const {
        return light.w == 0.0f ? r.real() : std::ldexp(1.0 + r.real() * 0.9, -r.below(5) * (1 + 4 * (r.below(8) == 0)));
    }
};

inline Face anyFace(Random& r, uint resolution) {
    Face f;
    if (r.below(2) == 0) {
        f.light = vec4(r.below(2) == 0 ? r.lattice(4, 0.125) : r.uniform(0.5), 1.0f);
        f.face = uint(r.below(6));
    } else {
        dvec3 towards(0);
        while (glm::length(towards) < 0.1)
            towards = r.below(3) == 0 ? dvec3(r.below(3) - 1, r.below(3) - 1, r.below(3) - 1) : dvec3(r.real(), r.real(), r.real());
        if (r.below(4) == 0) towards = dvec3(std::ldexp(r.real(), -20), 1.0, std::ldexp(r.real(), -23));
        f.light = directional(towards);
    }
    const vec3 low = r.below(2) == 0 ? vec3(-1) : vec3(r.uniform(0.5)) - 0.5f, high = r.below(2) == 0 ? vec3(1) : vec3(r.uniform(0.4)) + 0.6f;
    f.grid = host::forestGrid(f.light, glm::min(low, high), glm::max(low, high), resolution);
    return f;
}

inline bool inScene(const GnoCaster& t) { return mutants::inScene(t.a) && mutants::inScene(t.b) && mutants::inScene(t.c); }

}  // namespace gno::mutants
