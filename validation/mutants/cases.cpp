// SPDX-License-Identifier: MIT
#include "validation/mutants/cases.hpp"

#include "validation/mutants/scene_families.hpp"

namespace gno::mutants {
namespace {

struct Family {
    const char* name;
    Check check;
    int scenes;
    TinyScene (*make)(Random&);
};

constexpr Family kFamilies[] = {
    {"lattice soup", Check::tree, 1500, latticeSoup},
    {"shared edges of a height field", Check::tree, 150, sharedEdges},
    {"large receiver with casters above it", Check::tree, 150, largeReceiver},
    {"large casters near the light", Check::tree, 300, largeNearLight},
    {"light in a closed room", Check::tree, 150, room},
    {"slivers that point at the light", Check::tree, 400, sliversAtLight},
    {"edges along the light's direction", Check::tree, 800, edgesAlongDirection},
    {"many large casters, stacks overflow", Check::tree, 150, stacks},
    {"crossed slivers, stacks overflow", Check::tree, 150, crossedSlivers},
    {"casters in one another's shadow", Check::tree, 800, nested},
    {"nearly coplanar casters", Check::tree, 2500, nearlyCoplanar},
    {"casters that touch", Check::tree, 2500, touching},
    {"numbers of every size", Check::tree, 2000, anyExponent},
    {"smallest units of the grid", Check::tree, 1500, smallestUnits},
    {"touching an edge that points at the light", Check::tree, 3000, touchingAtLight},
    {"at a right angle to the light's direction", Check::tree, 1000, atRightAngle},
    {"just behind the nearest point", Check::tree, 5000, behindNearestPoint},
    {"vertex beside a lateral plane", Check::tree, 10000, besideLateralPlane},
    {"one caster and one point", Check::decision, 20000, oneQuestion},
    {"vertex at the band of a lateral plane, conservative", Check::nothingLost, 20000, besideBand},
    {"lattice soup, conservative", Check::nothingLost, 300, latticeSoup},
    {"seam between two casters, conservative", Check::conservative, 3000, seam},
    {"samples on one caster, conservative", Check::conservative, 3000, onOneCaster},
};

}  // namespace

std::vector<Case> makeCases() {
    std::vector<Case> cases;
    for (const Family& family : kFamilies) {
        uint64_t seed = 2016;  // of the name: a new family leaves the others as they are
        for (const char* letter = family.name; *letter != 0; ++letter) seed = seed * 1099511628211u + uint64_t(*letter);
        Random r(seed);
        Case c{family.name, family.check, {}, {}};
        for (int i = 0; i < family.scenes; ++i) {
            c.scenes.push_back(family.make(r));
            c.expected.push_back(family.check == Check::nothingLost ? oneByOne(c.scenes.back()) : exactAnswers(c.scenes.back()));
        }
        cases.push_back(std::move(c));
    }
    return cases;
}

}  // namespace gno::mutants
