// SPDX-License-Identifier: MIT
// Linked where the build has no oracle (GNOMON_VALIDATION=OFF).
#include "host_min/oracle.hpp"

namespace gno::host {
std::unique_ptr<Oracle> makeOracle() { return nullptr; }
}  // namespace gno::host
