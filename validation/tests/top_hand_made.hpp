// SPDX-License-Identifier: MIT
// TOP trees written by hand: the test says who hangs where, and the queries of glsl/top answer on the device.
#pragma once
#include <fmt/format.h>

#include <array>
#include <bit>
#include <optional>
#include <string>
#include <vector>

#include "glsl/top/node.h"
#include "validation/support/device_test.hpp"
#include "validation/support/exact_reference.hpp"

namespace gno::test {

struct HandAnswer {
    std::vector<uint32_t> visibility, visited, deepest, overflows;
};

/// One query of glsl/top/examples as the techniques configure it.
struct HandQuery {
    std::string name;
    uint32_t stack = 0;  ///< 0: it has none
    [[nodiscard]] std::string shader() const {
        return name == "d-stackless" ? "query_stackless" : name == "d-hybrid" ? "query_hybrid" : "query_stack";
    }
};

class HandTree {
public:
    explicit HandTree(host::Precision precision, glm::vec4 light = {0, 0, 0, 1}) : precision_(precision), light_(light) {}

    /// A volume that nothing links to yet (the first one is the root); its index. Planes in double, inside negative, the light in front of the cap.
    uint32_t add(const host::Triangle& t) {
        const glm::dvec3 origin = light_.w == 0 ? glm::dvec3(0) : glm::dvec3(light_), towards(light_);
        const std::array<glm::dvec3, 3> v{glm::dvec3(t.a) - origin, glm::dvec3(t.b) - origin, glm::dvec3(t.c) - origin};
        const double length = precision_ == host::Precision::published ? 1.0 : 0.25;  // a short normal widens the band, which is always allowed
        const auto plane = [&](glm::dvec3 n, glm::dvec3 on, bool flip) {
            n *= (flip ? -length : length) / glm::length(n);
            const double offset = -glm::dot(n, on);
            return glm::vec4(glm::vec3(n), float(offset));
        };
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3 a = v[size_t(i)], b = v[size_t((i + 1) % 3)], c = v[size_t((i + 2) % 3)];
            const glm::dvec3 n = light_.w == 0 ? glm::cross(b - a, towards) : glm::cross(a, b);
            planes_.push_back(plane(n, light_.w == 0 ? a : glm::dvec3(0), glm::dot(n, c - a) > 0));
        }
        const glm::dvec3 n = glm::cross(v[1] - v[0], v[2] - v[0]);
        planes_.push_back(plane(n, v[0], light_.w == 0 ? glm::dot(n, towards) < 0 : glm::dot(n, v[0]) > 0));
        const double reach = light_.w == 0 ? 1.75 : std::max({glm::length(v[0]), glm::length(v[1]), glm::length(v[2])});
        const int facing = exact::orient3dLight(light_, exact::fixed(t.a), exact::fixed(t.b), exact::fixed(t.c));
        const std::array<uint32_t, 4> aux{0, GNO_TOP_NONE, uint32_t(facing + 1),
                                          std::bit_cast<uint32_t>(float(reach))};  // least depth 0: never skipped
        for (const uint32_t word : aux) links_.push_back({GNO_TOP_NONE, GNO_TOP_NONE, word, 0});
        casters_.push_back(t);
        return uint32_t(casters_.size() - 1);
    }
    /// `ancestor`: the node whose intersection subtree `child` stands in then, GNO_TOP_NONE in none.
    void positive(uint32_t node, uint32_t child, uint32_t ancestor) {
        links_[node].positiveChild = 4 * child;
        links_[4 * child + 1].aux = ancestor;
    }
    void intersection(uint32_t node, uint32_t child, float wedge) {
        links_[node].intersectionChild = 4 * child;
        links_[4 * child + 1].aux = node;
        const uint32_t half = (std::bit_cast<uint32_t>(wedge) + 0xFFFFu) >> 16;  // one bound per side, but for `published`
        links_[node].wedge = precision_ == host::Precision::published ? std::bit_cast<uint32_t>(wedge) : half << 16 | half;
    }
    void child(uint32_t node, uint32_t any) { links_[node].positiveChild = any; }  ///< which need not be one
    void leastDepth(uint32_t volume, float depth) { links_[4 * volume].aux = std::bit_cast<uint32_t>(depth); }

    /// `shader`: another one of the same bindings and constants.
    [[nodiscard]] HandAnswer ask(const std::vector<host::OracleSample>& samples, const HandQuery& query,
                                 const std::vector<uint32_t>* shader = nullptr) const {
        host::Frame frame;
        frame.triangles = casters_;
        frame.closed.assign(casters_.size(), 0);
        host::FrameInputs inputs(passes(), frame, samples);
        inputs.setLight(light_, host::Cull::none);
        const host::Device& device = passes().device();
        const uint32_t count = uint32_t(casters_.size());
        const GnoTopHeader header{casters_.empty() ? GNO_TOP_NONE : 0u, count, gnoState(uint32_t(precision_)), count};
        host::Buffer planes(device, topPlaneBytes(casters_.size())), links(device, topLinkBytes(casters_.size())), root(device, sizeof header);
        planes.upload(std::span(planes_));
        links.upload(std::span(links_));
        root.upload(std::span(&header, 1));
        host::Image visibility(device, inputs.width(), inputs.height(), vk::Format::eR32Uint);
        host::Image counts(device, inputs.width(), inputs.height(), vk::Format::eR32G32B32A32Uint);
        visibility.clear(vk::ClearColorValue(77u, 77u, 77u, 77u));
        counts.clear(vk::ClearColorValue(77u, 77u, 77u, 77u));
        host::Specialization constants{{GNO_ID_PRECISION, uint32_t(precision_)}, {GNO_ID_DEPTH_TEST, query.name == "psv" ? 0u : 1u}};
        if (query.stack > 0) constants[GNO_ID_STACK_SIZE] = query.stack;
        const std::array resources{host::Binding{"gnoCasters", &inputs.casters()},
                                   host::Binding{"gnoTopPlanes", &planes},
                                   host::Binding{"gnoTopLinks", &links},
                                   host::Binding{"gnoTopHeader", &root},
                                   host::Binding{"gnoSamples", &inputs.samples()},
                                   host::Binding{"gnoVisibility", &visibility},
                                   host::Binding{"gnoCounts", &counts}};
        const host::ExamplePush push = inputs.push();
        host::Recording recording(device);
        recording.barrier();
        const std::optional<host::ComputePass> own =
            shader ? std::optional<host::ComputePass>(std::in_place, device, std::span(*shader), constants) : std::nullopt;
        (own ? *own : passes().compute("top/examples/" + query.shader() + ".comp.counters", constants))
            .dispatch(recording, resources, std::as_bytes(std::span(&push, 1)), (inputs.width() + 7) / 8, (inputs.height() + 7) / 8);
        recording.submit();
        HandAnswer answer;
        answer.visibility = visibility.downloadAs<uint32_t>();
        answer.visibility.resize(samples.size());
        for (const glm::uvec4& pixel : counts.downloadAs<glm::uvec4>()) {
            answer.visited.push_back(pixel.x);
            answer.deepest.push_back(pixel.y);
            answer.overflows.push_back(pixel.z);
        }
        return answer;
    }
    [[nodiscard]] host::Precision precision() const { return precision_; }
    [[nodiscard]] glm::vec4 light() const { return light_; }

private:
    host::Precision precision_;
    glm::vec4 light_;
    std::vector<host::Triangle> casters_;
    std::vector<glm::vec4> planes_;
    std::vector<GnoTopLink> links_;
};

}  // namespace gno::test
