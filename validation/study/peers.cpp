// SPDX-License-Identifier: MIT
#include "validation/study/embree_peer.hpp"
#include "validation/study/peer.hpp"

namespace gno::study {

const std::vector<std::unique_ptr<Peer>>& peers() {
    static const auto list = [] {
        std::vector<std::unique_ptr<Peer>> made;
        made.push_back(makeEmbreePeer());
        return made;
    }();
    return list;
}

}  // namespace gno::study
