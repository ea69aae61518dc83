// SPDX-License-Identifier: MIT
// What the families share: shapes that are on the grid, and samples where signs are zero or nearly so.
#pragma once
#include <optional>
#include <vector>

#include "validation/support/device_test.hpp"
#include "validation/tests/oracle_cases.hpp"

namespace gno::hard {

using host::Triangle;
using host::cases::addBox;
using host::cases::addQuad;
using host::cases::Random;

/// The only way onto the grid: host::snapCoordinate.
glm::vec3 snapped(glm::dvec3 v);

/// A view sample at p on triangle `own` of the scene, moved off its plane to the light's side as core/sample.glsl does it (that very text, compiled
/// as C++). None when the triangle is seen edge-on or has no area, or when the result lies outside of [-1, 1].
std::optional<host::OracleSample> sampleOn(const test::Scene& scene, uint32_t own, glm::dvec3 p);

/// gnoPermute of core/permutation.glsl: the triangle that invocation `index` of a build inserts.
uint32_t permute(uint32_t index, uint32_t count, uint32_t seed);

/// An insertion seed that puts `triangle` first; the search starts at `from`.
uint32_t seedThatInsertsFirst(uint32_t triangle, uint32_t count, uint32_t from);

/// Adds a free sample when p, snapped, lies in [-1, 1].
void addFree(test::Scene& scene, glm::dvec3 p);
void addOn(test::Scene& scene, uint32_t own, glm::dvec3 p);

/// A point of a triangle: of its face, an edge or a vertex, by chance.
glm::dvec3 pointOf(const Triangle& t, Random& random);

/// p, moved away from the light by `step` times the distance to it (towards infinity: by `step` times the direction).
glm::dvec3 behind(glm::vec4 light, glm::dvec3 p, double step);

/// Samples of every kind until there are `count`: on triangles, behind and before their vertices, edges and faces, on a lattice, at the light,
/// anywhere, and neighbours of all these, one unit of the grid or one ulp beside.
void addHardSamples(test::Scene& scene, Random& random, size_t count);

/// The same without the free ones: on triangles only.
void addSurfaceSamples(test::Scene& scene, Random& random, size_t count);

/// A closed ball of 2 * slices * (stacks - 1) triangles; vertices snapped, shared ones stay shared.
void addBall(std::vector<Triangle>& out, glm::dvec3 centre, double radius, int slices, int stacks);

/// An upright blade of two triangles that stands at `foot` (and goes through what is there), up to `height`, turned by chance.
void addBlade(std::vector<Triangle>& out, Random& random, glm::dvec3 foot, double depth, double height, double width);

glm::vec4 pointLight(glm::dvec3 p);
glm::vec4 directionalLight(glm::dvec3 towardsLight);

}  // namespace gno::hard
