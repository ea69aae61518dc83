// SPDX-License-Identifier: MIT
// The casters of a question in Embree's hierarchy, and fp32 shadow rays through it; for the oracle's second witness and for the study.
#pragma once
#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "host_min/oracle.hpp"

struct RTCDeviceTy;  // of embree3/rtcore.h, which whoever asks need not see
struct RTCSceneTy;

namespace gno::host::oracle {

enum class EmbreeMode {
    fp32,    ///< Embree's default: fast, may miss at edges
    robust,  ///< RTC_SCENE_FLAG_ROBUST: no ray slips between two triangles that share an edge
};

class EmbreeScene {
public:
    /// Builds with all of the machine's threads. Throws WorkError when Embree fails.
    EmbreeScene(std::span<const Triangle> triangles, std::span<const uint8_t> isCaster, EmbreeMode mode);

    /// One entry per sample, 1 = something but the sample's own triangle is between it and the light. Rays start at the sample (tnear 0) and end
    /// just before a point light; edge-on casters are hit or missed as fp32 has it. May be called on several threads.
    void ask(std::span<const OracleSample> samples, glm::vec4 light, uint8_t* inShadow) const;

    [[nodiscard]] double buildMs() const { return buildMs_; }  ///< wall clock: vertices handed over and rtcCommitScene, without Embree's own start
    [[nodiscard]] uint64_t bytes() const { return uint64_t(*bytes_); }  ///< what Embree holds, its copy of the vertices included

private:
    struct ReleaseDevice {
        void operator()(RTCDeviceTy* device) const;
    };
    struct ReleaseScene {
        void operator()(RTCSceneTy* scene) const;
    };
    double buildMs_ = 0;
    std::vector<uint32_t> casters_;  // triangle index by primitive
    std::unique_ptr<std::atomic<int64_t>> bytes_ = std::make_unique<std::atomic<int64_t>>(0);
    std::unique_ptr<RTCDeviceTy, ReleaseDevice> device_;
    std::unique_ptr<RTCSceneTy, ReleaseScene> scene_;
};

}  // namespace gno::host::oracle
