// SPDX-License-Identifier: MIT
// `gnomon shade`: frames x lights x techniques of one scene; pictures, EXR layers, records, the table.
#pragma once
#include "host_min/app/options.hpp"

namespace gno::host {

/// Throws InputError or WorkError, after the results of all techniques that were done are written (but for an interrupt). Prints the table to
/// stdout. Returns false when the validation layer had something to say.
bool shade(const ShadeOptions& options);

}  // namespace gno::host
