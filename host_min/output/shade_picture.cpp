// SPDX-License-Identifier: MIT
#include "host_min/output/shade_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "glsl/core/shared_types.h"

namespace gno::host {

namespace {

constexpr float kSun = 0.95f;        // share of the light, at right angles
constexpr float kSky = 0.19f;        // ambient light from above
constexpr float kGround = 0.08f;     // ambient light from below
constexpr float kHeadlight = 0.08f;  // from the viewer: gives shape to what lies in shadow
const glm::vec3 kSkyTint{0.90f, 0.96f, 1.10f}, kGroundTint{1.08f, 1.0f, 0.9f};

/// Linear [0, 1] to 8 bits of sRGB, by table: 2 million pixels want to be quick.
class SrgbTable {
public:
    SrgbTable() {
        for (std::size_t i = 0; i < bytes_.size(); ++i) {
            const double linear = static_cast<double>(i) / static_cast<double>(bytes_.size() - 1);
            const double encoded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
            bytes_[i] = static_cast<uint8_t>(std::lround(encoded * 255));
        }
    }
    [[nodiscard]] uint8_t operator()(float linear) const {
        if (!(linear > 0)) return 0;  // not a number too
        return bytes_[static_cast<std::size_t>(std::min(linear, 1.0f) * static_cast<float>(bytes_.size() - 1) + 0.5f)];
    }
    [[nodiscard]] glm::u8vec3 operator()(const glm::vec3& linear) const { return {(*this)(linear.x), (*this)(linear.y), (*this)(linear.z)}; }

private:
    std::array<uint8_t, 8192> bytes_{};
};

glm::vec3 towards(const glm::vec4& point, const glm::vec3& from) {
    const glm::vec3 way = glm::vec3(point) - from * point.w;
    const float length = glm::length(way);
    return length > 0 ? way / length : glm::vec3(0, 1, 0);
}

/// Linear up to 0.7, then bent so that bright surfaces keep their hue and never clip hard.
glm::vec3 soften(const glm::vec3& color) {
    const float peak = std::max({color.x, color.y, color.z});
    if (!(peak > 0.7f)) return color;
    return color * ((0.7f + 0.3f * (1 - std::exp(-(peak - 0.7f) / 0.3f))) / peak);
}

glm::vec3 backgroundColor(float share) { return glm::mix(glm::vec3(0.36f, 0.42f, 0.50f), glm::vec3(0.62f, 0.65f, 0.67f), share); }

}  // namespace

Picture shadePicture(const ShadeInputs& in) {
    const std::size_t count = in.visibility.size();
    if (in.position.size() != count || in.normal.size() != count || in.baseColor.size() != count || (in.passing && in.passing->size() != count))
        throw std::invalid_argument("shadePicture: all rasters need the size of the visibility");
    static const SrgbTable srgb;
    const float brightest = std::max({in.lightColor.x, in.lightColor.y, in.lightColor.z});
    const glm::vec3 sun = brightest > 0 ? in.lightColor * (kSun / brightest) : glm::vec3(kSun);
    Picture picture(in.visibility.width, in.visibility.height);
    for (uint32_t y = 0; y < picture.height; ++y) {
        const float share = (static_cast<float>(y) + 0.5f) / static_cast<float>(picture.height);
        const glm::u8vec3 background = srgb(backgroundColor(share));
        for (uint32_t x = 0; x < picture.width; ++x) {
            const uint8_t visibility = in.visibility.at(x, y);
            if (visibility == GNO_VISIBILITY_BACKGROUND) {
                picture.at(x, y) = background;
                continue;
            }
            if (visibility == GNO_VISIBILITY_UNKNOWN) {
                picture.at(x, y) = kUnknownColor;
                continue;
            }
            const glm::vec3& position = in.position.at(x, y);
            const glm::vec3& normal = in.normal.at(x, y);
            const float sky = 0.5f + 0.5f * glm::dot(normal, in.up);
            glm::vec3 light = glm::mix(kGroundTint * kGround, kSkyTint * kSky, sky);
            light += kHeadlight * std::max(0.0f, glm::dot(normal, towards(in.viewer, position)));
            const glm::vec3 arriving = in.passing ? sun * in.passing->at(x, y) : sun;
            if (visibility == GNO_VISIBILITY_LIT) light += arriving * std::max(0.0f, glm::dot(normal, towards(in.light, position)));
            picture.at(x, y) = srgb(soften(in.baseColor.at(x, y) * light));
        }
    }
    return picture;
}

}  // namespace gno::host
