// SPDX-License-Identifier: MIT
#include "validation/support/top_on_cpu_check.hpp"

#include <cfenv>
#include <cstdio>
#include <exception>
#ifdef __SSE__
#include <xmmintrin.h>
#endif

#include "validation/support/exact_reference.hpp"

namespace gno::cpu {

std::vector<uint8_t> exactAnswers(const TinyScene& scene) {
    std::vector<uint8_t> answers;
    for (const GnoViewSample& sample : scene.samples) {
        const exact::Vec p = exact::fixed(sample.position);
        bool dark = false;
        for (size_t i = 0; i < scene.casters.size() && !dark; ++i) {
            const GnoCaster& t = scene.casters[i];
            dark = i != sample.own && exact::inShadowOf(scene.light, exact::fixed(t.a), exact::fixed(t.b), exact::fixed(t.c), p);
        }
        answers.push_back(dark ? 1 : 0);
    }
    return answers;
}

bool strictlyInFront(const GnoCaster& t, vec4 light, vec3 p) {
    using exact::operator-;
    const exact::Vec a = exact::fixed(t.a), b = exact::fixed(t.b), c = exact::fixed(t.c), l = exact::fixed(vec3(light));
    const int toLight = light.w != 0.0f ? exact::orient3d(a, b, c, l) : exact::sign(exact::det(b - a, c - a, l));
    return toLight != 0 && exact::orient3d(a, b, c, exact::fixed(p)) == toLight;
}

FloatMode::FloatMode(uint mode) : rounding_(std::fegetround()) {
    constexpr int kModes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    std::fesetround(kModes[mode % 4]);
#ifdef __SSE__
    control_ = _mm_getcsr();
    if (mode >= 4) _mm_setcsr(control_ | 0x8040u);  // flush results, treat denormal operands as zero
#endif
}

FloatMode::~FloatMode() {
#ifdef __SSE__
    _mm_setcsr(control_);
#endif
    std::fesetround(rounding_);
}

std::string firstWrong(TopTree& tree, const TinyScene& scene, const std::vector<uint8_t>& expected, uint precision, std::span<const uint> order,
                       uint floatMode) {
    char line[256];
    const char* doing = "build";
    try {
        const FloatMode mode(floatMode);
        tree.build(scene.casters, scene.light, precision, order);
        for (size_t i = 0; i < scene.samples.size(); ++i) {
            for (size_t q = 0; q < kTopQueries.size(); ++q) {
                doing = kTopQueryNames[q];
                const TopAnswer answer = tree.ask(kTopQueries[q], scene.samples[i]);
                if (answer.visibility == GNO_VISIBILITY_UNKNOWN) throw std::runtime_error("has no answer");
                const bool got = answer.inShadow;
                if (got == (expected[i] != 0)) continue;
                std::snprintf(line, sizeof line, "%s, float mode %u, sample %zu: %s, should be %s", doing, floatMode, i, got ? "dark" : "lit",
                              got ? "lit" : "dark");
                return line;
            }
        }
    } catch (const std::exception& error) {
        std::snprintf(line, sizeof line, "%s, float mode %u: %s", doing, floatMode, error.what());
        return line;
    }
    return {};
}

std::string show(const TinyScene& scene, int only) {
    std::string text;
    const auto add = [&](const char* name, vec3 v, const char* more) {
        char line[160];
        std::snprintf(line, sizeof line, "%s (%a, %a, %a)%s\n", name, static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z),
                      more);
        text += line;
    };
    add(scene.light.w != 0.0f ? "point light" : "directional light", vec3(scene.light), "");
    for (size_t i = 0; i < scene.casters.size(); ++i) {
        const std::string name = "caster " + std::to_string(i);
        add((name + " a").c_str(), scene.casters[i].a, "");
        add((name + " b").c_str(), scene.casters[i].b, "");
        add((name + " c").c_str(), scene.casters[i].c, "");
    }
    for (size_t i = 0; i < scene.samples.size(); ++i) {
        if (only >= 0 && i != static_cast<size_t>(only)) continue;
        const GnoViewSample& s = scene.samples[i];
        add(("sample " + std::to_string(i)).c_str(), s.position, s.own == GNO_NO_CASTER ? "" : (" own " + std::to_string(s.own)).c_str());
    }
    return text;
}

}  // namespace gno::cpu
