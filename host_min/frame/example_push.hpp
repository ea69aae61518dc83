// SPDX-License-Identifier: MIT
// The push block of glsl/core/examples/frame.glsl.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>

namespace gno::host {

struct ExamplePush {
    glm::vec4 light, viewer;
    glm::uvec2 size;
    uint32_t count, seed, cull, planes;
    uint32_t number = 0;  ///< of the pass: gno::Pass::number
};
static_assert(sizeof(ExamplePush) == 60);

}  // namespace gno::host
