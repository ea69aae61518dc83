// SPDX-License-Identifier: MIT
// What a driver reports in the midst of the work, as this project's errors.
#pragma once
#include <functional>

namespace gno::host {

/// Runs `work`. What Vulkan's C++ binding throws becomes a MemoryError (no memory left, of the device or the host), DeviceLost, or a WorkError that
/// names call and result; all else passes through.
void withVulkanFaults(const std::function<void()>& work);

/// For a catch block: throws what is being handled as one of these.
[[noreturn]] void rethrowVulkanFault();

}  // namespace gno::host
