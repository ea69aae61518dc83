// SPDX-License-Identifier: MIT
// What device tests share: one device per program, made-up scenes, and a run of one technique on them.
// device_main.cpp prints driver and subgroup width as line one, and fails the program when the validation layer has something to say.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host_min/oracle.hpp"
#include "host_min/techniques/technique.hpp"

namespace gno::test {

/// Passes of this program's device; made at first use, validation layer on unless GNOMON_VALIDATE=0.
host::PassCache& passes();

/// A scene without a file: triangles and view samples that lie on the grid, a homogeneous light.
struct Scene {
    std::vector<host::Triangle> triangles;
    std::vector<uint8_t> closed;  ///< per triangle; empty: all open
    glm::vec4 light{0, 0, 0, 1};
    std::vector<host::OracleSample> samples;
    host::Cull cull = host::Cull::none;
    std::optional<host::Camera> camera{};  ///< whose pixels the samples are, in rows of `width`; none: one that did not make them
    uint32_t width = 64;
};

/// The scene as a host would hold it.
host::Frame frameOf(const Scene& scene);

/// Runs a technique; entry i of the masks belongs to sample i.
host::TechniqueResult run(const Scene& scene, const std::string& technique, host::Precision precision, std::span<const std::string> settings = {});

/// Several techniques in turn; those that share a structure share it.
std::vector<host::TechniqueResult> runAll(const Scene& scene, std::span<const std::string> techniques, host::Precision precision,
                                          std::span<const std::string> settings = {});

/// Triangles that Scene::cull leaves as casters, by an exact sign of the host's own; empty: all. Given samples may lie anywhere, so front-face
/// culling is not judged (cull_front.hpp): it is these tests' definition of the casters.
std::vector<uint8_t> castersOf(const Scene& scene);

/// The oracle's answer for the same scene (front-face culling included).
host::OracleAnswer ask(const Scene& scene);

struct Wrong {
    uint64_t wrong = 0, leaks = 0, falseDark = 0;
    size_t first = 0;  ///< index of the first wrong sample
};
/// `samples`: those whose own is GNO_FACING_AWAY or GNO_BACKGROUND have to come back as that; without them all count as view samples.
Wrong compare(const host::TechniqueResult& got, const host::OracleAnswer& want, std::span<const host::OracleSample> samples = {});

}  // namespace gno::test
