// SPDX-License-Identifier: MIT
// Lets the text of a GLSL module compile as C++20, so that tests run the very functions that the device runs:
//
//   #include "validation/support/glsl_as_cpp.hpp"
//   namespace gno {
//   #include "glsl/core/orient3d.glsl"
//   }
//
// Which files qualify: those that keep to the rules of glsl/core/portable.h. Their functions are not inline: include a module in one .cpp of a
// program only, or inside a namespace of your own. GLSL built-ins are the functions of namespace gno below. Where GLM's results could differ in
// bits from the device (order of sums), or rest on aliasing, they are written here; the rest is GLM's. `normalize`, `pow`, `exp` and trigonometry
// are left out on purpose: devices do not agree on their bits.
// The sources that include this are built with -ffp-contract=off (target gnomon_flags).
#pragma once
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include <glm/glm.hpp>
#include <glm/integer.hpp>

#include "glsl/core/portable.h"
#include "glsl/core/shared_types.h"

static_assert(GLM_CONFIG_SIMD == GLM_DISABLE, "GLM's intrinsics change the order of sums: do not define GLM_FORCE_INTRINSICS");

#define precise
#define highp
#define mediump
#define lowp

namespace gno {

using glm::bvec2;
using glm::bvec3;
using glm::bvec4;
using glm::ivec2;
using glm::ivec3;
using glm::ivec4;
using glm::mat4;
using glm::uvec2;
using glm::uvec3;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;

using glm::abs;
using glm::all;
using glm::any;
using glm::ceil;
using glm::clamp;
using glm::equal;
using glm::floor;
using glm::fract;
using glm::greaterThan;
using glm::greaterThanEqual;
using glm::lessThan;
using glm::lessThanEqual;
using glm::max;
using glm::min;
using glm::mix;
using glm::not_;
using glm::notEqual;
using glm::sign;
using glm::sqrt;
using glm::trunc;

inline float roundEven(float x) { return std::nearbyint(x); }
inline float log2(float x) { return std::log2(x); }
inline float exp2(float x) { return std::exp2(x); }
inline float inversesqrt(float x) { return 1.0f / std::sqrt(x); }

inline float dot(vec2 x, vec2 y) { return x.x * y.x + x.y * y.y; }
inline float dot(vec3 x, vec3 y) { return (x.x * y.x + x.y * y.y) + x.z * y.z; }
inline float dot(vec4 x, vec4 y) { return ((x.x * y.x + x.y * y.y) + x.z * y.z) + x.w * y.w; }
inline float length(vec2 x) { return std::sqrt(dot(x, x)); }
inline float length(vec3 x) { return std::sqrt(dot(x, x)); }
inline float length(vec4 x) { return std::sqrt(dot(x, x)); }
inline float distance(vec3 x, vec3 y) { return length(x - y); }
inline vec3 cross(vec3 x, vec3 y) { return vec3(x.y * y.z - y.y * x.z, x.z * y.x - y.z * x.x, x.x * y.y - y.x * x.y); }

inline uint floatBitsToUint(float x) { return std::bit_cast<uint>(x); }
inline int floatBitsToInt(float x) { return std::bit_cast<int>(x); }
inline float uintBitsToFloat(uint x) { return std::bit_cast<float>(x); }
inline float intBitsToFloat(int x) { return std::bit_cast<float>(x); }
inline uvec2 floatBitsToUint(vec2 v) { return uvec2(floatBitsToUint(v.x), floatBitsToUint(v.y)); }
inline uvec3 floatBitsToUint(vec3 v) { return uvec3(floatBitsToUint(v.x), floatBitsToUint(v.y), floatBitsToUint(v.z)); }
inline uvec4 floatBitsToUint(vec4 v) { return uvec4(floatBitsToUint(v.x), floatBitsToUint(v.y), floatBitsToUint(v.z), floatBitsToUint(v.w)); }
inline vec2 uintBitsToFloat(uvec2 v) { return vec2(uintBitsToFloat(v.x), uintBitsToFloat(v.y)); }
inline vec3 uintBitsToFloat(uvec3 v) { return vec3(uintBitsToFloat(v.x), uintBitsToFloat(v.y), uintBitsToFloat(v.z)); }
inline vec4 uintBitsToFloat(uvec4 v) { return vec4(uintBitsToFloat(v.x), uintBitsToFloat(v.y), uintBitsToFloat(v.z), uintBitsToFloat(v.w)); }

inline uint uaddCarry(uint x, uint y, uint& carry) {
    const uint sum = x + y;
    carry = sum < x ? 1u : 0u;
    return sum;
}
inline uint usubBorrow(uint x, uint y, uint& borrow) {
    borrow = x < y ? 1u : 0u;
    return x - y;
}
inline void umulExtended(uint x, uint y, uint& msb, uint& lsb) {
    const std::uint64_t product = std::uint64_t{x} * y;
    msb = static_cast<uint>(product >> 32);
    lsb = static_cast<uint>(product);
}
inline void imulExtended(int x, int y, int& msb, int& lsb) {
    const std::int64_t product = std::int64_t{x} * y;
    msb = static_cast<int>(product >> 32);
    lsb = static_cast<int>(product);
}
inline uvec3 uaddCarry(uvec3 x, uvec3 y, uvec3& carry) {
    return uvec3(uaddCarry(x.x, y.x, carry.x), uaddCarry(x.y, y.y, carry.y), uaddCarry(x.z, y.z, carry.z));
}
inline uvec3 usubBorrow(uvec3 x, uvec3 y, uvec3& borrow) {
    return uvec3(usubBorrow(x.x, y.x, borrow.x), usubBorrow(x.y, y.y, borrow.y), usubBorrow(x.z, y.z, borrow.z));
}
inline void umulExtended(uvec3 x, uvec3 y, uvec3& msb, uvec3& lsb) {
    umulExtended(x.x, y.x, msb.x, lsb.x);
    umulExtended(x.y, y.y, msb.y, lsb.y);
    umulExtended(x.z, y.z, msb.z, lsb.z);
}

inline int bitCount(uint x) { return std::popcount(x); }
inline int findMSB(uint x) { return 31 - std::countl_zero(x); }
inline int findLSB(uint x) { return x == 0u ? -1 : std::countr_zero(x); }
inline uint bitfieldExtract(uint x, int offset, int bits) { return bits == 0 ? 0u : (x >> offset) & (0xFFFFFFFFu >> (32 - bits)); }
inline uint bitfieldReverse(uint x) {
    uint result = 0;
    for (int bit = 0; bit < 32; ++bit) {
        result |= ((x >> bit) & 1u) << (31 - bit);
    }
    return result;
}

// One thread only: what the device does atomically, in an order of the caller's.
inline uint atomicCompSwap(uint& memory, uint compare, uint data) {
    const uint before = memory;
    if (before == compare) memory = data;
    return before;
}
inline uint atomicMin(uint& memory, uint data) {
    const uint before = memory;
    if (data < before) memory = data;
    return before;
}
inline uint atomicMax(uint& memory, uint data) {
    const uint before = memory;
    if (data > before) memory = data;
    return before;
}
inline uint atomicAdd(uint& memory, uint data) {
    const uint before = memory;
    memory += data;
    return before;
}
inline uint atomicOr(uint& memory, uint data) {
    const uint before = memory;
    memory |= data;
    return before;
}
inline uint atomicAnd(uint& memory, uint data) {
    const uint before = memory;
    memory &= data;
    return before;
}
inline uint atomicExchange(uint& memory, uint data) {
    const uint before = memory;
    memory = data;
    return before;
}

}  // namespace gno
