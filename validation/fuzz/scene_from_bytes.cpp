// SPDX-License-Identifier: MIT
#include <cmath>

#include "validation/fuzz/finding.hpp"
#include "validation/support/grid_questions.hpp"

namespace gno::fuzz {
namespace {

using glm::dvec3;
using questions::snap;

class Bytes {
public:
    explicit Bytes(std::span<const uint8_t> bytes) : bytes_(bytes) {}
    uint next() { return at_ < bytes_.size() ? bytes_[at_++] : 0u; }
    uint below(uint n) { return next() % n; }
    [[nodiscard]] bool empty() const { return at_ >= bytes_.size(); }

private:
    std::span<const uint8_t> bytes_;
    size_t at_ = 0;
};

class Maker {
public:
    explicit Maker(Bytes& bytes) : bytes_(bytes) {
        static constexpr int kScales[] = {0, 0, 0, -1, -4, -12, -22, -34};
        scale_ = std::ldexp(1.0, kScales[bytes_.below(8)]);
    }

    vec4 light() {
        const uint kind = bytes_.below(8);
        const vec3 at = position();
        if (kind < 4 || at == vec3(0)) return {at, 1.0f};
        const double largest = std::fmax(std::fabs(at.x), std::fmax(std::fabs(at.y), std::fabs(at.z)));
        int exponent = 0;
        std::frexp(largest, &exponent);
        return {snap(dvec3(at) * std::ldexp(1.0, -exponent)), 0.0f};
    }

    vec3 vertex(vec4 light) {
        const uint kind = bytes_.below(8);
        if (kind < 3 || known_.empty()) return keep(position());
        if (kind < 5) return known();
        if (kind == 5) return keep(nudged(behind(light, dvec3(known()), factor())));
        const dvec3 a(known()), b(known());
        if (kind == 6) return keep(nudged(a + (b - a) * (factor() - 1.0)));
        const dvec3 c(known());
        return keep(nudged(a + (b - a) * (factor() - 1.0) + (c - a) * (factor() - 1.0)));
    }

    /// A point on, behind or near a caster; `onIt` tells that it is on it.
    vec3 near(vec4 light, const GnoCaster& t, bool& onIt) {
        const dvec3 v[3] = {t.a, t.b, t.c};
        const uint kind = bytes_.next(), i = kind % 3;
        dvec3 at = v[i];
        if ((kind / 3) % 3 != 0) at += (v[(i + 1) % 3] - at) * part();
        if ((kind / 3) % 3 == 2) at += (v[(i + 2) % 3] - at) * part();
        onIt = kind >= 128;
        return nudged(onIt ? at : behind(light, at, factor()));
    }

private:
    static vec3 inScene(dvec3 v) { return snap(glm::clamp(v, dvec3(-1), dvec3(1))); }
    vec3 keep(vec3 v) {
        known_.push_back(v);
        return v;
    }
    vec3 known() { return known_[bytes_.next() % known_.size()]; }
    static dvec3 behind(vec4 light, dvec3 x, double k) {
        const dvec3 l(light);
        return light.w != 0.0f ? l + (x - l) * k : x - l * (0.5 * (k - 1.0));
    }
    double part() { return double(bytes_.next()) / 255.0; }
    double factor() {
        const uint b = bytes_.next();
        if (b < 64) return 1.0 + std::ldexp(1.0, -int(b % 32));
        if (b < 96) return 1.0 - std::ldexp(1.0, -int(b % 32));
        return double(b - 64) / 64.0;
    }
    vec3 nudged(dvec3 v) {
        vec3 p = inScene(v);
        const uint b = bytes_.next();
        if (b < 128) return p;
        for (int i = 0; i < 3; ++i) {
            const int step = int((b >> (2 * i)) & 3u);  // 0, 3: as it is
            if (step != 1 && step != 2) continue;
            const double to = step == 1 ? 1.0 : -1.0;
            p[i] = (b & 64) ? snap(double(p[i]) + to * questions::kUnit) : snap(double(std::nextafter(p[i], float(2 * to))));
        }
        return inScene(dvec3(p));
    }
    double coordinate() {
        const uint b = bytes_.next();
        const double coarse = (double(b & 15u) - 8.0) / 8.0;
        switch (b >> 4) {
            case 8:
                return coarse * scale_ + questions::kUnit;
            case 9:
                return coarse * scale_ - questions::kUnit;
            case 10:
                return double(std::nextafter(float(coarse * scale_), 2.0f));
            case 11:
                return double(std::nextafter(float(coarse * scale_), -2.0f));
            case 12:
                return coarse * std::ldexp(1.0, -int(bytes_.below(40)));
            case 13:
                return (double(bytes_.next()) - 128.0) / 128.0 * scale_;
            case 14:
                return (double(bytes_.next() * 256u + bytes_.next()) - 32768.0) / 32768.0 * scale_;
            case 15:
                return coarse;
            default:
                return coarse * scale_;
        }
    }
    vec3 position() {
        const double x = coordinate(), y = coordinate(), z = coordinate();
        return inScene(dvec3(x, y, z));
    }

    Bytes& bytes_;
    double scale_ = 1.0;
    std::vector<vec3> known_;
};

}  // namespace

Input sceneFromBytes(std::span<const uint8_t> bytes) {
    Bytes source(bytes);
    Input input;
    input.floatMode = source.below(cpu::kFloatModes);
    input.seed = source.next();
    const uint casters = 1 + source.below(24), samples = 1 + source.below(32);
    Maker maker(source);
    input.scene.light = maker.light();
    for (uint i = 0; i < casters && !source.empty(); ++i) {
        const vec3 a = maker.vertex(input.scene.light), b = maker.vertex(input.scene.light), c = maker.vertex(input.scene.light);
        input.scene.casters.push_back({a, b, c});
    }
    for (uint i = 0; i < samples && !source.empty(); ++i) {
        GnoViewSample sample{vec3(0), GNO_NO_CASTER};
        const uint which = source.next();
        if (which >= 224 || input.scene.casters.empty()) {
            sample.position = maker.vertex(input.scene.light);
        } else {
            const uint caster = uint(which % input.scene.casters.size());
            bool onIt = false;
            sample.position = maker.near(input.scene.light, input.scene.casters[caster], onIt);
            if (onIt && cpu::strictlyInFront(input.scene.casters[caster], input.scene.light, sample.position)) sample.own = caster;
        }
        input.scene.samples.push_back(sample);
    }
    return input;
}

}  // namespace gno::fuzz
