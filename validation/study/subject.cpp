// SPDX-License-Identifier: MIT
#include "validation/study/subject.hpp"

#include <algorithm>
#include <cmath>

#include "host_min/error.hpp"
#include "validation/study/peer.hpp"

namespace gno::study {
namespace {

const Peer& peerByName(const std::string& name) {
    for (const auto& peer : peers())
        if (peer->name() == name) return *peer;
    throw host::InputError("no peer is called " + name);
}

host::Precision precisionOf(const host::TechniqueInfo& info, const std::string& word) {
    for (const host::Precision precision : info.precisions)
        if (word == host::name(precision)) return precision;
    throw host::InputError("technique " + info.name + " has no precision " + word);
}

}  // namespace

Subject::Subject(host::PassCache& passes, const host::SceneFile& file, const Group& group, bool withSums, const Report& report)
    : file_(file),
      group_(group),
      frame_(file.evaluate(group.frame, host::View{group.camera, group.width, group.height, group.light})),
      inputs_(passes, frame_, group.width, group.height) {
    inputs_.setLight(light().homogeneous, host::cullByName(group_.cull));
    samples_ = host::oracleSamples(inputs_);
    const std::unique_ptr<host::Oracle> oracle = host::makeOracle();
    answer_ = host::askOracle(*oracle, inputs_, withSums && inputs_.hasMaterials(), [&](double) { report("oracle", 0); });
    host::measureFloor(inputs_, 1, true);
}

host::TechniqueResult Subject::run(const Variant& variant, const std::string& bestValue, bool counters) const {
    if (variant.peer) {
        const PeerAnswer told = peerByName(variant.technique).run({frame_.triangles, {}, inputs_.light(), samples_}, variant.precision);
        host::TechniqueResult result;
        size_t sample = 0;
        for (const host::OracleSample& pixel : inputs_.pixels())
            result.visibility.push_back(pixel.own <= GNO_NO_CASTER     ? told.inShadow.at(sample++) ? GNO_VISIBILITY_SHADOW : GNO_VISIBILITY_LIT
                                        : pixel.own == GNO_FACING_AWAY ? GNO_VISIBILITY_FACING_AWAY
                                                                       : GNO_VISIBILITY_BACKGROUND);
        result.passes = told.passes;
        result.bytes = told.bytes;
        return result;
    }
    host::Technique& technique = host::techniqueByName(variant.technique);
    const std::string missing = host::missingFor(technique.info(), inputs_.device().facts());
    if (!missing.empty()) throw host::InputError("the device lacks " + missing);
    std::vector<std::string> given = variant.given;
    if (!bestValue.empty()) given.push_back(variant.bestOf + "=" + bestValue);
    host::StructureCache structures;
    return technique.run(inputs_, structures, host::Settings(technique.info().settings, given),
                         {precisionOf(technique.info(), variant.precision), 1, counters, false, false});
}

double Subject::repeatFloor() {
    inputs_.setLight(light().homogeneous, host::cullByName(group_.cull));
    return host::measureFloor(inputs_, 1, false);
}

host::RecordCheck Subject::compare(const host::TechniqueResult& result, std::vector<uint32_t>* wrongPixels) const {
    return host::compare(result, inputs_, answer_, wrongPixels);
}

DistanceHistogram Subject::distances(const host::TechniqueResult& result, const std::vector<uint32_t>& wrongPixels) {
    const bool withSums = !result.sums.empty();
    auto& distances = withSums ? sumDistances_ : opaqueDistances_;
    if (!wrongPixels.empty() && !distances) {
        std::vector<uint64_t> answers;
        size_t i = 0;
        for (const host::OracleSample& pixel : inputs_.pixels()) {
            if (pixel.own > GNO_NO_CASTER) {
                answers.push_back(kNoAnswer);
            } else if (withSums) {
                const glm::uvec3 sum = answer_.sums[i++];  // up to 2^20 each
                answers.push_back(uint64_t(sum.x) | uint64_t(sum.y) << 21 | uint64_t(sum.z) << 42);
            } else {
                answers.push_back(answer_.inShadow[i++]);
            }
        }
        distances = squaredDistances(inputs_.width(), inputs_.height(), boundaryOf(inputs_.width(), inputs_.height(), answers));
    }
    return distanceHistogram(wrongPixels, distances ? std::span<const int64_t>(*distances) : std::span<const int64_t>(),
                             std::hypot(double(inputs_.width()), double(inputs_.height())));
}

}  // namespace gno::study
