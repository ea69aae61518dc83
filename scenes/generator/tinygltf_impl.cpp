// SPDX-License-Identifier: MIT
#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
