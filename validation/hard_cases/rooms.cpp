// SPDX-License-Identifier: MIT
// Lights inside closed rooms: few large walls all around, every one of them wide and near, and every edge shared.
#include "validation/hard_cases/hard_case.hpp"
#include "validation/hard_cases/scene_maker.hpp"

namespace gno::hard {
namespace {

constexpr size_t kSamples = 1024;

/// Free samples all over the cube, of which many lie behind the walls, then the hard ones.
void addRoomSamples(test::Scene& scene, Random& random, size_t count) {
    for (size_t i = 0; i < count / 2; ++i) addFree(scene, random.inCube());
    addHardSamples(scene, random, count);
}

test::Scene closedRoom(uint32_t seed, bool centre) {
    Random random(seed);
    test::Scene scene;
    addBox(scene.triangles, glm::vec3(-0.5f), glm::vec3(0.5f));
    scene.light = centre ? glm::vec4(0, 0, 0, 1) : pointLight(random.inCube(0.49));
    addRoomSamples(scene, random, centre ? kSamples : 512);
    return scene;
}

test::Scene roomWithBox(uint32_t seed, glm::dvec3 light) {
    Random random(seed);
    test::Scene scene;
    addBox(scene.triangles, glm::vec3(-0.75f), glm::vec3(0.75f));
    addBox(scene.triangles, glm::vec3(-0.25f, -0.75f, -0.25f), glm::vec3(0.25f, -0.5f, 0.25f));
    scene.light = pointLight(light);
    addRoomSamples(scene, random, kSamples);
    return scene;
}

/// A ball of uneven walls with things in it, light anywhere inside.
test::Scene bigRoom(uint32_t seed) {
    Random random(seed);
    test::Scene scene;
    addBall(scene.triangles, {0, 0, 0}, 0.9, 24, 16);
    const auto shift = [](glm::vec3 v) {  // the same vertex moves the same way in every triangle
        const double wave = std::sin(19.0 * v.x) + std::sin(23.0 * v.y + 1) + std::sin(29.0 * v.z + 2);
        return snapped(glm::dvec3(v) * (1 + 0.03 * wave));
    };
    for (Triangle& t : scene.triangles) t = {shift(t.a), shift(t.b), shift(t.c)};
    for (int i = 0; i < 10; ++i) {
        const glm::vec3 low = snapped(random.inCube(0.4));
        addBox(scene.triangles, low, snapped(glm::dvec3(low) + random.real(0.05, 0.15)));
    }
    scene.light = pointLight(random.inCube(0.5));
    addRoomSamples(scene, random, 512);
    return scene;
}

test::Scene frontCulled(uint32_t seed) {
    Random random(seed);
    test::Scene scene;
    addBall(scene.triangles, {0.1, 0.1, 0.1}, 0.4, 12, 8);
    addBox(scene.triangles, glm::vec3(-0.75f, -0.75f, -0.75f), glm::vec3(-0.25f, -0.5f, 0.75f));
    scene.closed.assign(scene.triangles.size(), 1);
    scene.light = pointLight({0.8, 0.9, 0.7});
    scene.cull = host::Cull::front;
    addHardSamples(scene, random, kSamples);
    return scene;
}

}  // namespace

std::vector<HardCase> rooms() {
    return {
        {.name = "light at the centre of a room",
         .why = "12 triangles, samples on the planes through light and edges: all ties at once",
         .make = [](uint32_t seed) { return closedRoom(seed, true); },
         .expectsPublishedErrors = true},
        {.name = "light anywhere in a room",
         .why = "12 wide triangles: the published wedge loses walls",
         .make = [](uint32_t seed) { return closedRoom(seed, false); },
         .scenes = 20,
         .expectsPublishedErrors = true},
        {.name = "light anywhere in a big uneven room",
         .why = "hundreds of walls all around the light, every edge shared",
         .make = bigRoom,
         .scenes = 4,
         .conservativeLimit = 0.02},
        {.name = "light on a wall",
         .why = "the wall is edge-on, the next ones meet it at the light's height",
         .make =
             [](uint32_t seed) {
                 return roomWithBox(seed, {0.75, 0.25, -0.125});
             },
         .expectsPublishedErrors = true},
        {.name = "light in a corner of a room",
         .why = "three walls are edge-on",
         .make =
             [](uint32_t seed) {
                 return roomWithBox(seed, {-0.75, 0.75, 0.75});
             },
         .expectsPublishedErrors = true,
         .conservativeLimit = 0.002},
        {.name = "light in a box in a room",
         .why = "nothing outside of the box is lit, its floor coincides with the room's",
         .make =
             [](uint32_t seed) {
                 return roomWithBox(seed, {0.125, -0.625, 0});
             },
         .expectsPublishedErrors = true},
        {.name = "front faces culled",
         .why = "closed meshes cast with their far sides; samples on culled triangles",
         .make = frontCulled,
         .conservativeLimit = 0.03},
    };
}

}  // namespace gno::hard
