// SPDX-License-Identifier: MIT
// Vulkan-Hpp RAII, in one place so that it can be precompiled.
#pragma once
#include <vulkan/vulkan_raii.hpp>
