// SPDX-License-Identifier: MIT
// The definition of "in shadow", word for word and with the signs of the real numbers. Slow and plain: the fast oracle is tested against it.
//
// Positions are fp32 multiples of 2^-40 in [-2, 2] (the scene's grid, with room); a direction's components likewise. Nothing here has a bias.
// A light is homogeneous: xyz position and w = 1, or direction towards the light and w = 0.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "host_min/oracle.hpp"

namespace gno::host::oracle {

/// Sign (-1, 0 or 1) of det[a - o, b - o, c - o].
int orient3d(glm::vec3 o, glm::vec3 a, glm::vec3 b, glm::vec3 c);

/// orient3d(L, a, b, c); for a direction that is the sign of -det[L, b - a, c - a].
int orient3d(glm::vec4 light, glm::vec3 a, glm::vec3 b, glm::vec3 c);

/// orient3d(a, b, c, L); for a direction that is the sign of det[b - a, c - a, L].
int orient3d(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec4 light);

/// Every sign that the definition of one shadow volume asks for.
struct VolumeSigns {
    int facing;               ///< orient3d(A, B, C, L)
    int inside;               ///< orient3d(L, A, B, C)
    std::array<int, 3> side;  ///< orient3d(L, A, B, p), orient3d(L, B, C, p), orient3d(L, C, A, p)
    int cap;                  ///< orient3d(A, B, C, p)
};
VolumeSigns volumeSigns(const Triangle& caster, glm::vec4 light, glm::vec3 p);

/// Is p in the shadow volume with these signs? The caster is not edge-on, p is in the closed cone, and strictly behind.
/// The same in other words: the open segment from p to L (the ray from p along L, without p) meets the closed triangle in one point.
bool inShadow(const VolumeSigns& signs);

/// Does `caster` shadow p?
bool inShadowOf(const Triangle& caster, glm::vec4 light, glm::vec3 p);

/// The same with facing = orient3d(A, B, C, L) known and not zero; asks for no sign that it does not need.
bool inShadowOf(const Triangle& caster, glm::vec4 light, glm::vec3 p, int facing);

/// Every sample against every caster, on the calling thread. `caster` is the lowest index that shadows the sample; no witness, no times.
OracleAnswer bruteForce(const OracleQuestion& question);

}  // namespace gno::host::oracle
