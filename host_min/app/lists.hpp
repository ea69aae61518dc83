// SPDX-License-Identifier: MIT
// `gnomon techniques` and `gnomon device`.
#pragma once

namespace gno::host {

void printTechniques();
void printDevices();  ///< throws InputError, after the list, when none qualifies

}  // namespace gno::host
