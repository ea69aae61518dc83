// SPDX-License-Identifier: MIT
#include "host_min/techniques/array_buffers.hpp"

#include <stdexcept>
#include <string>

namespace gno::host {

bool ArrayBuffers::fit(const Device& device, const ArrayList& list) {
    bool changed = false;
    for (const Array& array : list) {
        const auto found = buffers_.find(array.name);
        if (found != buffers_.end() && found->second.bytes() >= array.bytes) continue;
        if (found != buffers_.end()) buffers_.erase(found);  // before the new one: there may not be room for both
        Buffer& made = buffers_.emplace(array.name, Buffer(device, array.bytes, vk::BufferUsageFlags(bufferUsage(array.usage)))).first->second;
        if (array.first == First::zero) made.fill(0);
        changed = true;
    }
    return changed;
}

const Buffer& ArrayBuffers::operator[](std::string_view name) const {
    const auto found = buffers_.find(name);
    if (found == buffers_.end()) throw std::out_of_range("no array " + std::string(name));
    return found->second;
}

Buffer& ArrayBuffers::operator[](std::string_view name) { return const_cast<Buffer&>(std::as_const(*this)[name]); }

std::vector<Binding> ArrayBuffers::bindings() const {
    std::vector<Binding> result;
    for (const auto& [name, buffer] : buffers_) result.push_back({name, &buffer});
    return result;
}

uint64_t ArrayBuffers::bytes(std::initializer_list<std::string_view> names) const {
    uint64_t sum = 0;
    for (const std::string_view name : names) sum += (*this)[name].bytes();
    return sum;
}

}  // namespace gno::host
