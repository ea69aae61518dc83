// SPDX-License-Identifier: MIT
// gnomon-cluster-mutants [NAME...]: the cluster family's text on the CPU: the oracle's masks, in every case. What is printed: run.hpp.
#include <fmt/format.h>

#include <functional>

#include "glsl/clusters/cluster.h"
#include "validation/hard_cases/hard_case.hpp"
#include "validation/hard_cases/scene_maker.hpp"
#include "validation/mutants/run.hpp"
#include "validation/support/cluster_on_cpu.hpp"

namespace gno::mutants {
namespace {

using host::cases::Random;
using test::CameraView;

constexpr uint kForms[] = {GNO_CLUSTER_COMPACT, GNO_CLUSTER_IMPLICIT, GNO_CLUSTER_FLAT, GNO_CLUSTER_EXPLICIT};
constexpr uint kMany = 1u << 14;

/// Samples one to a tile, wherever their pixels are: nobody tests them but who comes to their own cluster.
CameraView scattered(const test::Scene& scene) {
    CameraView view;
    view.frame.triangles = scene.triangles;
    view.frame.camera = test::lookAt({0.5, 0.5, 1}, {0, 0, 0}, 0.6);
    view.width = 96;
    view.height = 8 * uint32_t((scene.samples.size() + 11) / 12);
    view.light = scene.light;
    view.pixels.assign(size_t(view.width) * view.height, {glm::vec3(0), GNO_BACKGROUND});
    for (size_t i = 0; i < scene.samples.size(); ++i) view.pixels[i / 12 * 8 * view.width + i % 12 * 8] = scene.samples[i];
    return view;
}

/// Samples at vertices, edges and faces and behind them.
CameraView edges(uint32_t seed) {
    Random random(seed);
    test::Scene scene;
    scene.light = seed % 2 ? hard::pointLight(random.inCube(0.9)) : hard::directionalLight(random.inCube());
    for (int i = 0; i < 12; ++i) {
        const glm::dvec3 at = random.inCube(0.6);
        const double size = std::ldexp(0.4, -int(random.below(6)));
        const auto corner = [&] { return hard::snapped(at + random.inCube(size)); };
        const glm::vec3 a = corner(), b = corner(), c = corner();
        scene.triangles.push_back({a, b, c});
    }
    hard::addHardSamples(scene, random, 180);
    return scattered(scene);
}

/// Samples on faces, as near as the grid has them: on either side, and on no caster by name.
CameraView faces(uint32_t seed) {
    Random random(seed);
    test::Scene scene;
    scene.light = seed % 2 ? hard::pointLight(random.inCube(0.9)) : hard::directionalLight(random.inCube());
    for (int i = 0; i < 3; ++i) {
        const auto corner = [&] { return hard::snapped(random.inCube(0.9)); };
        const glm::vec3 a = corner(), b = corner(), c = corner();
        scene.triangles.push_back({a, b, c});
    }
    for (int i = 0; i < 180; ++i) {
        const host::Triangle& t = scene.triangles[random.below(3)];
        const double u = random.real(0.1, 0.45), v = random.real(0.1, 0.45);
        hard::addFree(scene, glm::dvec3(t.a) * (1 - u - v) + glm::dvec3(t.b) * u + glm::dvec3(t.c) * v);
    }
    return scattered(scene);
}

/// Casters so near the light that they span most of what it sees, and slivers.
CameraView wide(uint32_t seed) {
    Random random(seed);
    test::Scene scene;
    scene.light = seed % 3 ? hard::pointLight(random.inCube(0.3)) : hard::directionalLight(random.inCube());
    for (int i = 0; i < 10; ++i) {
        const glm::dvec3 at = glm::dvec3(scene.light) + random.inCube(std::ldexp(0.2, -int(random.below(6))));
        const double flat = std::ldexp(1.0, -int(random.below(20)));
        const glm::dvec3 along = random.inCube(0.5), aside = random.inCube(i % 2 ? 0.5 : 0.5 * flat);
        scene.triangles.push_back({hard::snapped(at * 0.7 - along), hard::snapped(at * 0.7 + along), hard::snapped(at * 0.7 + aside)});
    }
    hard::addHardSamples(scene, random, 180);
    return scattered(scene);
}

/// What a camera sees of a floor and casters over it; every fourth under a lid.
CameraView seen(uint32_t seed) {
    Random random(seed);
    CameraView view;
    view.width = 72;
    view.height = 50;
    view.light = seed % 2 ? hard::pointLight({0.3, 0.95, 0.2}) : hard::directionalLight({0.4, 1, 0.3});
    view.frame.camera = test::lookAt({0.3, 0.5, 0.95}, {0, -0.4, -0.2}, 0.5, seed % 3 != 0);
    hard::addQuad(view.frame.triangles, {-1, -0.75f, -1}, {-1, -0.75f, 1}, {1, -0.75f, 1}, {1, -0.75f, -1});
    for (int i = 0; i < 16; ++i) {
        const glm::dvec3 at = random.inCube(0.6);
        const auto corner = [&] { return hard::snapped(at + random.inCube(0.3)); };
        const glm::vec3 a = corner(), b = corner(), c = corner();
        view.frame.triangles.push_back({a, b, c});
    }
    if (seed % 4 == 0) view.frame.triangles.push_back({{-0.75f, 0.8125f, -1}, {1, 0.8125f, -1}, {0, 0.8125f, 1}});
    fillPixels(view);
    return view;
}

struct Case {
    std::string name;
    std::function<CameraView(uint32_t seed)> make;
    uint32_t seeds;
    struct Frame {
        CameraView view;
        std::vector<uint32_t> want;
    };
    std::vector<Frame> frames{};
};

std::vector<Case> makeCases() {
    std::vector<Case> cases{
        {"what a camera sees", seen, 7}, {"samples at edges", edges, 28}, {"samples on faces", faces, 12}, {"wide casters and slivers", wide, 20}};
    for (Case& c : cases)
        for (uint32_t seed = 1; seed <= c.seeds; ++seed) {
            CameraView view = c.make(seed);
            std::vector<uint32_t> want = oracleMask(view);
            c.frames.push_back({std::move(view), std::move(want)});
        }
    return cases;
}

/// Empty: right in all frames, whatever the form and the lists.
std::string failure(cpu::ClusterFamily& family, const Case& c) {
    for (uint32_t i = 0; i < c.frames.size(); ++i) {
        const Case::Frame& frame = c.frames[i];
        for (uint k = 0; k < 4; ++k) {
            const cpu::ClusterChoice choice{GNO_PRECISION_CERTIFIED,     kForms[k], i % 3, (i + k) % 2 ? kMany : 3,
                                            i % 2 ? kMany : 40 + 20 * i, i % 4 != 3};
            const std::string how = fmt::format("seed {}, form {}, split {}", i + 1, choice.form, choice.split);
            try {
                const std::vector<uint32_t> got = family.run(frame.view, choice);
                for (size_t p = 0; p < got.size(); ++p)
                    if (got[p] != frame.want[p]) return fmt::format("{}: pixel {} is {}, not {}", how, p, got[p], frame.want[p]);
            } catch (const std::exception& error) {
                return how + ": " + error.what();
            }
        }
    }
    return "";
}

}  // namespace
}  // namespace gno::mutants

int main(int argc, char** argv) {
    using namespace gno;
    const std::vector<mutants::Case> cases = mutants::makeCases();
    return mutants::run({argv + 1, argv + argc}, cpu::clusterVariants(), [&](const cpu::ClusterVariant& variant, bool) -> mutants::Verdict {
        const auto family = variant.make();
        for (const mutants::Case& c : cases) {
            const std::string found = mutants::failure(*family, c);
            if (!found.empty()) return {c.name + ", " + found};
        }
        return {"", "all cases"};
    });
}
