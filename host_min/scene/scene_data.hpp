// SPDX-License-Identifier: MIT
// What remains of a glTF file after loading: checked references, decoded numbers. Internal to gnomon_scene.
#pragma once
#include <tiny_gltf.h>

#include <cstdint>
#include <filesystem>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "host_min/scene/accessors.hpp"
#include "host_min/scene/notices.hpp"
#include "host_min/scene/scene.hpp"
#include "host_min/scene/textures.hpp"

namespace gno::host {

inline constexpr uint64_t kMostTriangles = 1ull << 26;      ///< of all instances; keeps a small hostile file from asking for all memory
inline constexpr uint64_t kMostDisplacements = 1ull << 26;  ///< of all morph targets together
inline constexpr uint64_t kMostInstances = 1ull << 20;      ///< of EXT_mesh_gpu_instancing
inline constexpr int kAllClips = -1;
inline constexpr double kLargestNumber = 1e30;  ///< of matrices and world positions: products of a few stay finite

struct Box {
    glm::dvec3 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
    void add(glm::dvec3 point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    [[nodiscard]] bool isEmpty() const { return !(low.x <= high.x); }
};

struct Influence {
    uint32_t joint;  ///< index into SkinData::joints
    double weight;   ///< those of a vertex sum to 1
};

/// Triangles of one primitive, in the mesh's space. Only vertices that a triangle refers to are kept.
struct PrimitiveData {
    std::vector<glm::dvec3> positions;
    std::vector<std::vector<glm::dvec3>> targets;  ///< morph targets: displacements, one per position (empty: none)
    std::vector<glm::uvec3> triangles;
    std::vector<uint32_t> influenceStart;  ///< vertex v has influences [start[v], start[v + 1]); empty without joints
    std::vector<Influence> influences;
    uint32_t jointCount = 0;  ///< largest joint index + 1
    uint32_t material = 0;
    std::vector<std::array<glm::ivec2, 3>> corners;  ///< texel coordinates, one entry per triangle; empty for opaque materials
    std::vector<uint32_t> coloured;                  ///< material with vertex colours, one per triangle; empty without such colours
};

struct MeshData {
    std::vector<PrimitiveData> primitives;
    std::vector<double> weights;  ///< one per morph target
    size_t targetCount = 0;
    uint64_t triangleCount = 0, pointOrLinePrimitives = 0;
    uint64_t displacements = 0;  ///< of all morph targets
};

struct NodeData {
    std::string name;
    int parent = -1;
    bool inScene = false;
    bool isVisible = true;  ///< KHR_node_visibility; hides all below it, too
    bool hasMatrix = false;
    glm::dmat4 matrix{1.0};  ///< when hasMatrix; translation, rotation and scale are then its parts
    glm::dvec3 translation{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
    glm::dvec3 scale{1.0};
    int mesh = -1, skin = -1, camera = -1, light = -1;
    std::vector<double> weights;                         ///< of its mesh's morph targets
    std::vector<glm::dmat4> instances{glm::dmat4(1.0)};  ///< EXT_mesh_gpu_instancing; one identity without it
};

struct SkinData {
    std::vector<uint32_t> joints;  ///< nodes
    std::vector<glm::dmat4> inverseBind;
};

struct ChannelData {
    enum class Path { translation, rotation, scale, weights, visible };
    enum class Interpolation { linear, step, cubic };
    uint32_t node = 0;
    Path path = Path::translation;
    Interpolation interpolation = Interpolation::linear;
    size_t width = 3;                                   ///< numbers per value
    std::shared_ptr<const std::vector<double>> times;   ///< seconds, rising, at least one
    std::shared_ptr<const std::vector<double>> values;  ///< width numbers per time; cubic: in-tangent, value, out-tangent
};

/// An animation of the file.
struct ClipData {
    std::string name;
    std::vector<ChannelData> channels;  ///< in file order
    [[nodiscard]] double lastKeyframe() const;
};

/// All nodes at one moment.
struct Pose {
    std::vector<glm::dmat4> world;
    std::vector<std::vector<double>> weights;
    std::vector<uint8_t> visible;  ///< neither the node nor one above it is hidden
};

struct SceneFile::Data {
    std::filesystem::path path;
    std::shared_ptr<const MaterialSet> look;
    std::vector<MeshData> meshes;
    std::vector<NodeData> nodes;
    std::vector<uint32_t> order;  ///< all nodes, parents first
    std::vector<SkinData> skins;
    std::vector<ClipData> clips;                               ///< in file order
    int clip = 0;                                              ///< the one that is applied; kAllClips: all, a later one wins
    std::vector<Light> lights;                                 ///< as in the file; position and direction come from the node
    std::vector<Camera> cameras;                               ///< as in the file, lengths in world units
    std::vector<uint32_t> meshNodes, lightNodes, cameraNodes;  ///< nodes of the scene, in node order
    Box firstFrame;                                            ///< of the triangles of frame 0, world units
    SceneFacts facts;                                          ///< those that no frame changes
    Notices notices;                                           ///< of the file, whatever the frame
};

// meshes.cpp
MeshData loadMesh(const tinygltf::Model& model, size_t mesh, Accessors& accessors, Textures& textures);
// nodes.cpp: fills nodes, order, meshNodes, lightNodes and cameraNodes
void loadNodes(const tinygltf::Model& model, Accessors& accessors, SceneFile::Data& data);
/// The matrix of a node with these parts.
glm::dmat4 composed(const glm::dvec3& translation, const glm::dquat& rotation, const glm::dvec3& scale);
/// Throws InputError unless all numbers are finite and at most kLargestNumber.
void checkMatrix(const glm::dmat4& matrix, const std::string& what);
// animation.cpp
std::vector<ClipData> loadAnimations(const tinygltf::Model& model, Accessors& accessors, const SceneFile::Data& data, Notices& notices);
/// The clip that `word` (a number, a name, or "all") means. Throws InputError.
int clipByWord(const std::vector<ClipData>& clips, const std::string& word);
/// The clips that are applied.
std::span<const ClipData> appliedClips(const SceneFile::Data& data);
Pose poseAt(const SceneFile::Data& data, double seconds);
// skin.cpp
std::vector<SkinData> loadSkins(const tinygltf::Model& model, Accessors& accessors);
void loadInfluences(const tinygltf::Primitive& primitive, Accessors& accessors, const std::vector<uint32_t>& kept, PrimitiveData& result);
/// One matrix per joint: skin space to world.
std::vector<glm::dmat4> jointMatrices(const SkinData& skin, const Pose& pose);
/// World positions of a primitive's vertices; `world` places what has no joints.
void placeVertices(const PrimitiveData& primitive, const std::vector<double>& weights, const glm::dmat4& world,
                   const std::vector<glm::dmat4>& joints, std::vector<glm::dvec3>& out);
// lights_cameras.cpp
void loadLightsAndCameras(const tinygltf::Model& model, SceneFile::Data& data);
/// A light in world units. Light::homogeneous is not set.
struct PlacedLight {
    Light light;
    glm::dvec3 position;  ///< of point and spot lights
    glm::dvec3 towards;   ///< unit vector: against the direction in which it shines
    [[nodiscard]] bool isPositional() const { return light.kind != Light::Kind::directional; }
};
std::vector<PlacedLight> lightsAt(const SceneFile::Data& data, const Pose& pose);
/// A camera whose lengths and matrix (world from camera, in place of grid from camera) are in world units.
Camera cameraAt(const SceneFile::Data& data, const Pose& pose, uint32_t camera);
Camera onGrid(Camera camera, const Grid& grid);
// scene_notices.cpp
/// What is told of a file when all of it is loaded.
void tellOfScene(const tinygltf::Model& model, SceneFile::Data& data);
/// What is told of a frame besides.
std::vector<std::string> frameNotices(const SceneFile::Data& data, const Pose& pose, const Frame& frame);
// evaluate.cpp
Frame evaluateFrame(const SceneFile::Data& data, double seconds, const View& view);
/// The world box of all triangles that are visible; empty without any. Throws InputError when a position is not finite or exceeds kLargestNumber.
Box triangleBox(const SceneFile::Data& data, const Pose& pose);
// view_grid.cpp
struct ViewGrid {
    Grid grid;
    GridHarm harm;
    std::vector<Light> lights;  ///< all of the scene, on the grid
};
/// The grid for a view, what it does to the picture, and the lights on it. Throws InputError like triangleBox.
ViewGrid chooseGrid(const SceneFile::Data& data, double seconds, const Pose& pose, const View& view);

/// One mesh at one place.
struct Instance {
    uint32_t node;
    const MeshData& mesh;
    glm::dmat4 world;
    const std::vector<glm::dmat4>& joints;  ///< empty without a skin
    bool isMirrored;                        ///< its winding is flipped
};

/// Calls `use` with every visible Instance of the scene. A skin replaces its node's matrix; whether it mirrors, its first joint tells.
template <typename Use>
void forEachInstance(const SceneFile::Data& data, const Pose& pose, Use&& use) {
    for (const uint32_t i : data.meshNodes) {
        if (!pose.visible[i]) continue;
        const NodeData& node = data.nodes[i];
        std::vector<glm::dmat4> joints;
        if (node.skin >= 0) joints = jointMatrices(data.skins[static_cast<size_t>(node.skin)], pose);
        for (const glm::dmat4& instance : node.instances) {
            const glm::dmat4 world = pose.world[i] * instance;
            const bool isMirrored = glm::determinant(glm::dmat3(joints.empty() ? world : joints.front())) < 0;
            use(Instance{i, data.meshes[static_cast<size_t>(node.mesh)], world, joints, isMirrored});
        }
    }
}

}  // namespace gno::host
