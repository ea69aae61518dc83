// SPDX-License-Identifier: MIT
// The scenes that come with the repository: every one of them loads, and has the triangles that its source had.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "host_min/scene/grid.hpp"
#include "host_min/scene/scene.hpp"

namespace gno::host {
namespace {

const std::filesystem::path kScenes = GNOMON_SCENES_DIR;

const std::map<std::string, uint64_t> kTriangles{
    {"cooktop", 18804},          {"crib", 51826},      {"fence", 19368},          {"flower_box", 60886},      {"plant_decorative", 63428},
    {"spiral_staircase", 14656}, {"table_fan", 35956}, {"table_football", 39254}, {"truck_peterbilt", 116501}};

TEST(Shipped, TriangleCounts) {
    for (const auto& [name, count] : kTriangles) {
        const Frame frame = SceneFile::load(kScenes / name / (name + ".glb")).evaluate(0, 0);
        EXPECT_EQ(frame.facts.trianglesInFile, count) << name;
        EXPECT_EQ(frame.facts.zeroArea + frame.triangles.size(), count) << name;
    }
}

TEST(Shipped, ClosedMeshesAreRecognised) {
    const Frame crib = SceneFile::load(kScenes / "crib/crib.glb").evaluate(0, 0);
    EXPECT_EQ(crib.facts.closedTriangles, crib.triangles.size() - 2);  // its source has four boundary edges, those of one quad
    const Frame fence = SceneFile::load(kScenes / "fence/fence.glb").evaluate(0, 0);
    EXPECT_NEAR(static_cast<double>(fence.facts.closedTriangles) / static_cast<double>(fence.triangles.size()), 0.984, 0.001);
}

// Whatever stands in scenes/, also what is added later.
TEST(Shipped, EverySceneIsOnTheGrid) {
    size_t scenes = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(kScenes)) {
        if (entry.path().extension() != ".glb" && entry.path().extension() != ".gltf") continue;
        ++scenes;
        const SceneFile scene = SceneFile::load(entry.path());
        const Frame frame = scene.evaluate(0, 0);
        ASSERT_GT(frame.triangles.size(), 0u) << entry.path();
        ASSERT_EQ(frame.material.size(), frame.triangles.size());
        ASSERT_EQ(frame.object.size(), frame.triangles.size());
        ASSERT_EQ(frame.closed.size(), frame.triangles.size());
        ASSERT_EQ(frame.lights.size(), scene.lightCount());
        for (const Triangle& t : frame.triangles) {
            for (const glm::vec3& p : {t.a, t.b, t.c}) {
                for (int axis = 0; axis < 3; ++axis) {
                    ASSERT_LE(std::abs(p[axis]), 1.0f) << entry.path();
                    ASSERT_EQ(snapCoordinate(p[axis]), p[axis]) << entry.path();
                }
            }
        }
        for (const uint32_t material : frame.material) ASSERT_LT(material, scene.materials().size());
        for (const uint32_t object : frame.object) ASSERT_LT(object, frame.facts.objects);
    }
    EXPECT_GE(scenes, kTriangles.size());
}

}  // namespace
}  // namespace gno::host
