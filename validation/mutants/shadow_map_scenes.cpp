// SPDX-License-Identifier: MIT
#include "validation/mutants/shadow_map_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "validation/support/exact_reference.hpp"
#include "validation/support/grid_questions.hpp"

namespace gno::mutants {
namespace {

constexpr double kNear = 0x1p-20;                      // GNO_SHADOW_MAP_NEAR
constexpr double kTexel = 2.0 * 1.3 / kMapSize / 0.5;  // width on the surfaces here, at most: seen from up to 1.3 away, at 30 degrees or more
constexpr int kAcross = 20;                            // samples along a side of a surface

dvec3 fromLight(vec4 light, vec3 p) { return dvec3(p) - dvec3(vec3(light)) * double(light.w); }

/// Depths of the casters' planes are linear in the places of a map: depth = at + right x + down y at the place (x, y) in the units of `rect`.
struct Drawn {
    dvec3 a, b, c;  ///< from the light
    double at, right, down, sign;
};

Drawn drawn(const ShadowFrustum& f, vec4 light, const GnoCaster& t) {
    Drawn d{fromLight(light, t.a), fromLight(light, t.b), fromLight(light, t.c), 0, 0, 0, 0};
    const dvec3 n = glm::cross(d.b - d.a, d.c - d.a), right(f.right), down(f.down), forward(f.forward);
    const double plane = glm::dot(n, d.a), ahead = glm::dot(n, forward);
    if (f.perspective) {
        d.at = kNear * ahead / plane;
        d.right = kNear * glm::dot(n, right) / plane;
        d.down = kNear * glm::dot(n, down) / plane;
        d.sign = plane;
    } else {
        const double range = double(f.far) - f.near;
        d.at = (f.far - plane / ahead) / range;
        d.right = glm::dot(n, right) / ahead / range;
        d.down = glm::dot(n, down) / ahead / range;
        d.sign = ahead;
    }
    return d;
}

bool covers(const ShadowFrustum& f, const Drawn& d, double x, double y) {
    const dvec3 at = dvec3(f.right) * x + dvec3(f.down) * y, way = dvec3(f.forward);
    const auto side = [&](dvec3 u, dvec3 v) {
        return d.sign * (f.perspective ? glm::dot(at + way, glm::cross(u, v)) : glm::dot(glm::cross(v - u, at - u), way));
    };
    return side(d.a, d.b) >= 0 && side(d.b, d.c) >= 0 && side(d.c, d.a) >= 0;
}

std::vector<float> drawMap(const ShadowFrustum& f, const ShadowScene& scene) {
    std::vector<float> map(size_t{kMapSize} * kMapSize, 0);
    const double width = (f.rect.y - f.rect.x) / double(kMapSize), height = (f.rect.w - f.rect.z) / double(kMapSize);
    for (const GnoCaster& t : scene.casters) {
        const Drawn d = drawn(f, scene.light, t);
        if (d.sign == 0) continue;
        const double bias = std::max(std::abs(d.right) * width, std::abs(d.down) * height);
        for (uint row = 0; row < kMapSize; ++row)
            for (uint column = 0; column < kMapSize; ++column) {
                const double x = f.rect.x + (column + 0.5) * width, y = f.rect.z + (row + 0.5) * height;
                const double depth = d.at + d.right * x + d.down * y;
                float& texel = map[size_t{row} * kMapSize + column];
                if (depth > 0 && depth <= 1 && depth - bias > double(texel) && covers(f, d, x, y)) texel = float(depth - bias);
            }
    }
    return map;
}

bool isInShadow(const ShadowScene& scene, vec3 p) {
    return std::any_of(scene.casters.begin(), scene.casters.end(), [&](const GnoCaster& t) {
        return exact::inShadowOf(scene.light, exact::fixed(t.a), exact::fixed(t.b), exact::fixed(t.c), exact::fixed(p));
    });
}

void addQuad(ShadowScene& scene, vec3 corner, vec3 u, vec3 v) {
    scene.casters.push_back({corner, corner + u, corner + u + v});
    scene.casters.push_back({corner, corner + u + v, corner + v});
}

void addBox(ShadowScene& scene, vec3 low, vec3 high) {
    for (int axis = 0; axis < 3; ++axis) {
        vec3 u(0), v(0), over(0);
        u[(axis + 1) % 3] = (high - low)[(axis + 1) % 3];
        v[(axis + 2) % 3] = (high - low)[(axis + 2) % 3];
        over[axis] = (high - low)[axis];
        addQuad(scene, low, u, v);
        addQuad(scene, low + over, v, u);
    }
}

/// Samples just above a quad, on the side of u x v, where the answer is the same a few texels around.
void addSamples(ShadowScene& scene, vec3 corner, vec3 u, vec3 v) {
    const dvec3 a = glm::normalize(dvec3(u)), b = glm::normalize(dvec3(v)), above = glm::cross(a, b) * 0x1p-19;
    for (int i = 0; i < kAcross; ++i)
        for (int k = 0; k < kAcross; ++k) {
            const dvec3 at = dvec3(corner) + dvec3(u) * ((i + 0.37) / kAcross) + dvec3(v) * ((k + 0.61) / kAcross) + above;
            const bool dark = isInShadow(scene, questions::snap(at));
            bool same = true;
            for (int direction = 0; same && direction < 8; ++direction)
                for (const double part : {0.35, 0.7, 1.0}) {
                    const double angle = direction * 0.785398, radius = 3 * kTexel * part;
                    same = same && isInShadow(scene, questions::snap(at + radius * (std::cos(angle) * a + std::sin(angle) * b))) == dark;
                }
            if (!same) continue;
            scene.samples.push_back(questions::snap(at));
            scene.want.push_back(dark);
        }
}

/// A wall and a square above a ground, which casts or does not.
ShadowScene square(vec4 light, bool groundCasts) {
    ShadowScene scene{groundCasts ? "above a ground" : "beyond every caster", light, {}, {}, {}, {}, {}};
    const vec3 corner(-0.75f, -0.5f, -0.75f), u(0, 0, 1.5f), v(1.5f, 0, 0);
    addQuad(scene, {-0.1f, 0.0f, -0.15f}, {0, 0, 0.35f}, {0.35f, 0, 0});
    addBox(scene, {-0.5f, -0.5f, -0.4f}, {-0.47f, -0.3f, 0.3f});
    if (groundCasts) addQuad(scene, corner, u, v);
    for (GnoCaster& t : scene.casters) t = {questions::snap(dvec3(t.a)), questions::snap(dvec3(t.b)), questions::snap(dvec3(t.c))};
    addSamples(scene, corner, u, v);
    return scene;
}

/// Six walls around the light, a box near each.
ShadowScene room() {
    ShadowScene scene{"in a room", {0.0625f, -0.03125f, 0.046875f, 1}, {}, {}, {}, {}, {}};
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-0.75f, 0.75f}) {
            vec3 at(0.125f, -0.15625f, 0.0625f);
            at[axis] = side * 0.75f;
            addBox(scene, at - 0.125f, at + 0.125f);
        }
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-0.75f, 0.75f}) {
            vec3 corner(-0.75f), u(0), v(0);
            corner[axis] = side;
            u[(axis + 1) % 3] = v[(axis + 2) % 3] = 1.5f;
            side < 0 ? addSamples(scene, corner, u, v) : addSamples(scene, corner, v, u);
        }
    return scene;
}

/// Views as large as they may be.
std::vector<ShadowFrustum> wholeViews(const ShadowScene& scene) {
    if (scene.light.w != 0) return cubeFaces();
    ShadowFrustum prism = viewAlong(-dvec3(vec3(scene.light)), {-1.25f, 1.25f, -1.25f, 1.25f});
    prism.perspective = false;
    prism.near = 9;
    prism.far = -9;
    for (const GnoCaster& t : scene.casters)
        for (const vec3& p : {t.a, t.b, t.c}) {
            prism.near = std::min(prism.near, glm::dot(prism.forward, p) - 0x1p-10f);
            prism.far = std::max(prism.far, glm::dot(prism.forward, p) + 0x1p-10f);
        }
    return {prism};
}

/// The same views, each as large as its samples need.
std::vector<ShadowFrustum> fittedViews(const ShadowScene& scene) {
    std::vector<ShadowFrustum> fitted;
    for (const ShadowFrustum& whole : wholeViews(scene)) {
        glm::dvec4 need(2, -2, 2, -2);
        for (const vec3& p : scene.samples) {
            const Place at = placeOf(whole, vec3(fromLight(scene.light, p)));
            if (at.along <= 0 || std::max(std::abs(at.x - 0.5), std::abs(at.y - 0.5)) > 0.5) continue;
            need = {std::min(need.x, at.x), std::max(need.y, at.x), std::min(need.z, at.y), std::max(need.w, at.y)};
        }
        if (need.x > need.y) continue;
        const double width = whole.rect.y - whole.rect.x, height = whole.rect.w - whole.rect.z, more = 0.01;
        fitted.push_back(whole);
        fitted.back().rect = {float(whole.rect.x + (need.x - more) * width), float(whole.rect.x + (need.y + more) * width),
                              float(whole.rect.z + (need.z - more) * height), float(whole.rect.z + (need.w + more) * height)};
    }
    return fitted;
}

}  // namespace

std::vector<ShadowFrustum> cubeFaces() {
    std::vector<ShadowFrustum> faces;
    for (int axis = 0; axis < 3; ++axis)
        for (const float sign : {1.0f, -1.0f}) {
            ShadowFrustum face{vec3(0), vec3(0), vec3(0), {-1, 1, -1, 1}};
            face.forward[axis] = sign;
            face.right[(axis + 1) % 3] = 1;
            face.down[(axis + 2) % 3] = 1;
            faces.push_back(face);
        }
    return faces;
}

ShadowFrustum viewAlong(dvec3 forward, vec4 rect) {
    forward = glm::normalize(forward);
    const dvec3 right = glm::normalize(glm::cross(forward, std::abs(forward.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0)));
    return {right, glm::cross(forward, right), forward, rect};
}

Place placeOf(const ShadowFrustum& f, vec3 q) {
    const double along = glm::dot(dvec3(f.forward), dvec3(q)), w = f.perspective ? along : 1;
    return {(glm::dot(dvec3(f.right), dvec3(q)) / w - f.rect.x) / (double(f.rect.y) - f.rect.x),
            (glm::dot(dvec3(f.down), dvec3(q)) / w - f.rect.z) / (double(f.rect.w) - f.rect.z),
            f.perspective ? kNear / along : std::max(0.0, (f.far - along) / (double(f.far) - f.near)), along};
}

std::vector<ShadowScene> makeShadowScenes() {
    const vec4 point(0.3125f, 0.8125f, 0.09375f, 1), sun(0.5f, 1, 0.3125f, 0);
    std::vector<ShadowScene> scenes{square(point, true), square(sun, true), square(point, false), square(sun, false), room()};
    const size_t count = scenes.size();
    for (size_t i = 0; i < count; ++i) {
        scenes.push_back(scenes[i]);
        scenes.back().name += ", fitted";
        scenes.back().frusta = fittedViews(scenes[i]);
        scenes[i].frusta = wholeViews(scenes[i]);
    }
    for (ShadowScene& scene : scenes) {
        for (const ShadowFrustum& f : scene.frusta) scene.maps.push_back(drawMap(f, scene));
        const auto dark = size_t(std::count(scene.want.begin(), scene.want.end(), 1));
        if (scene.samples.size() < kAcross * kAcross / 2 || dark < scene.samples.size() / 100 || dark == scene.samples.size())
            throw std::logic_error(fmt::format("the scene {} tests nothing: {} samples, {} of them dark", scene.name, scene.samples.size(), dark));
    }
    return scenes;
}

}  // namespace gno::mutants
