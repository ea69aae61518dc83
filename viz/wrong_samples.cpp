// SPDX-License-Identifier: MIT
#include "viz/wrong_samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "glsl/core/shared_types.h"
#include "host_min/error.hpp"

namespace gno::viz {
namespace {

using host::InputError;

/// Signed distances of p to a caster's planes, grid units, negative inside: three through the light, and its own.
std::array<double, 4> sidesOf(const Corners& corners, glm::dvec4 light, glm::dvec3 p) {
    std::array<double, 4> sides;
    const auto side = [&](glm::dvec3 normal, glm::dvec3 through, glm::dvec3 inside) {
        const double length = glm::length(normal);
        if (length == 0) return 0.0;  // seen edge-on, or an edge that points at the light
        return glm::dot(normal, p - through) / (glm::dot(normal, inside - through) > 0 ? -length : length);
    };
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 a(corners[i]), b(corners[(i + 1) % 3]), c(corners[(i + 2) % 3]);
        const glm::dvec3 away = light.w != 0 ? a - glm::dvec3(light) : -glm::dvec3(light);
        sides[i] = side(glm::cross(away, b - a), a, c);
    }
    const glm::dvec3 a(corners[0]), normal = glm::cross(glm::dvec3(corners[1]) - a, glm::dvec3(corners[2]) - a);
    const glm::dvec3 front = light.w != 0 ? glm::dvec3(light) : a + glm::dvec3(light);
    sides[3] = -side(normal, a, front);
    return sides;
}

/// The plane that p is nearest to from inside, or farthest from outside: where a volume's answer for p would change.
uint32_t decidingPlane(const std::array<double, 4>& sides) { return uint32_t(std::max_element(sides.begin(), sides.end()) - sides.begin()); }

}  // namespace

WrongSamples wrongSamplesOf(const Dump& dump, std::span<const Corners> corners, size_t limit) {
    if (!dump.has("oracle_shadow"))
        throw InputError(fmt::format("{}: holds no answers of the oracle; make it with `gnomon shade --check --dump`", dump.name()));
    struct Sample {
        glm::vec3 position;
        uint32_t own;
    };
    const auto samples = dump.readPerPixel<Sample>("samples");
    const auto visibility = dump.readPerPixel<uint32_t>("visibility"), shadow = dump.readPerPixel<uint32_t>("oracle_shadow"),
               caster = dump.readPerPixel<uint32_t>("oracle_caster");
    WrongSamples result;
    std::vector<WrongSample> falseDark;
    for (uint32_t i = 0; i < samples.size(); ++i) {
        if (samples[i].own > GNO_NO_CASTER) continue;
        ++result.checked;
        if (visibility[i] == (shadow[i] == 1 ? GNO_VISIBILITY_SHADOW : GNO_VISIBILITY_LIT)) continue;
        ++result.wrong;
        if (visibility[i] == GNO_VISIBILITY_UNKNOWN)
            ++result.unknown;
        else
            result.leaks += shadow[i] == 1;
        if (shadow[i] == 1 && caster[i] >= corners.size())
            throw InputError(fmt::format("{}: the oracle names caster {}, and there are {}", dump.name(), caster[i], corners.size()));
        const WrongSample sample{{i % dump.width(), i / dump.width()}, samples[i].position, samples[i].own, shadow[i] == 1, caster[i]};
        (sample.isLeak ? result.samples : falseDark).push_back(sample);
    }
    const nlohmann::json check = dump.record().value("check", nlohmann::json::object());
    if (check.value("checked", uint64_t(0)) != result.checked || check.value("wrong", uint64_t(0)) != result.wrong)
        throw InputError(
            fmt::format("{}: {} of {} samples differ from the oracle, but its record says {} of {}; a scene with casters that let light through "
                        "needs --set materials=off",
                        dump.name(), result.wrong, result.checked, check.value("wrong", uint64_t(0)), check.value("checked", uint64_t(0))));
    result.samples.insert(result.samples.end(), falseDark.begin(), falseDark.end());
    if (result.samples.size() > limit) result.samples.resize(limit);
    const glm::dvec4 light(dump.light());
    for (WrongSample& sample : result.samples) {
        std::array<double, 4> sides{};
        if (sample.isLeak) {
            sides = sidesOf(corners[sample.caster], light, glm::dvec3(sample.position));
        } else {
            double least = 1e30;
            for (uint32_t other = 0; other < corners.size(); ++other) {
                const auto these = sidesOf(corners[other], light, glm::dvec3(sample.position));
                const double outside = these[decidingPlane(these)];
                if (outside >= least) continue;
                least = outside;
                sample.caster = other;
                sides = these;
            }
        }
        sample.plane = decidingPlane(sides);
        sample.distance = sides[sample.plane] * dump.metres();
    }
    return result;
}

}  // namespace gno::viz
