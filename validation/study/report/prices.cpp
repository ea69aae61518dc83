// SPDX-License-Identifier: MIT
#include "validation/study/report/prices.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace gno::report {
namespace {

/// The variants with these settings at published and at another precision.
struct Pair {
    const Setup* setup;
    const Variant *published, *exact;
    Spread ratio;
};

std::vector<Pair> exactAgainstPublished(const Study& study) {
    std::vector<Pair> pairs;
    for (const Setup& setup : study.setups)
        for (const Variant& exact : setup.variants) {
            if (!exact.isChecked() || exact.precision != "certified" || !exact.varied.empty() || !exact.bestOf.empty()) continue;
            for (const Variant& published : setup.variants)
                if (published.isChecked() && published.technique == exact.technique && published.precision == "published" &&
                    published.varied.empty() && published.bestOf.empty())
                    pairs.push_back({&setup, &published, &exact, timeRatio(exact, published)});
        }
    return pairs;
}

/// Over all setups, one sentence a technique: what certified costs over published, and what it mends.
void addTechniques(std::vector<std::string>& lines, const std::vector<Pair>& pairs) {
    std::map<std::string, std::vector<const Pair*>> byTechnique;
    for (const Pair& pair : pairs) byTechnique[pair.exact->technique].push_back(&pair);
    for (const auto& [technique, all] : byTechnique) {
        std::vector<double> factors;
        double worst = 0, left = 0;
        std::string where;
        for (const Pair* pair : all) {
            factors.push_back(pair->ratio.median);
            left = std::max(left, pair->exact->wrongPerMillion());
            if (pair->published->wrongPerMillion() <= worst && !where.empty()) continue;
            worst = pair->published->wrongPerMillion();
            where = pair->setup->title;
        }
        const auto [least, greatest] = std::minmax_element(factors.begin(), factors.end());
        lines.push_back(
            fmt::format("{}: certified costs {:.2f}x the time of published (geometric mean of {} scenes and lights; {:.2f}x to {:.2f}x); published "
                        "leaves {} wrong{}, certified {}.",
                        technique, geometricMean(factors), factors.size(), *least, *greatest, perMillion(worst),
                        worst > 0 ? " at worst (" + where + ")" : " anywhere", perMillion(left)));
    }
}

/// Where exactness is free, and where it is dearest.
void addExtremes(std::vector<std::string>& lines, const std::vector<Pair>& pairs) {
    if (pairs.empty()) return;
    std::map<std::string, std::set<std::string>> freeOn;
    for (const Pair& pair : pairs)
        if (pair.ratio.low <= 1) freeOn[pair.exact->technique].insert(pair.setup->title);
    std::vector<std::string> words;
    for (const auto& [technique, setups] : freeOn) words.push_back(fmt::format("{} ({})", technique, setups.size()));
    lines.push_back(
        words.empty()
            ? fmt::format("Exactness is free nowhere: in each of the {} pairs, certified took longer than published in every repeat.", pairs.size())
            : fmt::format("Certified cannot be told from published in time (some repeat was as fast) with, in so many scenes and lights: {}.",
                          fmt::join(words, ", ")));
    const auto dearest = std::max_element(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.ratio.median < b.ratio.median; });
    lines.push_back(fmt::format("Exactness is dearest on {} with {}: {} of published.", dearest->setup->title, dearest->exact->technique,
                                times(dearest->ratio)));
}

/// One sentence a setup: the cheapest exact answer, the cheapest of all, and the most right of those that cannot be exact.
void addSetup(std::vector<std::string>& lines, const Setup& setup) {
    const std::vector<Price> prices = pricesOf(setup);
    const Variant* exact = prices.front().cheapest;
    const Variant *fastest = nullptr, *search = nullptr, *certified = nullptr;
    for (const Variant& variant : setup.variants) {
        if (!variant.isChecked() || variant.peer) continue;
        if (fastest == nullptr || variant.time.median < fastest->time.median) fastest = &variant;
        if (variant.precision == "certified" && (certified == nullptr || variant.time.median < certified->time.median)) certified = &variant;
        if (!variant.bestOf.empty() && (search == nullptr || variant.wrong < search->wrong)) search = &variant;
    }
    if (fastest == nullptr) return;
    if (exact == nullptr) {
        lines.push_back(fmt::format("On {} nothing was exact; the fastest, {}, leaves {} wrong.", setup.title, fastest->fullName(),
                                    perMillion(fastest->wrongPerMillion())));
        return;
    }
    std::string line = fmt::format("On {} the cheapest without a wrong sample is {}, at {} of a bare full-screen pass", setup.title,
                                   exact->fullName(), times(exact->time));
    if (!prices.front().asGood.empty()) line += fmt::format(" (not to be told from it: {})", namesOf(prices.front().asGood));
    if (certified != nullptr && certified != exact)
        line += fmt::format("; the cheapest that promises it, {}, takes {} of that", certified->fullName(), times(timeRatio(*certified, *exact)));
    if (fastest != exact)
        line += fmt::format("; the fastest of all, {}, takes {} of that and leaves {} wrong", fastest->fullName(),
                            times(timeRatio(*fastest, *exact)), perMillion(fastest->wrongPerMillion()));
    if (search != nullptr && search != fastest && search != exact)
        line +=
            fmt::format("; {} leaves {} wrong at {}", search->fullName(), perMillion(search->wrongPerMillion()), times(timeRatio(*search, *exact)));
    for (const Variant& peer : setup.variants)
        if (peer.peer && peer.isChecked())
            line += fmt::format("; {} {} leaves {} wrong at {}", peer.technique, peer.precision, perMillion(peer.wrongPerMillion()),
                                times(timeRatio(peer, *exact)));
    lines.push_back(line + ".");
}

}  // namespace

std::string namesOf(const std::vector<const Variant*>& variants) {
    constexpr size_t kNamed = 3;
    std::vector<std::string> names;
    for (const Variant* variant : variants)
        if (names.size() < kNamed) names.push_back(variant->fullName());
    return fmt::format("{}{}", fmt::join(names, ", "), variants.size() > kNamed ? fmt::format(" and {} more", variants.size() - kNamed) : "");
}

std::string times(const Spread& spread) { return fmt::format("{:.3g}x ({:.3g}..{:.3g})", spread.median, spread.low, spread.high); }

std::string perMillion(double wrong) {
    return wrong == 0 ? "none" : wrong < 10 ? fmt::format("{:.2g} ppm", wrong) : fmt::format("{:.0f} ppm", wrong);
}

std::vector<Price> pricesOf(const Setup& setup) {
    std::vector<Price> prices;
    for (const double threshold : kThresholds) {
        Price price{threshold, nullptr, {}};
        const auto fits = [&](const Variant& variant) { return variant.isChecked() && !variant.peer && variant.wrongPerMillion() <= threshold; };
        for (const Variant& variant : setup.variants)
            if (fits(variant) && (price.cheapest == nullptr || variant.time.median < price.cheapest->time.median)) price.cheapest = &variant;
        for (const Variant& variant : setup.variants)
            if (fits(variant) && &variant != price.cheapest && indistinguishable(variant.time, price.cheapest->time))
                price.asGood.push_back(&variant);
        prices.push_back(std::move(price));
    }
    return prices;
}

std::vector<std::string> findingsOf(const Study& study) {
    std::vector<std::string> lines;
    for (const Setup& setup : study.setups)
        for (const Variant& variant : setup.variants)
            if (variant.isChecked() && variant.precision == "certified" && variant.wrong > 0)
                lines.push_back(fmt::format("BROKEN PROMISE: on {} {} leaves {} of {} samples wrong.", setup.title, variant.fullName(),
                                            variant.wrong, variant.checked));
    const std::vector<Pair> pairs = exactAgainstPublished(study);
    addExtremes(lines, pairs);
    addTechniques(lines, pairs);
    for (const Setup& setup : study.setups) addSetup(lines, setup);
    std::map<std::string, std::set<std::string>> unavailable;
    for (const Setup& setup : study.setups)
        for (const Variant& variant : setup.variants)
            if (!variant.isMeasured())
                unavailable[fmt::format("{} {}: {}", variant.technique, variant.precision, variant.unavailable)].insert(setup.title);
    for (const auto& [what, setups] : unavailable)
        lines.push_back(fmt::format("Unavailable on {} of {} scenes and lights: {}.", setups.size(), study.setups.size(), what));
    return lines;
}

}  // namespace gno::report
