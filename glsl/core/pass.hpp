// SPDX-License-Identifier: MIT
// gnomon core/pass.hpp : a frame of a technique as data, for the host. C++20, standard library only; no Vulkan header, but its numbers are Vulkan's.
//
// `*/passes.hpp` make lists of these: which shader runs in which order over how many work groups, what must have happened before it, what it
// writes, and the constants it is specialised with; and the arrays (buffers) that the shaders work on: bytes, first contents, who keeps them.
//
//   for (const gno::Pass& pass : passes) {
//       if (pass.before) { const gno::MemoryBarrier b = gno::barrierBefore(pass); vkCmdPipelineBarrier2(...); }   // words of VkMemoryBarrier2
//       bind the pipeline of pass.shader with pass.constants, the arrays by their names in the shader (pass.renamed first), push pass.number
//       pass.indirect.empty() ? vkCmdDispatch(pass.groups) : vkCmdDispatchIndirect(buffer of pass.indirect, pass.indirectOffset)
//   }
//
// Who does what: a list holds every dispatch of its technique and the barriers BETWEEN them; its first pass also waits for the readers of the frame
// before, so that two frames may follow each other in one command buffer. You make casters and view samples visible before it, and the answer after.
#ifndef GNO_CORE_PASS_HPP
#define GNO_CORE_PASS_HPP
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "constant_ids.h"

namespace gno {

/// At most N values, kept in place. Throws std::length_error when there are more.
template <class T, std::size_t N>
class Few {
public:
    constexpr Few() = default;
    constexpr Few(std::initializer_list<T> values) {
        for (const T& value : values) push_back(value);
    }
    constexpr void push_back(const T& value) {
        if (size_ == N) throw std::length_error("gno::Few is full");
        values_[size_++] = value;
    }
    constexpr const T* begin() const { return values_.data(); }
    constexpr const T* end() const { return values_.data() + size_; }
    constexpr std::size_t size() const { return size_; }

private:
    std::array<T, N> values_{};
    std::size_t size_ = 0;
};

/// What a pass waits for, bits of Pass::before.
enum Before : std::uint32_t {
    kBeforeNothing = 0,
    kBeforeShaders = 1,   ///< what shaders before it wrote to storage, and that they have read what it overwrites
    kBeforeIndirect = 2,  ///< its group counts, written by a shader before it (with kBeforeShaders)
    kBeforeTransfer = 4,  ///< fills and copies before it
    kBeforeDepth = 8,     ///< depth attachments before it
    kBeforeRays = 16,     ///< builds of acceleration structures before it
};

struct Constant {
    std::string_view name;  ///< in the shader: kPrecision; its number: constantId(name)
    std::uint32_t value = 0;
};

struct Renamed {
    std::string_view inShader;  ///< the block's name in this shader
    std::string_view array;     ///< the array that is bound to it in this pass
};

enum class PassKind : std::uint8_t {
    compute,
    fullscreen,  ///< a fragment shader over all pixels, behind core/examples/fullscreen.vert; its output is the visibility
    depth,       ///< a vertex shader into one layer of a depth attachment (cleared to 0, greater passes), `number` is the layer
    command,     ///< no shader: `shader` names what the host records, see the list's header
};

struct Pass {
    std::string_view shader;  ///< below this folder: "top/examples/build.comp"
    std::string_view part;    ///< the record and the tables add its time up under this name: "top_build"
    std::uint32_t before = kBeforeShaders;
    std::array<std::uint32_t, 3> groups{1, 1, 1};  ///< work groups; of a depth pass: vertices, instances, 1
    std::string_view indirect{};                   ///< array whose three words at indirectOffset are the work groups, instead of `groups`
    std::uint32_t indirectOffset = 0;              ///< bytes
    std::uint32_t number = 0;                      ///< what this pass is told besides the frame: a row, a level, a digit; GnoExamplePush::number
    Few<Constant, 8> constants{};
    Few<std::string_view, 12> writes{};  ///< arrays and images (by their names in the shader) that it writes; all others are read at most
    Few<Renamed, 6> renamed{};
    PassKind kind = PassKind::compute;
};
using PassList = std::vector<Pass>;

/// How an array begins.
enum class First : std::uint8_t {
    anything,  ///< the list's passes write before they read
    zero,      ///< zero once, when it is allocated
    host,      ///< you write it: the comment beside the array says what, and when again
};

/// How long an array must keep what it holds.
enum class Kept : std::uint8_t {
    forQuery,  ///< from the build to the last query, one for each light
    forBuild,  ///< during the build only: lights that are built one after the other, and other techniques, may share the memory
};

/// What it must be good for, bits of Array::usage; a VkBufferUsageFlags has the same meaning by other numbers (bufferUsage).
enum Usage : std::uint32_t {
    kUsageStorage = 1,
    kUsageUniform = 2,
    kUsageIndirect = 4,
    kUsageRayInput = 8  ///< builds of acceleration structures read it, by its address
};

struct Array {
    std::string_view name;  ///< of the block in our shaders: gnoTopLinks; there it has one number, the same in every pass of a technique:
    std::uint32_t set = 0, binding = 0;  ///< the defaults of `*bindings.glsl` (a macro each) and of the examples (set 2)
    std::string_view element;            ///< what lies in it: "GnoTopLink[4 casters]"
    std::uint64_t bytes = 0;             ///< > 0
    std::uint32_t usage = kUsageStorage;
    First first = First::anything;
    Kept kept = Kept::forQuery;
};
using ArrayList = std::vector<Array>;

/// Bytes of all arrays that are kept so.
constexpr std::uint64_t bytesOf(const ArrayList& arrays, Kept kept) {
    std::uint64_t sum = 0;
    for (const Array& array : arrays) sum += array.kept == kept ? array.bytes : 0;
    return sum;
}

/// Of the list, by name. Throws std::out_of_range.
constexpr const Array& arrayNamed(const ArrayList& arrays, std::string_view name) {
    for (const Array& array : arrays)
        if (array.name == name) return array;
    throw std::out_of_range("no array of this name");
}

/// VkBufferUsageFlagBits for Array::usage.
constexpr std::uint32_t bufferUsage(std::uint32_t usage) {
    return ((usage & kUsageStorage) ? 0x20u : 0u) | ((usage & kUsageUniform) ? 0x10u : 0u) | ((usage & kUsageIndirect) ? 0x100u : 0u) |
           ((usage & kUsageRayInput) ? 0xA0000u : 0u);
}

/// The words of a VkMemoryBarrier2 (and, as all are below 2^32, of vkCmdPipelineBarrier with a VkMemoryBarrier; but for ray queries).
struct MemoryBarrier {
    std::uint64_t srcStages = 0, srcAccess = 0, dstStages = 0, dstAccess = 0;
};

/// What stands in front of `pass`. All zero when it waits for nothing.
constexpr MemoryBarrier barrierBefore(const Pass& pass) {
    constexpr std::uint64_t drawIndirect = 0x2, vertex = 0x8, fragment = 0x80, early = 0x100, late = 0x200, color = 0x400, compute = 0x800,
                            transfer = 0x1000;
    constexpr std::uint64_t rayBuild = 0x02000000;
    constexpr std::uint64_t indirectRead = 0x1, uniformRead = 0x8, shaderRead = 0x20, shaderWrite = 0x40, colorWrite = 0x100, depthRead = 0x200,
                            depthWrite = 0x400, transferWrite = 0x1000, rayRead = 0x00200000, rayWrite = 0x00400000;
    MemoryBarrier b;
    if (pass.before == kBeforeNothing) return b;
    if (pass.before & kBeforeShaders) {
        b.srcStages |= drawIndirect | vertex | fragment | compute;
        b.srcAccess |= shaderWrite;
    }
    if (pass.before & kBeforeTransfer) {
        b.srcStages |= transfer;
        b.srcAccess |= transferWrite;
    }
    if (pass.before & kBeforeDepth) {
        b.srcStages |= early | late;
        b.srcAccess |= depthWrite;
    }
    if (pass.before & kBeforeRays) {
        b.srcStages |= rayBuild;
        b.srcAccess |= rayWrite;
    }
    switch (pass.kind) {
        case PassKind::compute:
            b.dstStages = compute;
            b.dstAccess = shaderRead | shaderWrite | uniformRead;
            break;
        case PassKind::fullscreen:
            b.dstStages = fragment | color;
            b.dstAccess = shaderRead | uniformRead | colorWrite;
            if (pass.before & kBeforeShaders) b.srcStages |= color, b.srcAccess |= colorWrite;  // the frame before drew the same image
            break;
        case PassKind::depth:
            b.dstStages = vertex | early | late;
            b.dstAccess = shaderRead | uniformRead | depthRead | depthWrite;
            break;
        case PassKind::command:
            b.dstStages = rayBuild | transfer;
            b.dstAccess = shaderRead | rayRead | rayWrite | transferWrite;
            break;
    }
    if (pass.before & kBeforeRays && pass.kind != PassKind::command) b.dstAccess |= rayRead;
    if (pass.before & kBeforeIndirect) {
        b.dstStages |= drawIndirect;
        b.dstAccess |= indirectRead;
    }
    return b;
}

/// The number of a specialization constant by its name in the examples. Throws std::out_of_range.
constexpr std::uint32_t constantId(std::string_view name) {
    constexpr std::pair<std::string_view, std::uint32_t> table[] = {{"kPrecision", GNO_ID_PRECISION},
                                                                    {"kStackSize", GNO_ID_STACK_SIZE},
                                                                    {"kDepthTest", GNO_ID_DEPTH_TEST},
                                                                    {"kSlab", GNO_ID_SLAB},
                                                                    {"kStorePlanes", GNO_ID_STORE_PLANES},
                                                                    {"kGroupSize", GNO_ID_GROUP_SIZE},
                                                                    {"kForm", GNO_ID_FORM},
                                                                    {"kWhat", GNO_ID_WHAT},
                                                                    {"kPass", GNO_ID_PASS},
                                                                    {"kGroups", GNO_ID_GROUPS},
                                                                    {"kViewCull", GNO_ID_VIEW_CULL},
                                                                    {"kUseCover", GNO_ID_USE_COVER},
                                                                    {"kStep", GNO_ID_STEP},
                                                                    {"kNest", GNO_ID_NEST},
                                                                    {"kFaces", GNO_ID_FACES}};
    for (const auto& [known, id] : table)
        if (known == name) return id;
    throw std::out_of_range("no constant of this name");
}

/// Work groups of `size` invocations for `count` of them; at least one, for what the first invocation does for all.
constexpr std::uint32_t groupsFor(std::uint64_t count, std::uint32_t size) {
    return count == 0 ? 1u : static_cast<std::uint32_t>((count + size - 1) / size);
}

}  // namespace gno
#endif
