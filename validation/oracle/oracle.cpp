// SPDX-License-Identifier: MIT
#include "host_min/oracle.hpp"

#include <atomic>
#include <chrono>
#include <cmath>
#include <string>

#include "host_min/error.hpp"
#include "validation/oracle/caster_tree.hpp"
#include "validation/oracle/definition.hpp"
#include "validation/oracle/parallel.hpp"
#include "validation/oracle/transmission.hpp"
#include "validation/oracle/witness.hpp"

namespace gno::host {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// What the exactness of differences and the tree's proof rest on: multiples of 2^-40, at most 2 in size.
bool onGrid(glm::vec3 v) {
    for (int axis = 0; axis < 3; ++axis) {
        const double units = std::ldexp(double(v[axis]), kGridBits);
        if (!(std::abs(double(v[axis])) <= 2.0) || units != std::floor(units)) return false;
    }
    return true;
}

void checkQuestion(const OracleQuestion& q) {
    const auto fail = [](const std::string& what) { throw WorkError("the oracle was asked about " + what + "; snap positions with Grid::snap"); };
    if (q.triangles.size() >= kNoCaster) throw WorkError("the oracle was asked about more triangles than 32 bits can number");
    if (!q.isCaster.empty() && q.isCaster.size() != q.triangles.size()) {
        throw WorkError("the oracle was asked with a caster list whose length is not the number of triangles");
    }
    if (!q.surfaceOf.empty()) oracle::checkSurfaces(q);
    if ((q.light.w != 0 && q.light.w != 1) || !onGrid(glm::vec3(q.light))) fail("a light that is not on the grid");
    if (q.light == glm::vec4(0)) throw WorkError("the oracle was asked about a directional light without a direction");
    for (size_t i = 0; i < q.triangles.size(); ++i) {
        const Triangle& t = q.triangles[i];
        if (!onGrid(t.a) || !onGrid(t.b) || !onGrid(t.c)) fail("triangle " + std::to_string(i) + ", which is not on the grid");
    }
    for (size_t i = 0; i < q.samples.size(); ++i) {
        if (!onGrid(q.samples[i].position)) fail("sample " + std::to_string(i) + ", which is not on the grid");
        if (q.samples[i].own != kNoCaster && q.samples[i].own >= q.triangles.size()) {
            throw WorkError("the oracle was asked about sample " + std::to_string(i) + ", whose own triangle does not exist");
        }
    }
}

// Shares of the progress bar.
constexpr double kTreeShare = 0.2, kMaskShare = 0.5, kExactShare = 0.9;

std::function<void(double)> share(const std::function<void(double)>& progress, double from, double to) {
    if (!progress) return {};
    return [&progress, from, to](double part) { progress(from + (to - from) * part); };
}

class ExactOracle final : public Oracle {
public:
    /// `caster` is the first one that the tree comes upon: the same in every run, but not the nearest or the lowest. Throws WorkError when a
    /// position is off the grid.
    OracleAnswer ask(const OracleQuestion& question, const std::function<void(double)>& progress) override {
        checkQuestion(question);
        if (progress) progress(0);
        OracleAnswer answer;
        const auto start = Clock::now();
        answerExactly(question, answer, progress);
        answer.seconds = secondsSince(start);

        const auto witnessStart = Clock::now();
        const std::vector<uint8_t> witness = oracle::askWitness(question, share(progress, kExactShare, 1));
        answer.witnessSeconds = secondsSince(witnessStart);
        for (size_t i = 0; i < witness.size(); ++i) answer.witnessDisagreements += witness[i] != answer.inShadow[i];
        if (progress) progress(1);
        return answer;
    }

private:
    static void answerExactly(const OracleQuestion& question, OracleAnswer& answer, const std::function<void(double)>& progress) {
        const auto triangles = question.triangles;
        // Casters that are not edge-on, and every caster's facing sign (0: culled or edge-on, casts nothing).
        std::vector<int8_t> facing(triangles.size(), 0);
        std::vector<uint32_t> casters;
        for (uint32_t i = 0; i < triangles.size(); ++i) {
            if (!question.isCaster.empty() && question.isCaster[i] == 0) continue;
            const Triangle& t = triangles[i];
            facing[i] = int8_t(oracle::orient3d(t.a, t.b, t.c, question.light));
            if (facing[i] != 0) casters.push_back(i);
        }
        const oracle::CasterTree tree(triangles, casters, share(progress, 0, kTreeShare));

        answer.inShadow.assign(question.samples.size(), 0);
        answer.caster.assign(question.samples.size(), kNoCaster);
        std::atomic<uint64_t> selfShadowed = 0;
        const auto work = [&](size_t begin, size_t end) {
            for (size_t i = begin; i < end; ++i) {
                const auto [p, own] = question.samples[i];
                const auto shadows = [&](uint32_t t) { return oracle::inShadowOf(triangles[t], question.light, p, facing[t]); };
                answer.inShadow[i] = tree.any(oracle::ShadowSegment(p, question.light), [&](uint32_t t) {
                    if (t == own || !shadows(t)) return false;
                    answer.caster[i] = t;
                    return true;
                });
                if (answer.inShadow[i] == 0 && own != kNoCaster && facing[own] != 0 && shadows(own)) ++selfShadowed;
            }
        };
        const bool hasSurfaces = !question.surfaceOf.empty();
        const double end = hasSurfaces ? kMaskShare : kExactShare;
        oracle::forEachChunk(question.samples.size(), work, share(progress, kTreeShare, end));
        answer.selfShadowed = selfShadowed;
        if (hasSurfaces) addUp(question, tree, facing, answer, share(progress, end, kExactShare));
    }

    // Sums of contributions. A sum at kNoLight stays there whatever else is added: the tree need not be asked to its end.
    static void addUp(const OracleQuestion& question, const oracle::CasterTree& tree, const std::vector<int8_t>& facing, OracleAnswer& answer,
                      const std::function<void(double)>& progress) {
        answer.sums.assign(question.samples.size(), glm::uvec3(0));
        const auto work = [&](size_t begin, size_t end) {
            for (size_t i = begin; i < end; ++i) {
                if (answer.inShadow[i] == 0) continue;
                const auto [p, own] = question.samples[i];
                tree.any(oracle::ShadowSegment(p, question.light), [&](uint32_t t) {
                    if (t == own || !oracle::inShadowOf(question.triangles[t], question.light, p, facing[t])) return false;
                    answer.sums[i] = glm::min(answer.sums[i] + oracle::contributionOf(question, t, p), glm::uvec3(kNoLight));
                    return answer.sums[i] == glm::uvec3(kNoLight);
                });
            }
        };
        oracle::forEachChunk(question.samples.size(), work, progress);
    }
};

}  // namespace

std::unique_ptr<Oracle> makeOracle() { return std::make_unique<ExactOracle>(); }

}  // namespace gno::host
