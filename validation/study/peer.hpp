// SPDX-License-Identifier: MIT
// A peer: somebody else's way to answer for the same view samples on the same cores, measured and checked beside the techniques.
// One class in NAME.cpp, one line in peers.cpp; the sweep finds it from there.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "host_min/oracle.hpp"
#include "host_min/output/record.hpp"

namespace gno::study {

struct PeerAnswer {
    std::vector<uint8_t> inShadow;         ///< one per sample of the question, in its order: 1 = in shadow
    std::vector<host::RecordPass> passes;  ///< "build" and "query", wall clock
    host::NamedNumbers bytes;              ///< of its structure, where it tells
};

class Peer {
public:
    virtual ~Peer() = default;
    [[nodiscard]] virtual const std::string& name() const = 0;                     ///< of the command line and the results: embree
    [[nodiscard]] virtual const std::vector<std::string>& precisions() const = 0;  ///< its own words: fp32, robust
    /// The oracle is asked the very same question: grid positions; casters are the triangles with isCaster (empty: all); a sample's own triangle is
    /// not asked; every caster counts as opaque. Builds its structure anew at each call, so that each repeat times it. Throws InputError when it
    /// cannot.
    [[nodiscard]] virtual PeerAnswer run(const host::OracleQuestion& question, const std::string& precision) const = 0;
};

/// All peers of this build.
const std::vector<std::unique_ptr<Peer>>& peers();

}  // namespace gno::study
