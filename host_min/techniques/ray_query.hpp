// SPDX-License-Identifier: MIT
// The device's own ray queries (VK_KHR_ray_query) as a technique: one shadow ray per view sample, fp32, against an acceleration structure that the
// driver builds.
#pragma once
#include <memory>

#include "host_min/techniques/technique.hpp"

namespace gno::host {

std::unique_ptr<Technique> makeRayQueryTechnique();

}  // namespace gno::host
