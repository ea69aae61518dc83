// SPDX-License-Identifier: MIT
#include "scenes/generator/numbers.hpp"

#include <cmath>

namespace gno::scenes {

uint64_t Random::bits() {
    state_ += 0x9e3779b97f4a7c15ull;
    uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
}

double Random::unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

double Random::between(double low, double high) { return low + (high - low) * unit(); }

uint32_t Random::below(uint32_t count) { return static_cast<uint32_t>(((bits() >> 32) * count) >> 32); }

glm::dvec3 Random::direction() {
    for (;;) {
        const double x = between(-1, 1);
        const double y = between(-1, 1);
        const double z = between(-1, 1);
        const double squared = x * x + y * y + z * z;
        if (squared > 0.01 && squared <= 1) return glm::dvec3(x, y, z) / std::sqrt(squared);
    }
}

namespace {

// Taylor series around 0; |angle| <= pi / 4.
double smallSine(double x) {
    const double s = x * x;
    double sum = 0;
    for (int n = 17; n >= 3; n -= 2) sum = (1 + sum) * (-s / (n * (n - 1)));
    return x * (1 + sum);
}

double smallCosine(double x) {
    const double s = x * x;
    double sum = 0;
    for (int n = 18; n >= 2; n -= 2) sum = (1 + sum) * (-s / (n * (n - 1)));
    return 1 + sum;
}

}  // namespace

double sine(double angle) {
    const double quarters = std::floor(angle / (kPi / 2) + 0.5);
    const double rest = angle - quarters * (kPi / 2);
    switch (static_cast<int64_t>(quarters) & 3) {
        case 0:
            return smallSine(rest);
        case 1:
            return smallCosine(rest);
        case 2:
            return -smallSine(rest);
        default:
            return -smallCosine(rest);
    }
}

double cosine(double angle) { return sine(angle + kPi / 2); }

glm::dquat turn(const glm::dvec3& axis, double angle) {
    const double s = sine(angle / 2);
    return {cosine(angle / 2), axis.x * s, axis.y * s, axis.z * s};
}

glm::dquat lookAt(const glm::dvec3& eye, const glm::dvec3& target) {
    const glm::dvec3 back = glm::normalize(eye - target);
    const glm::dvec3 up = std::abs(back.y) > 0.999 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
    const glm::dvec3 right = glm::normalize(glm::cross(up, back));
    return glm::normalize(glm::quat_cast(glm::dmat3(right, glm::cross(back, right), back)));
}

}  // namespace gno::scenes
