// SPDX-License-Identifier: MIT
// The one file that holds tinygltf's implementation.
#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
