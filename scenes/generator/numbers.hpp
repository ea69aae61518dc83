// SPDX-License-Identifier: MIT
// Numbers that are the same on every machine: a random generator of our own, and sine and cosine from +, - and * only.
#pragma once
#include <cstdint>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace gno::scenes {

inline constexpr double kPi = 3.14159265358979323846;

/// SplitMix64. Streams of different seeds are independent enough for scattering leaves. Draw once a statement, or inside braces: the order in
/// which a compiler evaluates the arguments of a call is its own.
class Random {
public:
    explicit Random(uint64_t seed) : state_(seed) {}
    uint64_t bits();
    double unit();                            ///< in [0, 1)
    double between(double low, double high);  ///< in [low, high)
    uint32_t below(uint32_t count);           ///< in [0, count); count > 0
    bool chance(double probability) { return unit() < probability; }
    glm::dvec3 direction();  ///< unit vector, uniform on the sphere

private:
    uint64_t state_;
};

/// Angles in radians; any size that a scene needs (|angle| < 1e6). Error below 1e-13.
double sine(double angle);
double cosine(double angle);

/// Unit quaternion that turns by `angle` radians around the unit vector `axis`, counter-clockwise seen from its tip.
glm::dquat turn(const glm::dvec3& axis, double angle);

/// Rotation of a node whose -z axis shall point from `eye` to `target`, with its y axis as far upwards as possible: camera, spot, sun.
glm::dquat lookAt(const glm::dvec3& eye, const glm::dvec3& target);

}  // namespace gno::scenes
