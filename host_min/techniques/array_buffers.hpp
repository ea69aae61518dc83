// SPDX-License-Identifier: MIT
// The buffers of a list of arrays (glsl/core/pass.hpp), by their names in the shaders. They are made anew only when they have to be larger.
#pragma once
#include <map>
#include <string_view>
#include <vector>

#include "glsl/core/pass.hpp"
#include "host_min/vulkan/buffer.hpp"
#include "host_min/vulkan/pass.hpp"

namespace gno::host {

class ArrayBuffers {
public:
    /// Every array of `list` has its bytes afterwards; those that begin with zero are cleared when they are made. Throws WorkError when there is no
    /// memory or a limit of the device would be passed. True: some buffer is another one than before, descriptor sets must be written again.
    bool fit(const Device& device, const ArrayList& list);

    [[nodiscard]] const Buffer& operator[](std::string_view name) const;  ///< throws std::out_of_range
    [[nodiscard]] Buffer& operator[](std::string_view name);
    [[nodiscard]] std::vector<Binding> bindings() const;
    [[nodiscard]] uint64_t bytes(std::initializer_list<std::string_view> names) const;  ///< of these together

private:
    std::map<std::string_view, Buffer, std::less<>> buffers_;
};

}  // namespace gno::host
