// SPDX-License-Identifier: MIT
// A device buffer as a dump holds it: whole records, without what the buffer is longer by.
#pragma once
#include <string>
#include <utility>

#include "host_min/techniques/technique.hpp"

namespace gno::host {

/// The first `count` records of `recordBytes` bytes, a multiple of 4.
inline DumpedBuffer dumped(std::string name, std::string layout, const Buffer& buffer, uint64_t recordBytes, uint64_t count) {
    DumpedBuffer result{std::move(name), std::move(layout), buffer.download(), uint32_t(recordBytes / 4)};
    result.bytes.resize(recordBytes * count);
    return result;
}

}  // namespace gno::host
