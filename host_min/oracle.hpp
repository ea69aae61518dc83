// SPDX-License-Identifier: MIT
// The oracle as the host knows it: somebody who answers the definition of "in shadow" exactly. Its implementation lives in validation/.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "host_min/scene/scene.hpp"

namespace gno::host {

inline constexpr uint32_t kNoCaster = 0xFFFFFFFDu;  ///< OracleSample::own of a sample that lies on no caster; GNO_NO_CASTER of glsl/core

/// A view sample: a grid position and the triangle it lies on (an index into the frame's triangles, culled or not), or kNoCaster.
struct OracleSample {
    glm::vec3 position;
    uint32_t own;
};

struct OracleQuestion {
    std::span<const Triangle> triangles;  ///< on the grid
    std::span<const uint8_t> isCaster;    ///< one per triangle: 0 = left out by whoever asks; empty: all are casters
    glm::vec4 light;                      ///< homogeneous, on the grid
    std::span<const OracleSample> samples;
    std::span<const uint32_t> surfaceOf{};  ///< as in Frame; empty: all triangles are opaque, and nobody asks for sums
    std::span<const Surface> surfaces{};
    const MaterialSet* look = nullptr;
};

/// What the light loses on its way to a sample, per channel: 2^16 a halving, added up over all casters, and kNoLight at most.
inline constexpr uint32_t kNoLight = 1u << 20;  ///< GNO_TRANSMITTANCE_OPAQUE of glsl/core: nothing arrives

struct OracleAnswer {
    std::vector<uint8_t> inShadow;      ///< one per sample: 1 = in shadow by the definition, every caster taken for opaque
    std::vector<glm::uvec3> sums;       ///< one per sample, if surfaces were given: sums of contributions (core/transmittance.glsl)
    std::vector<uint32_t> caster;       ///< one per sample: a triangle that shadows it, or kNoCaster
    uint64_t selfShadowed = 0;          ///< samples that only their own triangle would darken
    uint64_t witnessDisagreements = 0;  ///< samples where Embree's fp32 answer differs
    double seconds = 0;                 ///< wall time of the exact answers, hierarchy included
    double witnessSeconds = 0;
};

class Oracle {
public:
    virtual ~Oracle() = default;
    /// `progress` is called now and then with a number in [0, 1]; it may throw to stop the work.
    virtual OracleAnswer ask(const OracleQuestion& question, const std::function<void(double)>& progress) = 0;
};

/// The oracle of this build, or null when it was configured with GNOMON_VALIDATION=OFF.
std::unique_ptr<Oracle> makeOracle();

}  // namespace gno::host
