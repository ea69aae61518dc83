// SPDX-License-Identifier: MIT
#include "validation/bench/rivals.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "host_min/error.hpp"
#include "host_min/output/table.hpp"
#include "validation/study/peer.hpp"

namespace gno::bench {
namespace {

constexpr uint32_t kTile = 8;  // pixels

const study::Peer* peerByName(const std::string& name) {
    for (const auto& peer : study::peers())
        if (peer->name() == name) return peer.get();
    return nullptr;
}

std::vector<std::string> splitAtColons(const std::string& text) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == ':')
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

struct Visits {
    double lit = 0, shadowed = 0, all = 0, worst = 0, tileWorst = 0;
};

Visits visitsOf(const host::FrameInputs& inputs, const host::TechniqueResult& result) {
    Visits v;
    uint64_t counts[2] = {0, 0}, sums[2] = {0, 0};
    uint64_t tiles = 0;
    for (uint32_t top = 0; top < inputs.height(); top += kTile)
        for (uint32_t left = 0; left < inputs.width(); left += kTile) {
            uint32_t worst = 0;
            bool any = false;
            for (uint32_t y = top; y < std::min(top + kTile, inputs.height()); ++y)
                for (uint32_t x = left; x < std::min(left + kTile, inputs.width()); ++x) {
                    const size_t pixel = size_t(y) * inputs.width() + x;
                    if (inputs.pixels()[pixel].own > GNO_NO_CASTER) continue;
                    const size_t dark = result.visibility[pixel] == GNO_VISIBILITY_SHADOW;
                    ++counts[dark];
                    sums[dark] += result.visitedNodes[pixel];
                    worst = std::max(worst, result.visitedNodes[pixel]);
                    any = true;
                }
            if (!any) continue;
            ++tiles;
            v.tileWorst += worst;
            v.worst = std::max(v.worst, double(worst));
        }
    const auto mean = [](double sum, uint64_t count) { return count > 0 ? sum / double(count) : 0; };
    v.lit = mean(double(sums[0]), counts[0]);
    v.shadowed = mean(double(sums[1]), counts[1]);
    v.all = mean(double(sums[0] + sums[1]), counts[0] + counts[1]);
    v.tileWorst = mean(v.tileWorst, tiles);
    return v;
}

struct Lists {
    std::vector<double> lit, shadowed, all, worst, tileWorst;
};

bool knowsSeed(const Contestant& who) {
    const auto& settings = host::techniqueByName(who.name).info().settings;
    return std::any_of(settings.begin(), settings.end(), [](const host::SettingInfo& setting) { return setting.key == "seed"; });
}

host::Precision precisionOf(const host::TechniqueInfo& info, host::Precision wanted) {
    return std::find(info.precisions.begin(), info.precisions.end(), wanted) != info.precisions.end() ? wanted : info.precisions.front();
}

uint64_t sumOfBytes(const host::NamedNumbers& bytes) {
    uint64_t sum = 0;
    for (const auto& [name, count] : bytes) sum += count;
    return sum;
}

void measureTechnique(const Subject& subject, const RivalJob& job, const Contestant& who, uint32_t seed, bool first, Cost& cost, Lists& lists) {
    const host::FrameInputs& inputs = subject.inputs();
    host::Technique& technique = host::techniqueByName(who.name);
    std::vector<std::string> given = who.settings;
    if (knowsSeed(who)) given.push_back(fmt::format("seed={}", seed));
    const bool count = first && (seed == 1 || knowsSeed(who));
    host::StructureCache structures;
    const host::TechniqueResult out =
        technique.run(inputs, structures, host::Settings(technique.info().settings, given),
                      {precisionOf(technique.info(), job.base.precisions.front()), 1, count, false, first && seed == 1});
    double build = 0, query = 0;
    for (const host::RecordPass& pass : out.passes) (host::isBuildPass(pass.name) ? build : query) += pass.ms;
    cost.buildMs.push_back(build);
    cost.queryMs.push_back(query);
    if (!count) return;
    cost.bytes = double(sumOfBytes(out.bytes));
    if (job.base.check) cost.wrong += subject.wrong(out.visibility);
    for (const auto& [key, value] : out.counters.more)
        if (key == "pairs") cost.pairsPerCaster = fmt::format("{:.2f}", double(value) / double(std::max<uint64_t>(inputs.casterCount(), 1)));
    if (out.visitedNodes.empty()) return;
    const Visits v = visitsOf(inputs, out);
    lists.lit.push_back(v.lit);
    lists.shadowed.push_back(v.shadowed);
    lists.all.push_back(v.all);
    lists.worst.push_back(v.worst);
    lists.tileWorst.push_back(v.tileWorst);
}

void measurePeer(const Subject& subject, const RivalJob& job, const Contestant& who, bool first, Cost& cost) {
    const host::FrameInputs& inputs = subject.inputs();
    std::vector<host::OracleSample> samples;
    std::vector<size_t> pixels;
    for (size_t i = 0; i < inputs.pixels().size(); ++i)
        if (inputs.pixels()[i].own <= GNO_NO_CASTER) {
            samples.push_back(inputs.pixels()[i]);
            pixels.push_back(i);
        }
    const study::PeerAnswer answer = peerByName(who.name)->run({inputs.frame().triangles, {}, inputs.light(), samples}, who.settings.front());
    cost.buildMs.push_back(answer.passes.front().ms);
    cost.queryMs.push_back(answer.passes.back().ms);
    if (!first) return;
    cost.bytes = double(sumOfBytes(answer.bytes));
    if (!job.base.check) return;
    std::vector<uint32_t> visibility(inputs.pixels().size(), GNO_VISIBILITY_LIT);
    for (size_t i = 0; i < pixels.size(); ++i)
        if (answer.inShadow[i] != 0) visibility[pixels[i]] = GNO_VISIBILITY_SHADOW;
    cost.wrong += subject.wrong(visibility);
}

std::vector<Cost> measure(host::PassCache& passes, const RivalJob& job, const Job& one, uint64_t& samples, uint64_t& casters) {
    host::Progress progress;
    progress.show(one.scene);
    const Subject subject(passes, one, one.check);
    samples = subject.inputs().sampleCount();
    casters = subject.inputs().casterCount();
    std::vector<Cost> costs(job.contestants.size());
    std::vector<Lists> lists(job.contestants.size());
    for (uint32_t seed = 1; seed <= one.seeds; ++seed)
        for (uint32_t repeat = 0; repeat < one.repeats; ++repeat)
            for (size_t i = 0; i < job.contestants.size(); ++i) {
                const Contestant& who = job.contestants[i];
                progress.show(fmt::format("{} {}", stem(one.scene), who.label), double(seed - 1) / one.seeds);
                if (who.peer)
                    measurePeer(subject, job, who, seed == 1 && repeat == 0, costs[i]);
                else
                    measureTechnique(subject, job, who, seed, repeat == 0, costs[i], lists[i]);
            }
    for (size_t i = 0; i < costs.size(); ++i) {
        costs[i].lit = statistic(lists[i].lit);
        costs[i].shadowed = statistic(lists[i].shadowed);
        costs[i].all = statistic(lists[i].all);
        costs[i].worst = statistic(lists[i].worst);
        costs[i].tileWorst = statistic(lists[i].tileWorst);
        costs[i].allBySeed = lists[i].all;
        costs[i].bytesPerCaster = costs[i].bytes / double(std::max<uint64_t>(casters, 1));
    }
    return costs;
}

std::vector<double> totals(const Cost& cost) {
    std::vector<double> sums = cost.buildMs;
    for (size_t i = 0; i < sums.size(); ++i) sums[i] += cost.queryMs[i];
    return sums;
}

struct Mean {  // geometric
    double logarithms = 0;
    uint32_t count = 0;
    void add(double value) {
        if (!(value > 0)) return;
        logarithms += std::log(value);
        ++count;
    }
    [[nodiscard]] std::string text() const { return count > 0 ? fmt::format("{:.3f}", std::exp(logarithms / count)) : "-"; }
};

}  // namespace

Contestant contestant(const std::string& text) {
    const std::vector<std::string> parts = splitAtColons(text);
    Contestant who{text, parts.front(), {parts.begin() + 1, parts.end()}};
    const study::Peer* peer = peerByName(who.name);
    who.peer = peer != nullptr;
    if (!who.peer) {
        const host::Technique& technique = host::techniqueByName(who.name);
        host::Settings(technique.info().settings, who.settings);  // says what is wrong with them
        return who;
    }
    if (who.settings.empty()) who.settings = {peer->precisions().front()};
    if (who.settings.size() > 1 || std::find(peer->precisions().begin(), peer->precisions().end(), who.settings.front()) == peer->precisions().end())
        throw host::InputError(fmt::format("{}: write {}:PRECISION, one of {}", text, who.name, fmt::join(peer->precisions(), ", ")));
    return who;
}

uint64_t printRivals(host::PassCache& passes, const RivalJob& job) {
    uint64_t wrong = 0;
    for (const auto& [width, height] : job.sizes) {
        fmt::print(
            "\n{}x{}:\n\n| scene | casters | samples | | visits lit | shadowed | all | to first | worst sample | mean of tiles' worst | "
            "pairs/caster | bytes/caster | build ms | query ms | "
            "build | query | both |{}\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|{}\n",
            width, height, job.base.check ? " wrong |" : "", job.base.check ? "---|" : "");
        std::vector<Mean> visits(job.contestants.size()), both(job.contestants.size()), query(job.contestants.size()), bytes(job.contestants.size());
        std::vector<double> slowest(job.contestants.size());
        for (const std::string& scene : job.scenes) {
            Job one = job.base;
            one.scene = scene;
            one.width = width;
            one.height = height;
            uint64_t samples = 0, casters = 0;
            const std::vector<Cost> costs = measure(passes, job, one, samples, casters);
            const Cost& reference = costs.front();
            for (size_t i = 0; i < costs.size(); ++i) {
                const Cost& c = costs[i];
                const bool counted = !c.allBySeed.empty() && !reference.allBySeed.empty() && reference.all.mean > 0;
                const double toFirst = counted ? c.all.mean / reference.all.mean : 0;
                const double bothRatio = medianRatio(totals(c), totals(reference)), queryRatio = medianRatio(c.queryMs, reference.queryMs);
                const auto digits = [&](const Statistic& s, int places) {
                    return c.allBySeed.empty() ? "-" : c.allBySeed.size() > 1 ? s.text(places) : fmt::format("{:.{}f}", s.mean, places);
                };
                fmt::print("| {} | {} | {} | `{}` | {} | {} | {} | {} | {} | {} | {} | {:.1f} | {:.0f} | {:.0f} | {:.2f} | {:.2f} | {:.2f} |",
                           stem(scene), casters, samples, job.contestants[i].label, digits(c.lit, 1), digits(c.shadowed, 1), digits(c.all, 1),
                           counted ? fmt::format("{:.3f}", toFirst) : "-", digits(c.worst, 0), digits(c.tileWorst, 1),
                           c.pairsPerCaster.empty() ? "-" : c.pairsPerCaster, c.bytesPerCaster, statistic(c.buildMs).mean, statistic(c.queryMs).mean,
                           medianRatio(c.buildMs, reference.buildMs), queryRatio, bothRatio);
                fmt::print("{}\n", job.base.check ? fmt::format(" {} |", c.wrong) : "");
                visits[i].add(toFirst);
                both[i].add(bothRatio);
                query[i].add(queryRatio);
                bytes[i].add(c.bytesPerCaster);
                slowest[i] = std::max(slowest[i], bothRatio);
                wrong += c.wrong;
            }
            std::fflush(stdout);
        }
        if (job.scenes.size() < 2) continue;
        fmt::print("\n| geometric mean of {} scenes | visits | bytes/caster | query | both | both, slowest scene |\n|---|---|---|---|---|---|\n",
                   job.scenes.size());
        for (size_t i = 0; i < job.contestants.size(); ++i)
            fmt::print("| `{}` | {} | {} | {} | {} | {:.2f} |\n", job.contestants[i].label, visits[i].text(), bytes[i].text(), query[i].text(),
                       both[i].text(), slowest[i]);
        std::fflush(stdout);
    }
    return wrong;
}

}  // namespace gno::bench
