// SPDX-License-Identifier: MIT
#include "validation/study/peer.hpp"

namespace gno::study {

const std::vector<std::unique_ptr<Peer>>& peers() {
    static const std::vector<std::unique_ptr<Peer>> list;
    return list;
}

}  // namespace gno::study
