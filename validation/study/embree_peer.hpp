// SPDX-License-Identifier: MIT
// Embree's occlusion rays as a peer: precision fp32 is its default, robust its RTC_SCENE_FLAG_ROBUST; build and query on all of the machine's
// threads.
#pragma once
#include "validation/study/peer.hpp"

namespace gno::study {

std::unique_ptr<Peer> makeEmbreePeer();

}  // namespace gno::study
