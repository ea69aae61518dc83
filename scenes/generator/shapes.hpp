// SPDX-License-Identifier: MIT
// Solids and blades. Every solid is closed by itself: each edge belongs to two triangles that run along it in opposite directions.
#pragma once
#include <vector>

#include "scenes/generator/mesh.hpp"

namespace gno::scenes {

using Path = std::vector<glm::dvec3>;

/// 12 triangles.
void addBox(Mesh& mesh, const glm::dvec3& low, const glm::dvec3& high);
/// Box of full `size` around `centre`, turned.
void addBox(Mesh& mesh, const glm::dvec3& centre, const glm::dvec3& size, const glm::dquat& rotation);

/// A convex polygon in x and z, counter-clockwise seen from below (x to z), stands from y = low to y = high. 4 n - 4 triangles.
void addPrism(Mesh& mesh, const std::vector<glm::dvec2>& polygon, double low, double high);

/// A ridge along z over the rectangle [low, high] in x and z: gable roof, ramp, tent. 8 triangles.
void addGable(Mesh& mesh, const glm::dvec3& low, const glm::dvec3& high);

/// Turns the profile (radius, y), which runs upwards from a point on the axis to another one, around the y axis.
/// First and last radius are 0, those between are positive.
void addLathe(Mesh& mesh, const std::vector<glm::dvec2>& profile, int sides, const Placement& placement = {});

void addCylinder(Mesh& mesh, const glm::dvec3& foot, const glm::dvec3& head, double footRadius, double headRadius, int sides);
void addBall(Mesh& mesh, const glm::dvec3& centre, const glm::dvec3& radii, int sides);

/// A round tube along `path`, capped, or a ring when `ring` is set (the last point then joins the first). Radii: one for all points.
void addTube(Mesh& mesh, const Path& path, double radius, int sides, bool ring = false);
/// The same with the radius falling linearly from `first` to `last`.
void addTaperedTube(Mesh& mesh, const Path& path, double first, double last, int sides);

/// A gutter along `path`, open upwards: half a pipe of the given wall thickness, closed as a solid.
void addGutter(Mesh& mesh, const Path& path, double radius, double thickness, int sides);

/// A folded leaf: a flat tetrahedron from `stem` along `along`, `width` wide. 4 triangles, closed.
void addLeaf(Mesh& mesh, const glm::dvec3& stem, const glm::dvec3& along, const glm::dvec3& up, double width);

/// A blade without thickness: 2 * parts - 1 triangles from `root`, `width` wide there, bent by `bend` at the tip. Not closed.
void addBlade(Mesh& mesh, const glm::dvec3& root, const glm::dvec3& growth, const glm::dvec3& side, const glm::dvec3& bend, double width, int parts);

/// `count` + 1 points from `a` to `b`, hanging by `sag` in the middle.
Path hangingPath(const glm::dvec3& a, const glm::dvec3& b, double sag, int count);
/// `count` points on a circle (not repeated), from `from` over angle `sweep`; the plane is spanned by `u` and `v`.
Path arcPath(const glm::dvec3& centre, const glm::dvec3& u, const glm::dvec3& v, double from, double sweep, int count);

}  // namespace gno::scenes
