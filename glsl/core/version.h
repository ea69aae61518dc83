// SPDX-License-Identifier: MIT
// gnomon core/version.h : which version of the modules this folder holds; read by glslang and by any C or C++ (no GLM, no other file).
//
//   GNO_VERSION_MAJOR, GNO_VERSION_MINOR, GNO_VERSION_PATCH      three numbers
//   GNO_VERSION                                                  one word, later versions are larger: #if GNO_VERSION >= (1 << 22 | 2 << 12 | 0)
//
// Whatever breaks a user of the modules (a macro, a struct, a default binding, a convention) raises the minor number while the major one is 0, later
// the major one; CHANGELOG.md gives the edit that mends it.
//
// Space      none: no positions
// Stages     any
// Requires   #version 450, no extension
#ifndef GNO_CORE_VERSION_H
#define GNO_CORE_VERSION_H
#define GNO_VERSION_MAJOR 0
#define GNO_VERSION_MINOR 1
#define GNO_VERSION_PATCH 0
#define GNO_VERSION ((GNO_VERSION_MAJOR << 22) | (GNO_VERSION_MINOR << 12) | GNO_VERSION_PATCH)
#endif
