// SPDX-License-Identifier: MIT
// gnomon core/grid.hpp : what an engine does once on the host: the scene's grid. C++20, standard library only.
//
// Every position that a shader of ours sees is an fp32 number in [-1, 1] and a multiple of 2^-40 (README, "Conventions"). One grid serves casters,
// view samples and all lights of a frame; when it changes, everything that was snapped is snapped again. fp32 is finest near the grid's origin: put
// it where you look.
#ifndef GNO_CORE_GRID_HPP
#define GNO_CORE_GRID_HPP
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace gno {

using Double3 = std::array<double, 3>;
using Float3 = std::array<float, 3>;

inline constexpr int kGridBits = 40;  ///< positions are multiples of 2^-kGridBits

/// One coordinate (any finite double in [-2, 2]) to the nearest fp32 multiple of 2^-kGridBits. gnoSnapToGrid of core/sample.glsl does the same on
/// the device.
inline float snapCoordinate(double value) {
    // From 2^-17 on, an fp32 number is a multiple of 2^-40 by itself; below 2^-16, a multiple of 2^-40 has at most 24 bits and is an fp32 number.
    constexpr double step = 1.0 / (1ull << kGridBits);
    constexpr double floatIsEnough = 1.0 / (1 << 16);
    if (std::abs(value) < floatIsEnough) value = std::nearbyint(value * static_cast<double>(1ull << kGridBits)) * step;
    return static_cast<float>(value) + 0.0f;  // -0 + 0 = +0
}

/// grid position = (world position - origin) * 2^-exponent, rounded to fp32 and to multiples of 2^-kGridBits.
struct Grid {
    Double3 origin{};
    int exponent = 0;

    /// 2^-exponent: grid units per world unit.
    [[nodiscard]] double scale() const { return std::ldexp(1.0, -exponent); }
    [[nodiscard]] Float3 snap(const Double3& world) const {
        Float3 result{};
        for (std::size_t axis = 0; axis < 3; ++axis) result[axis] = snapCoordinate((world[axis] - origin[axis]) * scale());
        return result;
    }
    [[nodiscard]] Double3 world(const Double3& onGrid) const {
        Double3 result{};
        for (std::size_t axis = 0; axis < 3; ++axis) result[axis] = origin[axis] + onGrid[axis] * std::ldexp(1.0, exponent);
        return result;
    }
};

/// The grid with its origin at `origin` (rounded to a step of 2^(exponent - 16), so that a scene moved by a large power of two keeps its grid
/// positions bit by bit) whose [-1, 1] holds the box from `low` to `high` (casters, positional lights, samples; world units, finite) with a little
/// room to spare.
inline Grid gridAt(const Double3& origin, const Double3& low, const Double3& high) {
    constexpr double room =
        1.0 / 1024;  // what stays free between the scene and the borders of [-1, 1]; the rounding of the origin takes 2^-17 of it
    constexpr int originBits = 16, smallestExponent = -1000;  // 2^1000 is still a double
    Grid grid{origin, 0};
    double half = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) half = std::max({half, high[axis] - origin[axis], origin[axis] - low[axis]});
    if (!(half > 0)) return grid;
    int exponent = 0;
    const double mantissa = std::frexp(half, &exponent);  // half = mantissa * 2^exponent, mantissa in [0.5, 1)
    grid.exponent = std::max(mantissa <= 1 - room ? exponent : exponent + 1, smallestExponent);
    const int step = grid.exponent - originBits;
    for (double& axis : grid.origin) axis = std::ldexp(std::nearbyint(std::ldexp(axis, -step)), step);
    return grid;
}

/// The same around the middle of the box.
inline Grid gridAround(const Double3& low, const Double3& high) {
    Double3 middle{};
    for (std::size_t axis = 0; axis < 3; ++axis) middle[axis] = low[axis] * 0.5 + high[axis] * 0.5;
    return gridAt(middle, low, high);
}

/// A direction of any length but zero to its own power-of-two grid: largest component in [0.5, 1], multiples of 2^-kGridBits. A directional light's
/// GNO_LIGHT is this, pointing TOWARDS the light, with w = 0. Throws std::invalid_argument when it is zero or not finite.
inline Float3 snapDirection(const Double3& direction) {
    const double length = std::max({std::abs(direction[0]), std::abs(direction[1]), std::abs(direction[2])});
    if (!(length > 0) || !std::isfinite(length)) throw std::invalid_argument("a direction must be finite and must not be zero");
    int exponent = 0;
    (void)std::frexp(length, &exponent);
    Float3 result{};
    for (std::size_t axis = 0; axis < 3; ++axis) result[axis] = snapCoordinate(std::ldexp(direction[axis], -exponent));
    return result;
}

/// GnoClusterFrame of clusters/cluster.h, member by member: 96 bytes, std140.
struct ClusterFrame {
    std::array<float, 4> origin{}, right{}, down{}, forward{};
    std::array<std::uint32_t, 2> size{};
    std::uint32_t casterCount = 0, jobCapacity = 0, boxCapacity = 0, split = 0, extraPlanes = 0, frontCulled = 0;
};
static_assert(sizeof(ClusterFrame) == 96);

/// A camera as the view-sample clusters see it; the counts and switches are clusterUniform()'s (clusters/passes.hpp). `viewer`: its place on the
/// grid; `right`, `up`, `forward`: orthogonal unit vectors of the grid's space, of an image whose rows go down. `half`: the tangent of half the
/// vertical field of view; of an orthographic camera half its height, grid units.
inline ClusterFrame clusterFrame(const Double3& viewer, const Double3& right, const Double3& up, const Double3& forward, bool perspective,
                                 double half, std::uint32_t width, std::uint32_t height) {
    const auto vector = [](const Double3& v, float sign, float w) {
        return std::array<float, 4>{sign * static_cast<float>(v[0]), sign * static_cast<float>(v[1]), sign * static_cast<float>(v[2]), w};
    };
    const double aspect = static_cast<double>(width) / height;
    ClusterFrame frame;
    frame.origin = vector(viewer, 1, perspective ? 1.0f : 0.0f);
    frame.right = vector(right, 1, static_cast<float>(half * aspect));
    frame.down = vector(up, -1, static_cast<float>(half));
    frame.forward = vector(forward, 1, 0);
    frame.size = {width, height};
    return frame;
}

using Float4 = std::array<float, 4>;
/// GnoForestGrid of forest/cells.h, byte by byte.
struct ForestGrid {
    Float4 across{}, along{};
    float stepAcross = 0, stepAlong = 0;
    std::uint32_t resolution = 1, faces = 6;
};
static_assert(sizeof(ForestGrid) == 48);

/// Faces of a light's grid of cells.
constexpr std::uint32_t forestFaces(const Float4& light) { return light[3] != 0 ? 6 : 1; }

/// The contract's grid of cells for a light (GNO_LIGHT): six faces around a point, or for a direction one face that holds the box from `low` to
/// `high` (casters and samples; what lies beside it is clamped into the cells at the border, so a box of the casters is right, too).
inline ForestGrid forestGrid(const Float4& light, const Float3& low, const Float3& high, std::uint32_t resolution) {
    ForestGrid grid;
    grid.resolution = resolution;
    grid.faces = forestFaces(light);
    if (grid.faces == 6) {
        grid.across[3] = grid.along[3] = -1;
        grid.stepAcross = grid.stepAlong = 2.0f / static_cast<float>(resolution);
        return grid;
    }
    const auto dot = [](const Double3& a, const Double3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
    const auto cross = [](const Double3& a, const Double3& b) {
        return Double3{a[1] * b[2] - b[1] * a[2], a[2] * b[0] - b[2] * a[0], a[0] * b[1] - b[0] * a[1]};
    };
    const auto normalized = [&](const Double3& a) {
        const double scale = 1.0 / std::sqrt(dot(a, a));
        return Double3{a[0] * scale, a[1] * scale, a[2] * scale};
    };
    const Double3 towards = normalized({light[0], light[1], light[2]});
    const Double3 across = normalized(cross(towards, std::abs(towards[0]) < 0.6 ? Double3{1, 0, 0} : Double3{0, 1, 0}));
    const auto place = [&](const Double3& axis, Float4& stored, float& step) {
        double least = std::numeric_limits<double>::max(), greatest = -least;
        for (unsigned corner = 0; corner < 8; ++corner) {
            const double at = dot(axis, {(corner & 1) ? high[0] : low[0], (corner & 2) ? high[1] : low[1], (corner & 4) ? high[2] : low[2]});
            least = std::min(least, at);
            greatest = std::max(greatest, at);
        }
        stored = {static_cast<float>(axis[0]), static_cast<float>(axis[1]), static_cast<float>(axis[2]), static_cast<float>(least)};
        step = static_cast<float>(std::max(greatest - least, 1e-6) / resolution);
    };
    place(across, grid.across, grid.stepAcross);
    place(cross(towards, across), grid.along, grid.stepAlong);
    return grid;
}

}  // namespace gno
#endif
