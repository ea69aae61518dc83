// SPDX-License-Identifier: MIT
// The scene generator: same bytes twice, the promised size, sound geometry, and shows that equal the files in scenes/.
// Files are read by tinygltf directly, so this does not lean on the loader of host_min.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <tiny_gltf.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <numeric>
#include <set>
#include <sstream>

#include "host_min/error.hpp"
#include "scenes/generator/catalogue.hpp"
#include "scenes/generator/glb.hpp"

namespace gno::scenes {
namespace {

const std::filesystem::path kFolder = GNOMON_SCENES_FOLDER;

std::string bytesOf(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::string generate(const Kind& kind, uint64_t seed) {
    const std::optional<size_t> size = kind.show != nullptr ? std::nullopt : std::optional(kind.low);
    return encodeGlb(makeScene(kind, size, seed, kFolder), kind.name);
}

struct Primitive {
    std::vector<glm::vec3> positions;
    std::vector<uint32_t> indices;
};

/// A parsed file; the checks of a valid GLB happen on the way.
struct File {
    tinygltf::Model model;
    std::vector<std::vector<Primitive>> meshes;
    size_t triangles = 0;  ///< of all nodes
};

void readPrimitive(const tinygltf::Model& model, const tinygltf::Primitive& primitive, Primitive& out) {
    auto data = [&](const tinygltf::Accessor& accessor, size_t size) {
        const auto& view = model.bufferViews.at(static_cast<size_t>(accessor.bufferView));
        EXPECT_LE(view.byteOffset + accessor.byteOffset + accessor.count * size, model.buffers.at(0).data.size());
        EXPECT_EQ(view.byteOffset % 4, 0u);
        return model.buffers[0].data.data() + view.byteOffset + accessor.byteOffset;
    };
    const tinygltf::Accessor& position = model.accessors.at(static_cast<size_t>(primitive.attributes.at("POSITION")));
    out.positions.resize(position.count);
    std::memcpy(out.positions.data(), data(position, 12), position.count * 12);
    const tinygltf::Accessor& index = model.accessors.at(static_cast<size_t>(primitive.indices));
    const bool narrow = index.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
    const unsigned char* from = data(index, narrow ? 2 : 4);
    for (size_t i = 0; i < index.count; ++i) {
        uint32_t value = 0;
        if (narrow) {
            uint16_t half = 0;
            std::memcpy(&half, from + 2 * i, 2);
            value = half;
        } else {
            std::memcpy(&value, from + 4 * i, 4);
        }
        out.indices.push_back(value);
    }
    ASSERT_EQ(out.indices.size() % 3, 0u);
    for (const uint32_t i : out.indices) ASSERT_LT(i, out.positions.size());
    for (const glm::vec3& p : out.positions) ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
}

void parse(const std::string& bytes, File& out) {
    std::string error;
    std::string warning;
    tinygltf::TinyGLTF loader;
    const auto ignoreImage = [](tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
        return true;
    };
    loader.SetImageLoader(ignoreImage, nullptr);
    ASSERT_TRUE(loader.LoadBinaryFromMemory(&out.model, &error, &warning, reinterpret_cast<const unsigned char*>(bytes.data()),
                                            static_cast<unsigned>(bytes.size()), ""))
        << error;
    EXPECT_EQ(error + warning, "");
    for (const tinygltf::Mesh& mesh : out.model.meshes) {
        out.meshes.emplace_back(mesh.primitives.size());
        for (size_t i = 0; i < mesh.primitives.size(); ++i)
            ASSERT_NO_FATAL_FAILURE(readPrimitive(out.model, mesh.primitives[i], out.meshes.back()[i]));
    }
    for (const tinygltf::Node& node : out.model.nodes)
        if (node.mesh >= 0)
            for (const Primitive& primitive : out.meshes.at(static_cast<size_t>(node.mesh))) out.triangles += primitive.indices.size() / 3;
}

void expectNoDegenerateTriangle(const File& file) {
    for (const auto& mesh : file.meshes)
        for (const Primitive& primitive : mesh)
            for (size_t i = 0; i < primitive.indices.size(); i += 3) {
                const glm::dvec3 a(primitive.positions[primitive.indices[i]]);
                const glm::dvec3 u = glm::dvec3(primitive.positions[primitive.indices[i + 1]]) - a;
                const glm::dvec3 v = glm::dvec3(primitive.positions[primitive.indices[i + 2]]) - a;
                const glm::dvec3 n = glm::cross(u, v);
                ASSERT_GT(glm::dot(n, n), 1e-14 * glm::dot(u, u) * glm::dot(v, v)) << "triangle " << i / 3;
            }
}

/// Welds by position and asks that each edge lies in two triangles, once in each direction, and that each part has a positive volume.
/// Returns what is wrong, or nothing.
std::string whyNotClosed(const std::vector<Primitive>& mesh) {
    std::map<std::array<float, 3>, uint32_t> welded;
    std::vector<glm::dvec3> points;
    std::vector<uint32_t> corners;
    for (const Primitive& primitive : mesh)
        for (const uint32_t i : primitive.indices) {
            const glm::vec3& p = primitive.positions[i];
            const auto [entry, added] = welded.try_emplace({p.x + 0.0f, p.y + 0.0f, p.z + 0.0f}, static_cast<uint32_t>(points.size()));
            if (added) points.emplace_back(p);
            corners.push_back(entry->second);
        }
    std::vector<uint32_t> parent(points.size());
    std::iota(parent.begin(), parent.end(), 0u);
    auto root = [&](uint32_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    std::set<std::pair<uint32_t, uint32_t>> edges;
    for (size_t i = 0; i < corners.size(); ++i) {
        const uint32_t to = corners[i % 3 == 2 ? i - 2 : i + 1];
        if (!edges.insert({corners[i], to}).second) return "an edge runs twice in one direction";
        parent[root(corners[i])] = root(to);
    }
    for (const auto& [from, to] : edges)
        if (!edges.contains({to, from})) return "an edge has no triangle on its other side";
    std::vector<double> volume(points.size());
    for (size_t i = 0; i < corners.size(); i += 3) {
        const uint32_t part = root(corners[i]);
        const glm::dvec3& o = points[part];
        volume[part] += glm::dot(points[corners[i]] - o, glm::cross(points[corners[i + 1]] - o, points[corners[i + 2]] - o));
    }
    for (uint32_t i = 0; i < points.size(); ++i)
        if (root(i) == i && !(volume[i] > 0)) return "a part is inside out";
    return {};
}

/// Numbers of the JSON part are fp32 as the animation's are: the same file from every compiler.
void expectSinglePrecision(const std::vector<double>& values) {
    for (const double value : values) {
        volatile float rounded = static_cast<float>(value);
        EXPECT_EQ(value, static_cast<double>(rounded));
    }
}

void expectLightsCameraAction(const File& file) {
    const tinygltf::Model& model = file.model;
    ASSERT_EQ(model.cameras.size(), 1u);
    EXPECT_EQ(model.cameras[0].type, "perspective");
    EXPECT_EQ(model.cameras[0].perspective.aspectRatio, 0);
    EXPECT_EQ(model.cameras[0].perspective.zfar, 0);
    EXPECT_GT(model.cameras[0].perspective.znear, 0);
    ASSERT_GE(model.lights.size(), 2u);
    EXPECT_EQ(model.lights[0].type, "point");
    ASSERT_EQ(model.animations.size(), 1u);
    std::set<int> moved;
    for (const auto& channel : model.animations[0].channels) moved.insert(channel.target_node);
    std::set<int> lights;
    int cameras = 0;
    for (const tinygltf::Material& material : model.materials) expectSinglePrecision(material.pbrMetallicRoughness.baseColorFactor);
    for (size_t i = 0; i < model.nodes.size(); ++i) {
        expectSinglePrecision(model.nodes[i].translation);
        expectSinglePrecision(model.nodes[i].rotation);
        expectSinglePrecision(model.nodes[i].scale);
        const auto found = model.nodes[i].extensions.find("KHR_lights_punctual");
        if (found != model.nodes[i].extensions.end()) lights.insert(found->second.Get("light").GetNumberAsInt());
        if (model.nodes[i].camera < 0) continue;
        ++cameras;
        EXPECT_TRUE(moved.contains(static_cast<int>(i)));
    }
    EXPECT_EQ(cameras, 1);
    EXPECT_EQ(lights.size(), model.lights.size());
    for (const auto& sampler : model.animations[0].samplers) {
        const tinygltf::Accessor& times = model.accessors.at(static_cast<size_t>(sampler.input));
        EXPECT_GE(times.count, 60u);
        EXPECT_NEAR(times.minValues.at(0), 0, 0);
        EXPECT_GE(times.maxValues.at(0), 59 / 30.0 - 1e-6);
        EXPECT_EQ(model.accessors.at(static_cast<size_t>(sampler.output)).count, times.count);
    }
}

class EveryScene : public testing::TestWithParam<const char*> {
protected:
    const Kind& kind_ = findKind(GetParam());
};

TEST_P(EveryScene, IsTheSameTwiceAndAnotherWithAnotherSeed) {
    const std::string bytes = generate(kind_, 1);
    EXPECT_TRUE(bytes == generate(kind_, 1));
    const bool bareRoom = std::string(kind_.name) == "room";  // its lowest size is 12 triangles without any choice
    EXPECT_TRUE(kind_.show != nullptr || bareRoom || bytes != generate(kind_, 2));
}

TEST_P(EveryScene, IsSoundAtItsLowestSize) {
    File file;
    ASSERT_NO_FATAL_FAILURE(parse(generate(kind_, 1), file));
    if (kind_.show != nullptr)
        EXPECT_EQ(file.triangles, kind_.defaultSize);
    else
        EXPECT_NEAR(static_cast<double>(file.triangles), static_cast<double>(kind_.low), 0.15 * static_cast<double>(kind_.low));
    expectNoDegenerateTriangle(file);
    expectLightsCameraAction(file);
    if (!kind_.closed) return;
    for (size_t i = 0; i < file.meshes.size(); ++i) EXPECT_EQ(whyNotClosed(file.meshes[i]), "") << "mesh " << i << ' ' << file.model.meshes[i].name;
}

TEST_P(EveryScene, MeetsItsDefaultSizeAndIsClosedThereToo) {
    const Draft draft = makeScene(kind_, std::nullopt, 1, kFolder);
    const auto wanted = static_cast<double>(kind_.defaultSize);
    EXPECT_NEAR(static_cast<double>(draft.triangleCount()), wanted, kind_.show != nullptr ? 0 : 0.03 * wanted);
    if (!kind_.closed) return;
    for (const Model& model : draft.models) {
        std::vector<Primitive> mesh;
        for (const Part& part : model.parts) mesh.push_back({part.mesh.positions, part.mesh.indices});
        EXPECT_EQ(whyNotClosed(mesh), "") << model.name;
    }
}

std::vector<const char*> names() {
    std::vector<const char*> out;
    for (const Kind& kind : catalogue()) out.push_back(kind.name);
    return out;
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene, testing::ValuesIn(names()), [](const auto& one) { return std::string(one.param); });

TEST(Room, OfTwelveTrianglesIsOneClosedBox) {
    File file;
    ASSERT_NO_FATAL_FAILURE(parse(encodeGlb(makeScene(findKind("room"), 12, 1, kFolder), "room"), file));
    EXPECT_EQ(file.triangles, 12u);
    ASSERT_EQ(file.meshes.size(), 1u);
    EXPECT_EQ(whyNotClosed(file.meshes[0]), "");
}

TEST(Room, WithFurnitureIsClosedToo) {
    File file;
    ASSERT_NO_FATAL_FAILURE(parse(encodeGlb(makeScene(findKind("room"), 9000, 3, kFolder), "room"), file));
    for (const auto& mesh : file.meshes) EXPECT_EQ(whyNotClosed(mesh), "");
    EXPECT_FALSE(encodeGlb(makeScene(findKind("room"), 9000, 4, kFolder), "room") ==
                 encodeGlb(makeScene(findKind("room"), 9000, 3, kFolder), "room"));
}

TEST(Grass, HasItsGroundFirst) {
    const Draft draft = makeScene(findKind("grass"), 5000, 1, kFolder);
    ASSERT_EQ(draft.nodes.at(0).model, 0);
    EXPECT_EQ(draft.models.at(0).name, "ground");
    EXPECT_EQ(draft.models.at(0).triangleCount(), 2u);
}

TEST(Leaves, HaveMasksGlassVeilsAndCoordinates) {
    File file;
    ASSERT_NO_FATAL_FAILURE(parse(encodeGlb(makeScene(findKind("leaves"), 600, 1, kFolder), "leaves"), file));
    ASSERT_EQ(file.model.images.size(), 3u);
    ASSERT_EQ(file.model.textures.size(), 3u);
    std::set<std::pair<std::string, bool>> kinds;  // alpha mode, transmits
    for (const auto& mesh : file.model.meshes)
        for (const tinygltf::Primitive& primitive : mesh.primitives) {
            const tinygltf::Material& material = file.model.materials.at(static_cast<size_t>(primitive.material));
            kinds.insert({material.alphaMode, material.extensions.contains("KHR_materials_transmission")});
            if (material.pbrMetallicRoughness.baseColorTexture.index < 0) continue;
            const auto& uv = file.model.accessors.at(static_cast<size_t>(primitive.attributes.at("TEXCOORD_0")));
            EXPECT_EQ(uv.count, file.model.accessors.at(static_cast<size_t>(primitive.attributes.at("POSITION"))).count);
        }
    EXPECT_EQ(kinds.size(), 6u) << "opaque, mask and blend, each with and without transmission";
    std::set<int> wraps;
    for (const tinygltf::Sampler& sampler : file.model.samplers) wraps.insert(sampler.wrapS);
    EXPECT_EQ(wraps.size(), 3u);
}

TEST(ClosedCheck, SeesAHoleATwistAndAnInsideOutPart) {
    Primitive tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2}};
    EXPECT_EQ(whyNotClosed({tetrahedron}), "");
    Primitive open = tetrahedron;
    open.indices.resize(9);
    EXPECT_NE(whyNotClosed({open}), "");
    Primitive twisted = tetrahedron;
    std::swap(twisted.indices[0], twisted.indices[1]);
    EXPECT_NE(whyNotClosed({twisted}), "");
    Primitive turned = tetrahedron;
    for (size_t i = 0; i < 12; i += 3) std::swap(turned.indices[i], turned.indices[i + 1]);
    EXPECT_NE(whyNotClosed({turned}), "");
}

/// Runs the program in a folder of its own.
class Program : public testing::Test {
protected:
    std::filesystem::path folder_;
    std::string errors_;

    void SetUp() override {
        std::string name = (std::filesystem::temp_directory_path() / "gnomon-scenes-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder_ = name;
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    int run(const std::string& arguments) {
        const std::string command = std::string("'") + GNOMON_SCENES_PROGRAM + "' " + arguments + " > '" + (folder_ / "out").string() + "' 2> '" +
                                    (folder_ / "err").string() + "'";
        const int status = std::system(command.c_str());
        errors_ = bytesOf(folder_ / "err");
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    std::string models() const { return " --models '" + kFolder.string() + "' --out '" + folder_.string() + "'"; }
};

TEST_F(Program, MakesTheShowsThatAreInTheRepository) {
    for (const Kind& kind : catalogue()) {
        if (kind.show == nullptr) continue;
        const std::string name = std::string(kind.name) + ".glb";
        ASSERT_EQ(run("make " + std::string(kind.name) + models()), 0) << errors_;
        EXPECT_TRUE(bytesOf(folder_ / name) == bytesOf(kFolder / name))
            << name << " is not what gnomon-scenes makes: run gnomon-scenes make " << kind.name << " --out scenes";
        EXPECT_LT(std::filesystem::file_size(kFolder / name), 2500000u);
    }
}

TEST_F(Program, SaysSizeAndSeed) {
    ASSERT_EQ(run("make room --size 120 --seed 77" + models()), 0) << errors_;
    const std::string out = bytesOf(folder_ / "out");
    EXPECT_NE(out.find("120 triangles"), std::string::npos) << out;
    EXPECT_NE(out.find("seed 77"), std::string::npos) << out;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "room.glb.part"));
    EXPECT_EQ(run("list"), 0);
    for (const Kind& kind : catalogue()) EXPECT_NE(bytesOf(folder_ / "out").find(kind.name), std::string::npos);
}

TEST_F(Program, RefusesBadArgumentsInOneLine) {
    for (const char* bad :
         {"", "make", "make nosuchscene", "make room --size 11", "make room --size -5", "make room --size many", "make show_garden --size 5",
          "make all --size 500", "make room --seed x", "frobnicate", "make room --frobnicate", "make show_garden --models /nonexistent"}) {
        EXPECT_EQ(run(bad), 2) << bad;
        EXPECT_EQ(std::count(errors_.begin(), errors_.end(), '\n'), 1) << bad << ": " << errors_;
    }
}

TEST_F(Program, FailsWithOneWhenItCannotWrite) {
    std::ofstream(folder_ / "file") << "not a folder";
    EXPECT_EQ(run("make room --size 12 --out '" + (folder_ / "file").string() + "'"), 1);
    EXPECT_EQ(std::count(errors_.begin(), errors_.end(), '\n'), 1) << errors_;
}

}  // namespace
}  // namespace gno::scenes
