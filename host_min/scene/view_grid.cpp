// SPDX-License-Identifier: MIT
// Where a frame's grid has its origin, which lights are so far away that they count as directional, and what snapping does to the picture.
//
// fp32 is finest near the origin, so it lies where the picture is: as near the view's focus, the median of what the camera has before it, as the
// smallest grid that holds the scene allows (bands of directional lights are as wide as the grid), and at the focus itself when that is not fine
// enough. All lengths in pixels are first order: a small move, seen from the camera, over the size of a pixel at that depth.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "host_min/error.hpp"
#include "host_min/scene/scene_data.hpp"

namespace gno::host {

namespace {

using glm::dvec3;

constexpr double kIsFine = kHarmTold / 10;  // pixels: what moves a vertex by no more is fine enough
constexpr size_t kMostForFocus = 1 << 16;   // points of which the median is taken
constexpr double kArcsec = 180 * 3600 / std::numbers::pi;

/// The picture in camera space (world units; x right, y up, looking along -z).
class Picture {
public:
    Picture(const Camera& camera, uint32_t width, uint32_t height)
        : camera_(camera),
          turn_(glm::transpose(glm::dmat3(camera.gridFromCamera))),
          place_(camera.gridFromCamera[3]),
          half_(camera.perspective ? std::tan(camera.yfov / 2) : camera.ymag),
          aspect_(static_cast<double>(width) / height),
          height_(height) {}

    [[nodiscard]] dvec3 turned(dvec3 world) const { return turn_ * world; }
    [[nodiscard]] dvec3 seen(dvec3 world) const { return turn_ * (world - place_); }
    [[nodiscard]] const dvec3& place() const { return place_; }

    static constexpr int kPlanes = 6;
    /// >= 0: inside of plane `i`: left, right, bottom, top, near, far. Linear in p.
    [[nodiscard]] double inside(int i, dvec3 p) const {
        const double width = camera_.perspective ? -p.z * half_ : half_;
        switch (i) {
            case 0:
                return width * aspect_ + p.x;
            case 1:
                return width * aspect_ - p.x;
            case 2:
                return width + p.y;
            case 3:
                return width - p.y;
            case 4:
                return -p.z - camera_.znear;
            default:
                return camera_.zfar > 0 ? camera_.zfar + p.z : 0;
        }
    }
    [[nodiscard]] unsigned outside(dvec3 p) const {
        unsigned planes = 0;
        for (int i = 0; i < kPlanes; ++i) planes |= inside(i, p) >= 0 ? 0u : 1u << i;
        return planes;
    }
    /// World units that a pixel at p is high.
    [[nodiscard]] double pixelAt(dvec3 p) const { return 2 * half_ * (camera_.perspective ? -p.z : 1) / height_; }
    /// By how many pixels p moves in the picture, when it moves by `move`.
    [[nodiscard]] double pixels(dvec3 p, dvec3 move) const {
        const double x = camera_.perspective ? move.x - move.z * p.x / p.z : move.x;
        const double y = camera_.perspective ? move.y - move.z * p.y / p.z : move.y;
        return std::hypot(x, y) / pixelAt(p);
    }

private:
    const Camera& camera_;
    glm::dmat3 turn_;
    dvec3 place_;
    double half_, aspect_, height_;
};

/// What a camera has before it.
class Before {
public:
    Before(const SceneFile::Data& data, const Pose& pose, const Picture& picture) : picture_(picture) {
        forEachInstance(data, pose, [&](const Instance& instance) {
            for (const PrimitiveData& primitive : instance.mesh.primitives) {
                placeVertices(primitive, pose.weights[instance.node], instance.world, instance.joints, world_);
                add(primitive);
            }
        });
    }

    /// Largest distance, pixels, by which snapping to `grid` moves something.
    [[nodiscard]] double moved(const Grid& grid) const {
        const auto moveOf = [&](dvec3 p) { return picture_.turned(grid.world(grid.snap(p)) - p); };
        double most = 0;
        for (const dvec3& p : vertices_) most = std::max(most, picture_.pixels(picture_.seen(p), moveOf(p)));
        for (const Cut& cut : cuts_) {
            const auto& v = cut.vertices;
            const std::array<dvec3, 3> moves{moveOf(v[0]), moveOf(v[1]), moveOf(v[2])};
            const dvec3 normal = direction(glm::cross(picture_.turned(v[1] - v[0]), picture_.turned(v[2] - v[0])));
            for (size_t i = cut.first; i < cut.last; ++i) {
                const dvec3 w = corners_[i];
                dvec3 move = w.x * moves[0] + w.y * moves[1] + w.z * moves[2];
                // A plane that slides in itself and an edge that slides along itself stay where they are.
                const int opposite = w.x == 0 ? 0 : w.y == 0 ? 1 : w.z == 0 ? 2 : -1;
                if (opposite < 0)
                    move = normal * glm::dot(move, normal);
                else {
                    const dvec3 edge = direction(picture_.turned(v[(opposite + 2) % 3] - v[(opposite + 1) % 3]));
                    move -= edge * glm::dot(move, edge);
                }
                most = std::max(most, picture_.pixels(picture_.seen(cutPoints_[i]), move));
            }
        }
        return most;
    }

    [[nodiscard]] bool empty() const { return vertices_.empty() && cutPoints_.empty(); }
    /// The median of each coordinate: where the picture is.
    [[nodiscard]] dvec3 focus() const {
        dvec3 result;
        const size_t stride = (vertices_.size() + cutPoints_.size()) / kMostForFocus + 1;
        for (int axis = 0; axis < 3; ++axis) {
            std::vector<double> values;
            size_t number = 0;
            forEach([&](dvec3 p) {
                if (number++ % stride == 0) values.push_back(p[axis]);
            });
            const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
            std::nth_element(values.begin(), middle, values.end());
            result[axis] = *middle;
        }
        return result;
    }
    /// Largest angle, radians, between the directions to two places of a light, from all that is seen. What lies nearer than a pixel is left out.
    [[nodiscard]] double angle(dvec3 light, dvec3 other) const {
        double most = 0;
        forEach([&](dvec3 p) {
            const dvec3 to = light - p;
            const double length = glm::length(to);
            if (length > picture_.pixelAt(picture_.seen(p))) most = std::max(most, glm::length(glm::cross(to / length, other - light)) / length);
        });
        return most;
    }
    /// Largest distance, pixels, by which a boundary of a shadow moves when a light at `light` becomes one in the direction in which `focus` sees
    /// it; infinite when a caster in the box might stand behind the light, or when that turns it by more than kFarTurn: surfaces would face it
    /// otherwise.
    [[nodiscard]] double parallax(dvec3 light, dvec3 focus, const Box& casters) const {
        const dvec3 fixed = direction(light - focus);
        double most = 0;
        forEach([&](dvec3 p) {
            const double length = glm::length(light - p), throughBox = leaves(casters, p, fixed);
            const double turned = glm::length((light - p) / length - fixed);
            const bool isFar = turned <= kFarTurn && throughBox < length / 2;
            most = std::max(most, isFar ? turned * throughBox / picture_.pixelAt(picture_.seen(p)) : std::numeric_limits<double>::infinity());
        });
        return most;
    }

private:
    template <typename Use>
    void forEach(Use&& use) const {
        for (const dvec3& p : vertices_) use(p);
        for (const dvec3& p : cutPoints_) use(p);
    }
    static dvec3 direction(dvec3 v) {
        const double size = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
        return size > 0 ? glm::normalize(v / size) : dvec3(0);
    }
    /// Where the ray from p, which lies in the box, leaves it.
    static double leaves(const Box& box, dvec3 p, dvec3 along) {
        double nearest = std::numeric_limits<double>::infinity();
        for (int axis = 0; axis < 3; ++axis)
            if (along[axis] != 0) nearest = std::min(nearest, ((along[axis] > 0 ? box.high : box.low)[axis] - p[axis]) / along[axis]);
        return std::max(nearest, 0.0);
    }

    void add(const PrimitiveData& primitive) {
        outside_.clear();
        for (const dvec3& p : world_) {
            outside_.push_back(picture_.outside(picture_.seen(p)));
            if (outside_.back() == 0) vertices_.push_back(p);
        }
        for (const glm::uvec3 t : primitive.triangles) {
            const unsigned a = outside_[t.x], b = outside_[t.y], c = outside_[t.z];
            if ((a | b | c) != 0 && (a & b & c) == 0) clip({world_[t.x], world_[t.y], world_[t.z]});
        }
    }

    void clip(const std::array<dvec3, 3>& vertices) {
        const std::array<dvec3, 3> seen{picture_.seen(vertices[0]), picture_.seen(vertices[1]), picture_.seen(vertices[2])};
        std::vector<dvec3> part{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, next;
        const auto at = [&](dvec3 w) { return w.x * seen[0] + w.y * seen[1] + w.z * seen[2]; };
        for (int plane = 0; plane < Picture::kPlanes && !part.empty(); ++plane) {
            next.clear();
            for (size_t i = 0; i < part.size(); ++i) {
                const dvec3 p = part[i], q = part[(i + 1) % part.size()];
                const double dp = picture_.inside(plane, at(p)), dq = picture_.inside(plane, at(q));
                if (dp >= 0) next.push_back(p);
                if ((dp < 0 && dq > 0) || (dp > 0 && dq < 0)) next.push_back(p + (q - p) * (dp / (dp - dq)));
            }
            part.swap(next);
        }
        if (part.empty()) return;
        const size_t first = corners_.size();
        for (const dvec3& w : part) {
            corners_.push_back(w);
            cutPoints_.push_back(w.x * vertices[0] + w.y * vertices[1] + w.z * vertices[2]);
        }
        cuts_.push_back({vertices, first, corners_.size()});
    }

    /// A triangle that the picture's border cuts, and the corners of the part inside: weights of the triangle's vertices.
    struct Cut {
        std::array<dvec3, 3> vertices;
        size_t first, last;  // of corners_
    };

    const Picture& picture_;
    std::vector<dvec3> vertices_;             // inside the picture; world units
    std::vector<dvec3> corners_, cutPoints_;  // weights, and places in world units
    std::vector<Cut> cuts_;
    std::vector<dvec3> world_;       // of the primitive at hand
    std::vector<unsigned> outside_;  // of its vertices
};

/// A light as the grid sees it.
struct SeenLight {
    bool asked, far;
    double parallax;
    dvec3 towards;  // of directional and far ones
};

class Chooser {
public:
    Chooser(const SceneFile::Data& data, const Pose& pose, const View& view)
        : box_(triangleBox(data, pose)),
          camera_(cameraAt(data, pose, view.camera)),
          picture_(camera_, view.width, view.height),
          before_(data, pose, picture_),
          focus_(before_.empty() ? box_.low * 0.5 + box_.high * 0.5 : before_.focus()),
          held_(box_),
          lights_(lightsAt(data, pose)) {
        for (size_t i = 0; i < lights_.size(); ++i) {
            const PlacedLight& light = lights_[i];
            SeenLight seen{!view.light || *view.light == i, false, 0, light.towards};
            if (seen.asked && light.isPositional() && !before_.empty()) {
                seen.parallax = before_.parallax(light.position, focus_, box_);
                seen.far = seen.parallax < kFarParallax;
                if (seen.far) seen.towards = light.position - focus_;
            }
            if (seen.asked && light.isPositional() && !seen.far) held_.add(light.position);
            seen_.push_back(seen);
        }
    }

    [[nodiscard]] bool isGood(const Grid& grid) const { return grid.holds(held_.low, held_.high) && before_.moved(grid) < kHarmTold; }

    [[nodiscard]] Grid choose() const {
        Grid best = smallest();
        double least = before_.moved(best);
        if (least <= kIsFine) return best;
        for (const Grid& other : {Grid::at(focus_, held_.low, held_.high), Grid::at(picture_.place(), held_.low, held_.high)}) {
            const double moved = before_.moved(other);
            if (!(moved < least)) continue;
            least = moved;
            best = other;
        }
        return best;
    }

    [[nodiscard]] ViewGrid on(const Grid& grid) const {
        ViewGrid result{grid, {}, {}};
        result.harm.movedPixels = before_.moved(grid);
        const auto reach = [&](dvec3 p) {
            const dvec3 d = glm::abs(p - grid.origin);
            return std::max({d.x, d.y, d.z});
        };
        result.harm.reach = std::max(reach(box_.low), reach(box_.high));
        for (size_t i = 0; i < lights_.size(); ++i) {
            Light light = lights_[i].light;
            const bool isPoint = lights_[i].isPositional() && !seen_[i].far;
            light.isFar = seen_[i].far;
            light.parallaxPixels = seen_[i].far ? seen_[i].parallax : 0;
            if (isPoint)
                light.homogeneous = glm::vec4(grid.snap(lights_[i].position), 1.0f);
            else
                light.homogeneous = glm::vec4(snapDirection(seen_[i].towards), 0.0f);
            if (seen_[i].asked) {
                const double turned = isPoint ? before_.angle(lights_[i].position, grid.world(dvec3(light.homogeneous)))
                                              : glm::length(glm::cross(glm::normalize(seen_[i].towards), glm::normalize(dvec3(light.homogeneous))));
                result.harm.lightArcsec = std::max(result.harm.lightArcsec, turned * kArcsec);
                if (isPoint && reach(lights_[i].position) > result.harm.reach) {
                    result.harm.reach = reach(lights_[i].position);
                    result.harm.forLight = static_cast<int>(i);
                }
            }
            result.lights.push_back(std::move(light));
        }
        return result;
    }

private:
    /// Of the grids with the smallest exponent the one whose origin is nearest to the focus.
    [[nodiscard]] Grid smallest() const {
        const Grid middle = Grid::around(held_.low, held_.high);
        const double reach = std::ldexp(1 - 2.0 / 1024, middle.exponent);  // with a little more room than Grid::at wants
        dvec3 origin;
        for (int axis = 0; axis < 3; ++axis) {
            const double from = held_.high[axis] - reach, to = held_.low[axis] + reach;
            origin[axis] = from <= to ? std::clamp(focus_[axis], from, to) : middle.origin[axis];
        }
        const Grid grid = Grid::at(origin, held_.low, held_.high);
        return grid.exponent <= middle.exponent ? grid : middle;
    }

    Box box_;
    Camera camera_;
    Picture picture_;
    Before before_;
    dvec3 focus_;
    Box held_;  // by the grid: triangles and lights
    std::vector<PlacedLight> lights_;
    std::vector<SeenLight> seen_;
};

}  // namespace

ViewGrid chooseGrid(const SceneFile::Data& data, double seconds, const Pose& pose, const View& view) {
    if (triangleBox(data, pose).isEmpty()) throw InputError("all meshes are hidden in this frame (KHR_node_visibility): nothing can cast a shadow");
    const Chooser chooser(data, pose, view);
    std::optional<Grid> kept = view.before;
    if (const Pose first = poseAt(data, 0.0); !kept && seconds > 0 && !triangleBox(data, first).isEmpty())
        kept = Chooser(data, first, view).choose();
    ViewGrid result = chooser.on(kept && chooser.isGood(*kept) ? *kept : chooser.choose());
    result.harm.changed = view.before && !(*view.before == result.grid);
    return result;
}

}  // namespace gno::host
