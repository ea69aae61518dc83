// SPDX-License-Identifier: MIT
#include "validation/study/embree_peer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>

#include "host_min/error.hpp"
#include "validation/oracle/embree_scene.hpp"
#include "validation/oracle/parallel.hpp"

namespace gno::study {
namespace {

class EmbreePeer final : public Peer {
public:
    [[nodiscard]] const std::string& name() const override { return name_; }
    [[nodiscard]] const std::vector<std::string>& precisions() const override { return precisions_; }

    [[nodiscard]] PeerAnswer run(const host::OracleQuestion& question, const std::string& precision) const override {
        using host::oracle::EmbreeMode;
        if (std::find(precisions_.begin(), precisions_.end(), precision) == precisions_.end())
            throw host::InputError(fmt::format("peer {} has no precision {}: there are {}", name_, precision, fmt::join(precisions_, ", ")));
        const host::oracle::EmbreeScene scene(question.triangles, question.isCaster, precision == "robust" ? EmbreeMode::robust : EmbreeMode::fp32);
        PeerAnswer answer;
        answer.inShadow.resize(question.samples.size());
        const auto start = std::chrono::steady_clock::now();
        const auto work = [&](size_t begin, size_t end) {
            scene.ask(question.samples.subspan(begin, end - begin), question.light, answer.inShadow.data() + begin);
        };
        host::oracle::forEachChunk(question.samples.size(), work, {});
        const std::chrono::duration<double, std::milli> query = std::chrono::steady_clock::now() - start;
        answer.passes = {{"build", scene.buildMs()}, {"query", query.count()}};
        answer.bytes = {{"hierarchy", scene.bytes()}};
        return answer;
    }

private:
    std::string name_ = "embree";
    std::vector<std::string> precisions_{"fp32", "robust"};
};

}  // namespace

std::unique_ptr<Peer> makeEmbreePeer() { return std::make_unique<EmbreePeer>(); }

}  // namespace gno::study
