// SPDX-License-Identifier: MIT
#include "validation/oracle/transmission.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>

#include "host_min/error.hpp"

namespace gno::host::oracle {

namespace {

using Row = std::array<mpz_class, 4>;  // homogeneous, in units of 2^-kGridBits

Row row(glm::vec3 v, double w) {
    const auto whole = [](double value) { return mpz_class(std::ldexp(value, kGridBits)); };
    return {whole(double(v.x)), whole(double(v.y)), whole(double(v.z)), whole(w)};
}

// |det| of four homogeneous points, one grid unit taken out: |orient3d| in units of 2^-120. By the 2x2 minors of the first and last two rows.
mpz_class size(const Row& a, const Row& b, const Row& c, const Row& d) {
    const auto minor = [](const Row& x, const Row& y, size_t i, size_t j) -> mpz_class { return x[i] * y[j] - x[j] * y[i]; };
    const mpz_class det = minor(a, b, 0, 1) * minor(c, d, 2, 3) - minor(a, b, 0, 2) * minor(c, d, 1, 3) + minor(a, b, 0, 3) * minor(c, d, 1, 2) +
                          minor(a, b, 1, 2) * minor(c, d, 0, 3) - minor(a, b, 1, 3) * minor(c, d, 0, 2) + minor(a, b, 2, 3) * minor(c, d, 0, 1);
    return mpz_class(abs(det)) >> kGridBits;
}

constexpr size_t kWeightBits = 22;

int64_t floorDivided(int64_t a, int64_t b) { return a / b - (a % b != 0 && (a < 0) != (b < 0) ? 1 : 0); }

/// The value of `numbers` at the hit point, rounded down.
int64_t mean(const std::array<int64_t, 3>& weights, int64_t a, int64_t b, int64_t c) {
    const int64_t sum = weights[0] + weights[1] + weights[2];
    return sum == 0 ? a : floorDivided(weights[0] * a + weights[1] * b + weights[2] * c, sum);
}

int64_t wrapped(int64_t at, int64_t size, Wrap wrap) {
    if (wrap == Wrap::clamp) return std::clamp<int64_t>(at, 0, size - 1);
    const int64_t repeat = floorDivided(at, size), inside = at - repeat * size;
    return wrap == Wrap::mirrored && repeat % 2 != 0 ? size - 1 - inside : inside;
}

int64_t linear(uint8_t srgb) {
    static const auto table = [] {
        std::array<int64_t, 256> values{};
        for (size_t i = 0; i < 256; ++i) {
            const double c = double(i) / 255;
            values[i] = std::lround(255 * (c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4)));
        }
        return values;
    }();
    return table[srgb];
}

std::array<int64_t, 4> texel(const Material& material, const TextureImage& image, int64_t column, int64_t line) {
    const int64_t x = wrapped(column, image.width, material.wrapU), y = wrapped(line, image.height, material.wrapV);
    const uint8_t* rgba = &image.rgba[size_t(4 * (y * image.width + x))];
    if (image.isLinear) return {rgba[0], rgba[1], rgba[2], rgba[3]};
    return {linear(rgba[0]), linear(rgba[1]), linear(rgba[2]), rgba[3]};
}

int64_t rounded(double value) { return int64_t(std::floor(value + 0.5)); }
int64_t timesFactor(int64_t value, float factor) { return std::lround(double(value * rounded(double(factor) * 65535)) / 65535); }

}  // namespace

std::array<int64_t, 3> hitWeights(const Triangle& t, glm::vec4 light, glm::vec3 p) {
    const Row l = row(glm::vec3(light), double(light.w)), a = row(t.a, 1), b = row(t.b, 1), c = row(t.c, 1), q = row(p, 1);
    std::array<mpz_class, 3> weights{size(l, b, c, q), size(l, c, a, q), size(l, a, b, q)};
    const mpz_class largest = std::max({weights[0], weights[1], weights[2]});
    const size_t bits = largest == 0 ? 0 : mpz_sizeinbase(largest.get_mpz_t(), 2);
    std::array<int64_t, 3> result{};
    for (size_t i = 0; i < 3; ++i) result[i] = mpz_class(weights[i] >> (bits > kWeightBits ? bits - kWeightBits : 0)).get_si();
    return result;
}

std::array<int64_t, 4> sampled(const Material& material, const TextureImage& image, int64_t u, int64_t v) {
    if (!material.linearFilter) return texel(material, image, floorDivided(u, 256), floorDivided(v, 256));
    const int64_t x = floorDivided(u - 128, 256), y = floorDivided(v - 128, 256), right = u - 128 - 256 * x, down = v - 128 - 256 * y;
    std::array<int64_t, 4> sum{};
    for (int64_t i = 0; i < 2; ++i) {
        for (int64_t j = 0; j < 2; ++j) {
            const auto one = texel(material, image, x + i, y + j);
            const int64_t weight = (i == 1 ? right : 256 - right) * (j == 1 ? down : 256 - down);
            for (size_t channel = 0; channel < 4; ++channel) sum[channel] += weight * one[channel];
        }
    }
    for (int64_t& channel : sum) channel = floorDivided(channel + 32768, 65536);
    return sum;
}

std::array<int64_t, 3> passing(const Material& material, const std::array<int64_t, 4>& texel) {
    int64_t coverage = 255;
    if (material.alpha == Material::Alpha::blend) coverage = timesFactor(texel[3], material.baseColor.w);
    if (material.alpha == Material::Alpha::mask) {
        const double alpha = double(texel[3]) * double(rounded(double(material.baseColor.w) * 65535));
        coverage = alpha >= std::floor(double(material.alphaCutoff) * 255 * 65535 + 0.5) ? 255 : 0;
    }
    const int64_t transmission = rounded(double(material.transmission) * 255);
    std::array<int64_t, 3> result{};
    for (size_t i = 0; i < 3; ++i) {
        const int64_t colour = timesFactor(texel[i], material.baseColor[glm::length_t(i)]);
        result[i] = 255 - coverage + std::lround(double(coverage * colour * transmission) / 65025);
    }
    return result;
}

uint32_t contribution(int64_t passed) {
    return passed == 0 ? kNoLight : uint32_t(std::lround(-std::log2(static_cast<long double>(passed) / 255) * 65536));
}

void checkSurfaces(const OracleQuestion& q) {
    const auto fail = [](const char* what) { throw WorkError(std::string("the oracle was asked with ") + what); };
    if (q.surfaceOf.size() != q.triangles.size()) fail("a list of surfaces whose length is not the number of triangles");
    if (q.look == nullptr) fail("surfaces without materials");
    for (const uint32_t surface : q.surfaceOf)
        if (surface != kOpaque && surface >= q.surfaces.size()) fail("a surface that does not exist");
    for (const Surface& surface : q.surfaces)
        if (surface.material >= q.look->materials.size()) fail("a material that does not exist");
    for (const Material& material : q.look->materials)
        if (material.image >= int(q.look->images.size())) fail("a image that does not exist");
}

glm::uvec3 contributionOf(const OracleQuestion& question, uint32_t caster, glm::vec3 p) {
    const uint32_t number = question.surfaceOf[caster];
    if (number == kOpaque) return glm::uvec3(kNoLight);
    const Surface& surface = question.surfaces[number];
    const Material& material = question.look->materials[surface.material];
    std::array<int64_t, 4> texel{255, 255, 255, 255};
    if (material.image >= 0) {
        const auto weights = hitWeights(question.triangles[caster], question.light, p);
        const auto& at = surface.corners;
        texel = sampled(material, question.look->images[size_t(material.image)], mean(weights, at[0].x, at[1].x, at[2].x),
                        mean(weights, at[0].y, at[1].y, at[2].y));
    }
    const auto passed = passing(material, texel);
    return {contribution(passed[0]), contribution(passed[1]), contribution(passed[2])};
}

}  // namespace gno::host::oracle
