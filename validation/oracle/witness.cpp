// SPDX-License-Identifier: MIT
#include "validation/oracle/witness.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include <embree3/rtcore.h>

#include "host_min/error.hpp"
#include "validation/oracle/parallel.hpp"

namespace gno::host::oracle {

namespace {

struct ReleaseDevice {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<RTCDeviceTy, ReleaseDevice>;
using Scene = std::unique_ptr<RTCSceneTy, ReleaseScene>;

void check(RTCDevice device) {
    if (const RTCError error = rtcGetDeviceError(device); error != RTC_ERROR_NONE) {
        throw WorkError("Embree, the oracle's second witness, failed with error " + std::to_string(int(error)) +
                        (error == RTC_ERROR_OUT_OF_MEMORY ? ": not enough memory, try a smaller scene" : ": is libembree3 complete?"));
    }
}

// What the filter has to know about the ray; Embree hands back a pointer to the first member.
struct RayContext {
    RTCIntersectContext embree;
    uint32_t own;
};

// Lets a ray pass through the triangle that its sample lies on. The geometry's user data are the casters' triangle indices.
void passOwn(const RTCFilterFunctionNArguments* args) {
    const auto* casters = static_cast<const uint32_t*>(args->geometryUserPtr);
    const auto* context = reinterpret_cast<const RayContext*>(args->context);
    if (casters[RTCHitN_primID(args->hit, args->N, 0)] == context->own) args->valid[0] = 0;
}

Scene makeScene(RTCDevice device, std::span<const Triangle> triangles, std::span<uint32_t> casters) {
    Scene scene(rtcNewScene(device));
    rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_MEDIUM);
    const size_t count = casters.size();
    auto* positions =
        static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), 3 * count));
    auto* corners =
        static_cast<uint32_t*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(uint32_t), count));
    if (positions != nullptr && corners != nullptr) {
        for (size_t i = 0; i < count; ++i) {
            const Triangle& t = triangles[casters[i]];
            positions[3 * i] = t.a;
            positions[3 * i + 1] = t.b;
            positions[3 * i + 2] = t.c;
        }
        for (size_t i = 0; i < 3 * count; ++i) corners[i] = uint32_t(i);
        rtcSetGeometryUserData(geometry, casters.data());
        rtcSetGeometryOccludedFilterFunction(geometry, passOwn);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene.get(), geometry);
    }
    rtcReleaseGeometry(geometry);
    check(device);
    rtcCommitScene(scene.get());
    check(device);
    return scene;
}

bool occluded(RTCScene scene, const OracleSample& sample, glm::vec4 light) {
    const glm::vec3 direction = light.w != 0 ? glm::vec3(light) - sample.position : glm::vec3(light);
    if (direction == glm::vec3(0)) return false;  // at the light
    RayContext context{};
    rtcInitIntersectContext(&context.embree);
    context.own = sample.own;
    RTCRay ray{};
    ray.org_x = sample.position.x;
    ray.org_y = sample.position.y;
    ray.org_z = sample.position.z;
    ray.dir_x = direction.x;
    ray.dir_y = direction.y;
    ray.dir_z = direction.z;
    ray.tfar = light.w != 0 ? std::nextafter(1.0f, 0.0f) : std::numeric_limits<float>::infinity();
    ray.mask = ~0u;
    rtcOccluded1(scene, &context.embree, &ray);
    return ray.tfar < 0;
}

}  // namespace

std::vector<uint8_t> askWitness(const OracleQuestion& question, const std::function<void(double)>& progress) {
    std::vector<uint8_t> answer(question.samples.size(), 0);
    std::vector<uint32_t> casters;
    for (uint32_t i = 0; i < question.triangles.size(); ++i) {
        if (question.isCaster.empty() || question.isCaster[i] != 0) casters.push_back(i);
    }
    if (casters.empty() || answer.empty()) return answer;

    const Device device(rtcNewDevice(nullptr));
    check(device.get());
    const Scene scene = makeScene(device.get(), question.triangles, casters);
    const auto work = [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) answer[i] = occluded(scene.get(), question.samples[i], question.light) ? 1 : 0;
    };
    forEachChunk(answer.size(), work, progress);
    return answer;
}

}  // namespace gno::host::oracle
