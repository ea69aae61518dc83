// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "host_min/error.hpp"
#include "host_min/scene/scene_data.hpp"
#include "host_min/scene/triangles.hpp"

namespace gno::host {

namespace {

// Makes a frame's triangles, one mesh instance after the other. Its buffers are reused.
class Assembler {
public:
    Assembler(const SceneFile::Data& data, const Pose& pose, Frame& frame) : data_(data), pose_(pose), frame_(frame) {}

    void run() {
        const auto total = static_cast<size_t>(data_.facts.trianglesInFile);
        frame_.triangles.reserve(total);
        frame_.material.reserve(total);
        frame_.object.reserve(total);
        frame_.oneSided.reserve(total);
        frame_.closed.reserve(total);
        forEachInstance(data_, pose_, [this](const Instance& instance) { add(instance); });
    }

private:
    void add(const Instance& instance) {
        size_t vertices = 0;
        for (const PrimitiveData& primitive : instance.mesh.primitives) vertices += primitive.positions.size();
        welder_.reset(vertices);
        welded_.clear();
        const size_t first = frame_.triangles.size();
        kept_.clear();
        for (const PrimitiveData& primitive : instance.mesh.primitives) addPrimitive(instance, primitive);
        const std::vector<uint8_t> closed = closedTriangles(welder_.points(), welded_);
        for (const uint32_t i : kept_) {
            frame_.closed.push_back(closed[i]);
            frame_.facts.closedTriangles += closed[i];
        }
        frame_.object.resize(frame_.object.size() + frame_.triangles.size() - first, object_++);
    }

    void addPrimitive(const Instance& instance, const PrimitiveData& primitive) {
        placeVertices(primitive, pose_.weights[instance.node], instance.world, instance.joints, world_);
        numbers_.resize(world_.size());
        for (size_t v = 0; v < world_.size(); ++v) numbers_[v] = welder_.number(frame_.grid.snap(world_[v]));
        for (size_t i = 0; i < primitive.triangles.size(); ++i) {
            const glm::uvec3 t = primitive.triangles[i];
            const glm::uvec3 n{numbers_[t.x], numbers_[instance.isMirrored ? t.z : t.y], numbers_[instance.isMirrored ? t.y : t.z]};
            const std::vector<glm::vec3>& points = welder_.points();
            const Triangle triangle{points[n.x], points[n.y], points[n.z]};
            welded_.push_back(n);
            if (n.x == n.y || n.y == n.z || n.z == n.x || isCollinear(triangle)) {
                ++frame_.facts.zeroArea;
                continue;
            }
            kept_.push_back(static_cast<uint32_t>(welded_.size() - 1));
            frame_.triangles.push_back(triangle);
            frame_.material.push_back(primitive.material);
            frame_.oneSided.push_back(!data_.look->materials[primitive.material].doubleSided);
            addSurface(primitive, i, instance.isMirrored);
        }
    }

    // Of the triangle that came last. The list of surfaces begins with the first triangle that is not opaque.
    void addSurface(const PrimitiveData& primitive, size_t triangle, bool isMirrored) {
        const bool isOpaque = primitive.corners.empty();
        if (isOpaque && frame_.surfaceOf.empty()) return;
        frame_.surfaceOf.resize(frame_.triangles.size(), kOpaque);
        if (isOpaque) return;
        frame_.surfaceOf.back() = static_cast<uint32_t>(frame_.surfaces.size());
        const uint32_t material = primitive.coloured.empty() ? primitive.material : primitive.coloured[triangle];
        Surface& surface = frame_.surfaces.emplace_back(Surface{primitive.corners[triangle], material});
        if (isMirrored) std::swap(surface.corners[1], surface.corners[2]);
    }

    const SceneFile::Data& data_;
    const Pose& pose_;
    Frame& frame_;
    uint32_t object_ = 0;
    PointWelder welder_;
    std::vector<glm::dvec3> world_;
    std::vector<uint32_t> numbers_;   // of welded points, one per vertex
    std::vector<glm::uvec3> welded_;  // the instance's triangles, those without area included
    std::vector<uint32_t> kept_;      // those of welded_ that have an area
};

}  // namespace

Box triangleBox(const SceneFile::Data& data, const Pose& pose) {
    Box box;
    std::vector<glm::dvec3> world;
    forEachInstance(data, pose, [&](const Instance& instance) {
        for (const PrimitiveData& primitive : instance.mesh.primitives) {
            placeVertices(primitive, pose.weights[instance.node], instance.world, instance.joints, world);
            for (const glm::dvec3& p : world) {
                const bool ok = std::abs(p.x) <= kLargestNumber && std::abs(p.y) <= kLargestNumber && std::abs(p.z) <= kLargestNumber;
                if (!ok) throw InputError(fmt::format("node {}: a vertex position is not finite, or exceeds 1e30", instance.node));
                box.add(p);
            }
        }
    });
    return box;
}

Frame evaluateFrame(const SceneFile::Data& data, double seconds, const View& view) {
    const Pose pose = poseAt(data, seconds);
    ViewGrid chosen = chooseGrid(data, seconds, pose, view);

    Frame frame;
    frame.facts = data.facts;
    frame.grid = chosen.grid;
    frame.harm = chosen.harm;
    frame.lights = std::move(chosen.lights);
    Assembler(data, pose, frame).run();
    if (frame.triangles.empty()) throw InputError("no triangle has an area: nothing can cast a shadow");
    if (!frame.surfaces.empty()) frame.look = data.look;
    frame.facts.duplicates = countDuplicates(frame.triangles);
    frame.camera = onGrid(cameraAt(data, pose, view.camera), frame.grid);
    constexpr double kNarrowest = 0x1p-30;  // some thousand steps of the grid, which all pixels would have to share
    if (!frame.camera.perspective && frame.camera.ymag < kNarrowest)
        throw InputError(fmt::format("camera {}: its ymag is too small for this scene, whose positions it would not tell apart", view.camera));
    for (std::string& notice : frameNotices(data, pose, frame)) frame.facts.notices.push_back(std::move(notice));
    frame.low = frame.high = frame.triangles.front().a;
    for (const Triangle& t : frame.triangles) {
        frame.low = glm::min(frame.low, glm::min(t.a, glm::min(t.b, t.c)));
        frame.high = glm::max(frame.high, glm::max(t.a, glm::max(t.b, t.c)));
    }
    return frame;
}

}  // namespace gno::host
