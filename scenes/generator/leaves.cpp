// SPDX-License-Identifier: MIT
// Casters that are not opaque: leaf cards cut out by alpha, lattices, walls of coloured glass, veils. Light reaches the ground through many of them.
#include <algorithm>
#include <cmath>

#include "scenes/generator/catalogue.hpp"
#include "scenes/generator/shapes.hpp"

namespace gno::scenes {
namespace {

uint8_t byte(double value) { return static_cast<uint8_t>(std::clamp(std::floor(value + 0.5), 0.0, 255.0)); }

void paint(Texture& texture, const glm::dvec3& color, double alpha) {  // 0 to 255
    texture.rgba.insert(texture.rgba.end(), {byte(color.x), byte(color.y), byte(color.z), byte(alpha)});
}

/// A pointed leaf with teeth, its stem at the bottom; alpha falls over two texels at the rim.
Texture leafTexture() {
    Texture texture{64, 64, {}, false, 33071};
    for (int row = 0; row < 64; ++row)
        for (int column = 0; column < 64; ++column) {
            const double y = (63.5 - row) / 64, x = (column + 0.5) / 32 - 1;
            const double teeth = 0.05 * std::abs(sine(14 * y + 2 * std::abs(x)));
            const double width = y < 0.12 ? 0.05 : 0.95 * std::sqrt(std::max(0.0, (y - 0.1) * (1 - y) * 1.6)) - teeth;
            const double inside = std::min((width - std::abs(x)) * 16, (0.98 - y) * 32);
            const double vein = std::abs(x) < 0.03 || std::abs(sine(16 * (y - 0.6 * std::abs(x)))) < 0.12 ? 30 : 0;
            paint(texture, {70 + vein + 30 * y, 130 + vein, 40 + vein}, 255 * std::clamp(inside + 0.5, 0.0, 1.0));
        }
    return texture;
}

/// Bars of a third of the width, both ways; repeats.
Texture latticeTexture() {
    Texture texture{12, 12, {}, true, 10497};
    for (int row = 0; row < 12; ++row)
        for (int column = 0; column < 12; ++column) paint(texture, {150, 110, 70}, row < 4 || column < 4 ? 255 : 0);
    return texture;
}

/// Stained glass: cells of one colour each, between strips of lead that let nothing through; repeats mirrored.
Texture stainedTexture(Random& random) {
    Texture texture{32, 32, {}, false, 33648};
    const glm::dvec3 colors[] = {{230, 40, 30}, {250, 190, 40}, {40, 90, 220}, {60, 180, 90}, {200, 70, 190}, {240, 240, 220}};
    std::vector<uint32_t> cells(16);
    for (uint32_t& cell : cells) cell = random.below(6);
    for (uint32_t row = 0; row < 32; ++row)
        for (uint32_t column = 0; column < 32; ++column) {
            const bool lead = row % 8 == 0 || column % 8 == 0;
            paint(texture, lead ? glm::dvec3(0) : colors[cells[row / 8 * 4 + column / 8]], 255);
        }
    return texture;
}

/// A rectangle of two triangles around `centre`, spanned by half its sides; the texture lies on it `repeats` times.
void addCard(Mesh& mesh, const glm::dvec3& centre, const glm::dvec3& right, const glm::dvec3& up, const glm::dvec2& repeats) {
    const uint32_t first = mesh.vertex(centre - right - up);
    mesh.vertex(centre + right - up);
    mesh.vertex(centre + right + up);
    mesh.vertex(centre - right + up);
    mesh.quad(first, first + 1, first + 2, first + 3);
    const glm::vec2 n(repeats);
    mesh.uv.insert(mesh.uv.end(), {{0, n.y}, {n.x, n.y}, {n.x, 0}, {0, 0}});
}

struct Look {
    uint32_t leaf, translucent, lattice, stained, veil;
    std::array<uint32_t, 4> glass;
};

Look addMaterials(Draft& draft, Random& random) {
    draft.textures = {leafTexture(), latticeTexture(), stainedTexture(random)};
    Look look{};
    const auto glass = [&](const char* name, const glm::dvec3& color) { return draft.material({name, color, "", 1, 0.5, 1}); };
    look.leaf = draft.material({"leaf", {1, 1, 1}, "MASK", 1, 0.5, 0, 0});
    look.translucent = draft.material({"leaf that light shines through", {0.9, 1, 0.6}, "MASK", 1, 0.3, 0.75, 0});
    look.lattice = draft.material({"lattice", {1, 1, 1}, "MASK", 1, 0.5, 0, 1});
    look.stained = draft.material({"stained glass", {1, 1, 1}, "BLEND", 1, 0.5, 0.9, 2});
    look.veil = draft.material({"veil", {0.8, 0.8, 0.85}, "BLEND", 0.35});
    look.glass = {glass("red glass", {0.9, 0.25, 0.2}), glass("amber glass", {0.95, 0.7, 0.2}), glass("blue glass", {0.25, 0.45, 0.95}),
                  glass("clear glass", {0.95, 0.97, 0.95})};
    return look;
}

/// Three walls of glass, one behind the other, a wall of stained glass, lattices, and veils that cross each other.
void addPanes(Draft& draft, const Look& look) {
    Model panes;
    panes.name = "panes";
    for (int wall = 0; wall < 3; ++wall)
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 centre{-2.8 + 1.0 * (i % 4) + 0.17 * wall, 0.75 + 1.1 * (i < 4 ? 0 : 1), -1.4 - 0.7 * wall};
            addCard(panes.of(look.glass[static_cast<size_t>((i + wall) % 4)]), centre, {0.48, 0, 0.04 * wall}, {0, 0.5, 0}, {1, 1});
        }
    for (int i = 0; i < 4; ++i) addCard(panes.of(look.stained), {1.6 + 0.9 * i, 1.3, -1.6}, {0.44, 0, 0.1}, {0, 1.2, 0.05}, {1.5, 4});
    for (int i = 0; i < 3; ++i) addCard(panes.of(look.lattice), {-1.6 + 2.0 * i, 2.9, -2.6 + 0.2 * i}, {0.9, 0, 0}, {0, 0.1, 0.6}, {14, 9});
    for (int i = 0; i < 5; ++i) addCard(panes.of(look.veil), {-3 + 1.3 * i, 1.6, -3.6 + 0.15 * i}, {0.8, 0, 0.3}, {0, 0.9, 0.12}, {1, 1});
    draft.placeOnce(std::move(panes));
}

}  // namespace

Draft buildLeaves(double detail, uint64_t seed) {
    Random random(seed);
    Draft draft;
    const Look look = addMaterials(draft, random);
    const uint32_t soil = draft.material("soil", {0.75, 0.71, 0.62});
    const uint32_t bark = draft.material("bark", {0.30, 0.22, 0.14});
    Model ground;
    ground.name = "ground";
    addBox(ground.of(soil), {-12, -0.5, -12}, {12, 0, 12});
    draft.placeOnce(std::move(ground));
    addPanes(draft, look);

    const glm::dvec2 feet[] = {{-3.2, 0.8}, {0.4, 1.4}, {3.4, 0.6}, {4.6, -3.2}, {-4.8, -3.6}};
    Model trunks;
    trunks.name = "trunks";
    for (const glm::dvec2& foot : feet) addCylinder(trunks.of(bark), {foot.x, -0.1, foot.y}, {foot.x, 2.2, foot.y}, 0.11, 0.05, 8);
    draft.placeOnce(std::move(trunks));

    const double left4cards = detail * 8000 - static_cast<double>(draft.triangleCount());
    const int cards = std::max(20, static_cast<int>(left4cards / 2));
    Model crowns;
    crowns.name = "crowns";
    const double size = 0.26 / std::sqrt(std::max(detail, 0.25));
    for (int i = 0; i < cards; ++i) {
        const glm::dvec2& foot = feet[i % 5];
        const double radius = std::sqrt(random.between(0.02, 1));
        const glm::dvec3 out = random.direction() * radius;
        const glm::dvec3 centre = glm::dvec3(foot.x, 2.5, foot.y) + out * glm::dvec3(1.25, 0.75, 1.25);
        const glm::dvec3 up = random.direction();
        const glm::dvec3 side = random.direction();
        const glm::dvec3 right = glm::normalize(glm::cross(up, std::abs(glm::dot(up, side)) > 0.9 ? glm::dvec3(up.y, up.z, -up.x) : side));
        const double scale = size * random.between(0.7, 1.3);
        addCard(crowns.of(i % 3 == 2 ? look.translucent : look.leaf), centre, 0.8 * scale * right, scale * up, {1, 1});
    }
    draft.placeOnce(std::move(crowns));

    draft.camera([](double t) { return glm::dvec3(-3.5 + 6 * t, 3.4 + 0.6 * t, 8.2 - 0.8 * t); },
                 [](double t) { return glm::dvec3(-0.2 + 0.6 * t, 0.7, -0.4); });
    draft.pointLight({1, 0.95, 0.85}, 5.5, [](double t) { return glm::dvec3(-2.2 + 4.2 * t, 5.2, -5.4); });
    draft.sun({1, 0.96, 0.9}, [](double t) { return glm::dvec3(-0.5 + 0.9 * t, 0.85, -0.9); });
    return draft;
}

}  // namespace gno::scenes
