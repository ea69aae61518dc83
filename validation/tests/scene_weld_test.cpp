// SPDX-License-Identifier: MIT
// Triangles without area, duplicates, and where front-face culling is legal.
#include <gtest/gtest.h>

#include <algorithm>

#include "host_min/scene/triangles.hpp"
#include "scene_builder.hpp"

namespace gno::host::test {
namespace {

uint64_t closedOf(const std::vector<float>& positions, const std::vector<uint16_t>& indices) {
    Builder builder;
    builder.meshNode(positions, indices);
    const Frame frame = frameOf(builder);
    EXPECT_EQ(frame.facts.closedTriangles, static_cast<uint64_t>(std::count(frame.closed.begin(), frame.closed.end(), 1)));
    return frame.facts.closedTriangles;
}

std::vector<uint16_t> reversed(std::vector<uint16_t> indices) {
    for (size_t i = 0; i < indices.size(); i += 3) std::swap(indices[i + 1], indices[i + 2]);
    return indices;
}

TEST(Closed, CubeIsAndAnInsideOutOrOpenOneIsNot) {
    EXPECT_EQ(closedOf(kCube, kCubeIndices), 12u);
    EXPECT_EQ(closedOf(kCube, reversed(kCubeIndices)), 0u);
    EXPECT_EQ(closedOf(kCube, {kCubeIndices.begin() + 3, kCubeIndices.end()}), 0u);
    std::vector<uint16_t> oneFlipped = kCubeIndices;
    std::swap(oneFlipped[0], oneFlipped[1]);
    EXPECT_EQ(closedOf(kCube, oneFlipped), 0u);
}

TEST(Closed, MirroredNodeStaysOutward) {
    Builder builder;
    builder.meshNode(kCube, kCubeIndices, {{"scale", {1, -1, 1}}});
    EXPECT_EQ(frameOf(builder).facts.closedTriangles, 12u);
}

TEST(Closed, VerticesAreWeldedByPositionAcrossPrimitives) {
    Builder builder;
    std::vector<float> corners;  // every triangle with vertices of its own
    for (const uint16_t index : kCubeIndices)
        for (int axis = 0; axis < 3; ++axis) corners.push_back(kCube[index * 3u + static_cast<size_t>(axis)]);
    const std::vector<float> half(corners.begin(), corners.begin() + 54), rest(corners.begin() + 54, corners.end());
    builder.meshNode(half);
    const Json second = {{"attributes", {{"POSITION", builder.positions(rest)}}}};
    builder.json["meshes"][0]["primitives"].push_back(second);
    EXPECT_EQ(frameOf(builder).facts.closedTriangles, 12u);
}

TEST(Closed, PartsAreJudgedSeparately) {
    std::vector<float> positions = kCube;
    for (size_t i = 0; i < kCube.size(); ++i) positions.push_back(kCube[i] + 5);
    std::vector<uint16_t> indices = kCubeIndices;
    for (size_t i = 3; i < kCubeIndices.size(); ++i)
        indices.push_back(static_cast<uint16_t>(kCubeIndices[i] + 8));  // the second cube lacks a triangle
    EXPECT_EQ(closedOf(positions, indices), 12u);
}

TEST(Closed, TwoInstancesAreNotWelded) {
    Builder builder;
    const int cube = builder.meshNode(kCube, kCubeIndices);
    builder.node({{"mesh", builder.json["nodes"][cube]["mesh"]}});  // the same cube at the same place: every edge would belong to four triangles
    const Frame frame = frameOf(builder);
    EXPECT_EQ(frame.facts.closedTriangles, 24u);
    EXPECT_EQ(frame.facts.duplicates, 12u);
}

TEST(Closed, DegenerateTrianglesKeepAMeshClosed) {
    // Two equal vertices: bounds nothing.
    std::vector<uint16_t> indices = kCubeIndices;
    indices.insert(indices.end(), {0, 0, 1});
    EXPECT_EQ(closedOf(kCube, indices), 12u);

    // A T-joint on the edge 0-1, closed by a triangle of three collinear points: 0-2-1 splits into 0-2-8 and 8-2-1, the other side stays whole.
    std::vector<float> positions = kCube;
    positions.insert(positions.end(), {0.5f, 0, 0});
    std::vector<uint16_t> split{0, 2, 8, 8, 2, 1};
    split.insert(split.end(), kCubeIndices.begin() + 3, kCubeIndices.end());
    EXPECT_EQ(closedOf(positions, split), 0u);
    split.insert(split.end(), {1, 0, 8});
    EXPECT_EQ(closedOf(positions, split), 13u);
}

TEST(ZeroArea, IsLeftOutAndCounted) {
    Builder builder;
    builder.meshNode({0, 0, 0, 1, 0, 0, 0, 1, 0, 2, 0, 0}, {0, 1, 2, 0, 1, 3, 0, 0, 1, 2, 2, 2});
    const Frame frame = frameOf(builder);
    EXPECT_EQ(frame.facts.trianglesInFile, 4u);
    EXPECT_EQ(frame.facts.zeroArea, 3u);
    EXPECT_EQ(frame.triangles.size(), 1u);
    EXPECT_EQ(frame.material.size(), 1u);
    EXPECT_EQ(frame.object.size(), 1u);
    EXPECT_EQ(frame.closed.size(), 1u);
}

TEST(ZeroArea, IsDecidedExactly) {
    const float step = 0x1p-40f, ulp = 0x1p-24f;
    EXPECT_TRUE(isCollinear({{-1, -1, -1}, {0, 0, 0}, {1, 1, 1}}));
    EXPECT_TRUE(isCollinear({{0.1f, 0.2f, 0.3f}, {0.1f, 0.2f, 0.3f}, {0.9f, 0.7f, 0.5f}}));
    EXPECT_FALSE(isCollinear({{-1, -1, -1}, {step, 0, 0}, {1, 1, 1}}));
    EXPECT_FALSE(isCollinear({{-1, -1, -1}, {0, 0, 0}, {1, 1, 1 - ulp}}));
    // Products of 41-bit differences that are about 1 and differ by 2^-64: double cannot tell them apart.
    const float big = 1 - ulp;
    EXPECT_FALSE(isCollinear({{step, 2 * step, 0}, {big, big, 0}, {1, 1, 0}}));
    EXPECT_FALSE(isCollinear({{0, step, 2 * step}, {0, big, big}, {0, 1, 1}}));
    EXPECT_TRUE(isCollinear({{step, step, 0}, {big, big, 0}, {1, 1, 0}}));
    EXPECT_TRUE(isCollinear({{-step, -step, step}, {0, 0, 0}, {1, 1, -1}}));
}

TEST(Duplicates, SameThreePositionsInAnyOrder) {
    Builder builder;
    builder.meshNode(kCube, {0, 1, 2, 2, 1, 0, 1, 2, 0, 0, 1, 3, 4, 5, 6});
    const Frame frame = frameOf(builder);
    EXPECT_EQ(frame.facts.duplicates, 2u);
    EXPECT_EQ(frame.triangles.size(), 5u);  // kept
}

}  // namespace
}  // namespace gno::host::test
