// SPDX-License-Identifier: MIT
// Lights, objects and cameras far away: the mask against a raycaster of its own, in double, on the file's numbers: no grid, no line of the product.
#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "far_scene.hpp"
#include "host_min/frame/inputs.hpp"
#include "validation/support/device_test.hpp"

namespace gno {
namespace {

using glm::dvec3;
using host::test::Street;

constexpr uint32_t kWidth = 96, kHeight = 72;

struct World {
    std::vector<std::array<dvec3, 3>> triangles;
    dvec3 eye, right, up, forward;
    double half;  // tangent of half the vertical field of view
};

World worldOf(dvec3 at, double distance, double yfov) {
    World world;
    const auto quad = [&](dvec3 a, dvec3 b, dvec3 c, dvec3 d) {
        world.triangles.push_back({at + a, at + b, at + c});
        world.triangles.push_back({at + a, at + c, at + d});
    };
    quad({-10, 0, -10}, {-10, 0, 10}, {10, 0, 10}, {10, 0, -10});
    const auto corner = [&](int x, int y, int z) { return dvec3(x * 0.7, y * 1.3, z * 0.9); };
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side) {
            const auto point = [&](int u, int v) {
                int c[3];
                c[axis] = side, c[(axis + 1) % 3] = u, c[(axis + 2) % 3] = v;
                return corner(c[0], c[1], c[2]);
            };
            quad(point(0, 0), point(1, 0), point(1, 1), point(0, 1));
        }
    world.eye = at + distance * glm::normalize(dvec3(1, 4, 6));
    const double tilt = -std::asin(4 / std::sqrt(53.0)), turn = std::atan2(1.0, 6.0);
    world.right = {std::cos(turn), 0, -std::sin(turn)};
    world.forward = {-std::sin(turn) * std::cos(tilt), std::sin(tilt), -std::cos(turn) * std::cos(tilt)};
    world.up = glm::cross(world.right, world.forward);
    world.half = std::tan(yfov / 2);
    return world;
}

/// Distance along the ray to the nearest triangle behind `from`, in multiples of its direction; infinite: none.
double nearest(const World& world, dvec3 origin, dvec3 along, double from, size_t* which = nullptr) {
    double best = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < world.triangles.size(); ++i) {
        const auto& [a, b, c] = world.triangles[i];
        const dvec3 e = b - a, f = c - a, p = glm::cross(along, f);
        const double determinant = glm::dot(p, e);
        if (determinant == 0) continue;
        const dvec3 s = origin - a, q = glm::cross(s, e);
        const double u = glm::dot(s, p) / determinant, v = glm::dot(along, q) / determinant, t = glm::dot(f, q) / determinant;
        if (u < 0 || v < 0 || u + v > 1 || t <= from || t >= best) continue;
        best = t;
        if (which) *which = i;
    }
    return best;
}

std::vector<uint32_t> raycast(const World& world, glm::dvec4 light) {
    std::vector<uint32_t> mask;
    for (uint32_t y = 0; y < kHeight; ++y)
        for (uint32_t x = 0; x < kWidth; ++x) {
            const double sx = ((x + 0.5) / kWidth * 2 - 1) * world.half * kWidth / kHeight, sy = (1 - (y + 0.5) / kHeight * 2) * world.half;
            const dvec3 along = world.forward + sx * world.right + sy * world.up;
            size_t hit = 0;
            const double t = nearest(world, world.eye, along, 0, &hit);
            if (!(t < 1e300)) {
                mask.push_back(GNO_VISIBILITY_BACKGROUND);
                continue;
            }
            const auto& [a, b, c] = world.triangles[hit];
            dvec3 n = glm::normalize(glm::cross(b - a, c - a));
            if (glm::dot(n, along) > 0) n = -n;
            const dvec3 p = world.eye + t * along + 1e-6 * n, to = light.w != 0 ? dvec3(light) - p : dvec3(light);
            const bool dark = nearest(world, p, to, 0) < (light.w != 0 ? 1 : 1e300);
            mask.push_back(glm::dot(n, to) <= 0 ? GNO_VISIBILITY_FACING_AWAY : dark ? GNO_VISIBILITY_SHADOW : GNO_VISIBILITY_LIT);
        }
    return mask;
}

std::vector<uint32_t> maskOf(const host::Frame& frame, size_t light) {
    host::FrameInputs inputs(test::passes(), frame, kWidth, kHeight);
    inputs.setLight(frame.lights.at(light).homogeneous, host::Cull::none);
    host::Technique& technique = host::techniqueByName("d-hybrid");
    host::StructureCache structures;
    const std::vector<std::string> none;
    return technique.run(inputs, structures, host::Settings(technique.info().settings, none), {host::Precision::certified, 1, false, false})
        .visibility;
}

/// Pixels that differ and whose neighbours are all alike in `want`.
size_t wrongInside(const std::vector<uint32_t>& got, const std::vector<uint32_t>& want) {
    size_t wrong = 0;
    for (uint32_t y = 1; y + 1 < kHeight; ++y)
        for (uint32_t x = 1; x + 1 < kWidth; ++x) {
            bool inside = true;
            for (uint32_t v = y - 1; v <= y + 1; ++v)
                for (uint32_t u = x - 1; u <= x + 1; ++u) inside = inside && want[v * kWidth + u] == want[y * kWidth + x];
            wrong += inside && got[y * kWidth + x] != want[y * kWidth + x];
        }
    return wrong;
}

void expectRight(const Street& street, const World& world, glm::dvec4 light, size_t number = 0) {
    const host::Frame frame = street.file().evaluate(0, host::View{0, kWidth, kHeight, uint32_t(number)});
    const std::vector<uint32_t> want = raycast(world, light), got = maskOf(frame, number);
    EXPECT_EQ(wrongInside(got, want), 0u);
    EXPECT_GT(std::count(want.begin(), want.end(), GNO_VISIBILITY_SHADOW), 50);
    EXPECT_GT(std::count(want.begin(), want.end(), GNO_VISIBILITY_LIT), 1000);
    std::vector<uint32_t> shifted(want.begin() + 3, want.end());  // and the comparer can fail
    shifted.insert(shifted.end(), 3, GNO_VISIBILITY_LIT);
    EXPECT_GT(wrongInside(shifted, want), 0u);
}

const dvec3 kUp = glm::normalize(dvec3(0.4, 1, 0.3));

TEST(FarThings, Lights) {
    for (const double far : {1e1, 1e4, 1e6, 1e7, 1e8, 1.5e11, 1e15}) {
        SCOPED_TRACE(far);
        Street street;
        street.pointLight(kUp * far);
        street.pointLight({1.5, 4, 1});
        expectRight(street, worldOf(dvec3(0), 7, 0.7), {kUp * far, 1}, 0);
        expectRight(street, worldOf(dvec3(0), 7, 0.7), {1.5, 4, 1, 1}, 1);  // whatever another light does
    }
}

TEST(FarThings, Objects) {
    for (const double far : {1e3, 1e6, 1e7}) {
        SCOPED_TRACE(far);
        Street street;
        street.pointLight({1.5, 4, 1});
        street.triangleAt({0, far, -far}, 1);
        expectRight(street, worldOf(dvec3(0), 7, 0.7), {1.5, 4, 1, 1});
    }
}

TEST(FarThings, Cameras) {
    for (const double far : {1e2, 1e5, 1e7}) {
        SCOPED_TRACE(far);
        Street street(dvec3(0), far, 5 / far);
        street.pointLight({1.5, 4, 1});
        expectRight(street, worldOf(dvec3(0), far, 5 / far), {1.5, 4, 1, 1});
    }
}

TEST(FarThings, Origins) {
    for (const double far : {1e4, 1e6, 16777216.0}) {
        SCOPED_TRACE(far);
        const dvec3 at(far, 0, -far);
        Street street(at);
        street.pointLight(at + dvec3(1.5, 4, 1));
        expectRight(street, worldOf(at, 7, 0.7), {at + dvec3(1.5, 4, 1), 1});
    }
}

}  // namespace
}  // namespace gno
