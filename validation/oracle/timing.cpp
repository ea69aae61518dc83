// SPDX-License-Identifier: MIT
// How long does the oracle take for a large frame? Bumpy spheres on a floor, samples on all surfaces; prints one line per light.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "host_min/oracle.hpp"

namespace {

using namespace gno::host;

float snap(double v) { return std::ldexp(std::nearbyint(std::ldexp(float(v), kGridBits)), -kGridBits); }
glm::vec3 snap(glm::dvec3 v) { return {snap(v.x), snap(v.y), snap(v.z)}; }

// A sphere of rings x 2 rings quads whose radius waves.
void addSphere(std::vector<Triangle>& out, glm::dvec3 centre, double radius, int rings) {
    const auto at = [&](int i, int j) {
        const double theta = M_PI * i / rings, phi = M_PI * j / rings;
        const double r = radius * (1 + 0.1 * std::sin(9 * theta) * std::sin(7 * phi));
        return snap(centre + r * glm::dvec3(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)));
    };
    for (int i = 0; i < rings; ++i) {
        for (int j = 0; j < 2 * rings; ++j) {
            if (i > 0) out.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
            if (i + 1 < rings) out.push_back({at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    const int wanted = argc > 1 ? std::atoi(argv[1]) : 500000;
    const int sampleCount = argc > 2 ? std::atoi(argv[2]) : 512 * 512;
    if (wanted < 100 || sampleCount < 1) return std::fputs("usage: oracle_timing [TRIANGLES >= 100] [SAMPLES]\n", stderr), 2;
    std::vector<Triangle> triangles{{{-1, -0.8f, -1}, {-1, -0.8f, 1}, {1, -0.8f, 1}}, {{-1, -0.8f, -1}, {1, -0.8f, 1}, {1, -0.8f, -1}}};
    const int rings = int(std::sqrt(wanted / 64.0 / 4)) + 1;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < 64; ++i) {
        addSphere(triangles, {1.6 * unit(random) - 0.8, 1.2 * unit(random) - 0.7, 1.6 * unit(random) - 0.8}, 0.05 + 0.1 * unit(random), rings);
    }
    for (const glm::vec4 light : {glm::vec4(0.25f, 0.9375f, 0.125f, 1), glm::vec4(0.25f, 1, 0.375f, 0)}) {
        std::vector<OracleSample> samples;
        while (samples.size() < size_t(sampleCount)) {
            // Half of them on the floor; moved a little towards the light's side, those facing away are left out as the host does.
            const auto own = unit(random) < 0.5 ? uint32_t(2 * unit(random)) : uint32_t(unit(random) * double(triangles.size()));
            const glm::dvec3 a(triangles[own].a), b(triangles[own].b), c(triangles[own].c);
            const double r = std::sqrt(unit(random)), s = unit(random);
            const glm::dvec3 p = (1 - r) * a + r * (1 - s) * b + r * s * c;
            const glm::dvec3 n = glm::normalize(glm::cross(b - a, c - a));
            const glm::dvec3 toLight = light.w != 0 ? glm::dvec3(light) - p : glm::dvec3(light);
            if (glm::dot(n, toLight) > 0) samples.push_back({snap(p + 1e-6 * n), own});
        }
        const OracleAnswer answer = makeOracle()->ask({triangles, {}, light, samples}, {});
        size_t shadowed = 0;
        for (const uint8_t s : answer.inShadow) shadowed += s;
        std::printf("%s light: %zu triangles, %zu samples, %zu in shadow, exact %.2f s, Embree %.2f s, self %llu, Embree differs on %llu\n",
                    light.w != 0 ? "point" : "directional", triangles.size(), samples.size(), shadowed, answer.seconds, answer.witnessSeconds,
                    static_cast<unsigned long long>(answer.selfShadowed), static_cast<unsigned long long>(answer.witnessDisagreements));
    }
    return 0;
}
