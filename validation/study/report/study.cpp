// SPDX-License-Identifier: MIT
#include "validation/study/report/study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <tuple>

namespace gno::report {
namespace {

std::string settingsText(const nlohmann::ordered_json& settings) {
    std::string text;
    for (const auto& [name, value] : settings.items())
        text += fmt::format("{}{}={}", text.empty() ? "" : " ", name, value.is_string() ? value.get<std::string>() : value.dump());
    return text;
}

std::string joined(std::initializer_list<std::string> words) {
    std::string text;
    for (const std::string& word : words)
        if (!word.empty()) text += (text.empty() ? "" : " ") + word;
    return text;
}

Variant variantOf(const Row& row) {
    Variant variant;
    variant.technique = row.technique;
    variant.precision = row.precision;
    variant.bestOf = row.bestOf;
    variant.peer = row.peer;
    if (!row.bestOf.empty() && row.settings.contains(row.bestOf)) variant.found[row.bestOf] = row.settings.at(row.bestOf);
    for (const std::string& name : row.varied)
        if (name != row.bestOf && row.settings.contains(name)) variant.varied[name] = row.settings.at(name);
    return variant;
}

/// Ratio of each repeat to the bare pass, over the frames; then their spread, and the sums of the checks.
void summarise(Variant& variant) {
    std::vector<std::vector<double>> frames;
    size_t repeats = SIZE_MAX;
    for (const Row* row : variant.rows) {
        frames.push_back(row->toFloor(row->totalMs));
        repeats = std::min(repeats, frames.back().size());
        variant.bytes = std::max(variant.bytes, row->totalBytes());
        if (!row->check) continue;
        variant.checked += row->check->checked;
        variant.wrong += row->check->wrong;
        variant.leaks += row->check->leaks;
    }
    for (size_t i = 0; i < repeats; ++i) {
        std::vector<double> ofFrames;
        for (const auto& frame : frames) ofFrames.push_back(frame[i]);
        variant.repeats.push_back(geometricMean(ofFrames));
    }
    variant.time = spreadOf(variant.repeats);
}

/// The frames on which the greatest number of variants was measured.
std::vector<uint32_t> sharedFrames(const std::map<std::string, std::map<uint32_t, const Row*>>& byVariant) {
    std::map<uint32_t, size_t> count;
    for (const auto& [key, frames] : byVariant)
        for (const auto& [frame, row] : frames)
            if (row->isMeasured()) ++count[frame];
    size_t most = 0;
    for (const auto& [frame, variants] : count) most = std::max(most, variants);
    std::vector<uint32_t> frames;
    for (const auto& [frame, variants] : count)
        if (variants == most) frames.push_back(frame);
    return frames;
}

void addVariants(Setup& setup) {
    std::map<std::string, std::map<uint32_t, const Row*>> byVariant;
    std::vector<std::string> order;
    for (const Row* row : setup.rows) {
        const std::string key = variantOf(*row).key();
        if (!byVariant.contains(key)) order.push_back(key);
        byVariant[key][row->frame] = row;
    }
    setup.frames = sharedFrames(byVariant);
    for (const std::string& key : order) {
        const auto& frames = byVariant.at(key);
        Variant variant = variantOf(*frames.begin()->second);
        for (const uint32_t frame : setup.frames) {
            const auto found = frames.find(frame);
            if (found != frames.end() && found->second->isMeasured()) variant.rows.push_back(found->second);
        }
        if (setup.frames.empty() || variant.rows.size() < setup.frames.size()) {
            for (const auto& [frame, row] : frames)
                if (!row->isMeasured()) variant.unavailable = row->unavailable;
            if (variant.unavailable.empty()) continue;  // measured on other frames only: in the tables, not beside those
            variant.rows.clear();
        } else {
            summarise(variant);
        }
        setup.variants.push_back(std::move(variant));
    }
}

template <class Get>
std::vector<std::string> distinct(const std::vector<Row>& rows, Get get) {
    std::vector<std::string> all;
    for (const Row& row : rows)
        if (std::find(all.begin(), all.end(), get(row)) == all.end()) all.push_back(get(row));
    return all;
}

}  // namespace

std::string Variant::label() const { return joined({technique, settingsText(varied), bestOf.empty() ? "" : "best " + bestOf}); }
std::string Variant::fullName() const {
    return joined({technique, precision, settingsText(varied), found.empty() ? "" : fmt::format("(best {})", settingsText(found))});
}
std::string Variant::key() const { return fmt::format("{}|{}|{}|{}", technique, precision, settingsText(varied), bestOf); }

const Variant* Setup::find(const std::string& key) const {
    const auto found = std::find_if(variants.begin(), variants.end(), [&](const Variant& variant) { return variant.key() == key; });
    return found == variants.end() ? nullptr : &*found;
}

std::string Study::sizes() const {
    std::set<std::string> all;
    for (const Setup& setup : setups) all.insert(fmt::format("{}x{}", setup.size[0], setup.size[1]));
    return fmt::format("{}", fmt::join(all, ", "));
}

int rank(const std::string& precision) { return precision == "certified" ? 3 : precision == "conservative" ? 2 : precision == "published" ? 1 : 0; }

Spread timeRatio(const Variant& a, const Variant& b) {
    if (a.rows.size() == 1 && b.rows.size() == 1 && a.rows[0]->group == b.rows[0]->group && a.rows[0]->run == b.rows[0]->run)
        return spreadOf(ratios(a.rows[0]->totalMs, b.rows[0]->totalMs));
    return spreadOf(ratios(a.repeats, b.repeats));  // each to the bare pass of its own run
}

Study arrange(Results results) {
    Study study;
    study.results = std::move(results);
    const std::vector<Row>& rows = study.results.rows;
    std::set<std::string> lights, cameras, culls;
    for (const Row& row : rows) {
        lights.insert(row.name + std::to_string(row.light));
        cameras.insert(std::to_string(row.camera));
        culls.insert(row.cull);
    }
    std::map<std::string, std::vector<Setup>> bySlug;  // a setup a size
    std::vector<std::string> order;
    for (const Row& row : rows) {
        std::string slug = fmt::format("{}-light{}", row.name, row.light),
                    title = fmt::format("{}, light {} ({})", row.name, row.light, row.lightKind);
        if (cameras.size() > 1) slug += fmt::format("-camera{}", row.camera), title += fmt::format(", camera {}", row.camera);
        if (culls.size() > 1) slug += "-" + row.cull, title += fmt::format(", cull {}", row.cull);
        std::replace_if(
            slug.begin(), slug.end(), [](unsigned char c) { return !std::isalnum(c) && c != '-' && c != '_'; }, '_');
        if (!bySlug.contains(slug)) order.push_back(slug);
        std::vector<Setup>& sizes = bySlug[slug];
        auto found = std::find_if(sizes.begin(), sizes.end(), [&](const Setup& setup) { return setup.size == row.size; });
        if (found == sizes.end()) found = sizes.insert(sizes.end(), {title, slug, row.name, row.size, row.casters, {}, {}, {}});
        found->rows.push_back(&row);
        found->casters = std::max(found->casters, row.casters);
    }
    for (const std::string& slug : order) {
        std::vector<Setup>& sizes = bySlug[slug];
        for (Setup& setup : sizes) addVariants(setup);
        const auto main = std::max_element(sizes.begin(), sizes.end(), [](const Setup& a, const Setup& b) {
            return std::tuple(a.variants.size(), a.size[0] * a.size[1]) < std::tuple(b.variants.size(), b.size[0] * b.size[1]);
        });
        for (auto setup = sizes.begin(); setup != sizes.end(); ++setup) (setup == main ? study.setups : study.others).push_back(std::move(*setup));
    }
    study.device = fmt::format("{}", fmt::join(distinct(rows, [](const Row& row) { return row.device; }), "; "));
    study.techniques = distinct(rows, [](const Row& row) { return row.technique; });
    std::stable_partition(study.techniques.begin(), study.techniques.end(), [&](const std::string& name) {
        return std::any_of(rows.begin(), rows.end(), [&](const Row& row) { return row.technique == name && !row.peer; });
    });
    study.precisions = distinct(rows, [](const Row& row) { return row.precision; });
    std::stable_sort(study.precisions.begin(), study.precisions.end(), [](const std::string& a, const std::string& b) {
        return std::tuple(rank(a) == 0, rank(a)) < std::tuple(rank(b) == 0, rank(b));
    });
    return study;
}

}  // namespace gno::report
