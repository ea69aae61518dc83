// SPDX-License-Identifier: MIT
#include <algorithm>

#include "validation/mutants/cases.hpp"
#include "validation/mutants/scene_parts.hpp"

namespace gno::mutants {
namespace {

TinyScene alone(const TinyScene& s, size_t caster) {
    TinyScene result{s.light, {s.casters[caster]}, s.samples};
    for (GnoViewSample& sample : result.samples) sample.own = sample.own == caster ? 0 : GNO_NO_CASTER;
    return result;
}

// Index of a sample that is lit among all casters and dark with one of them alone; the number of samples when there is none.
size_t firstLost(const TinyScene& s, const std::vector<uint8_t>& expected, cpu::TopTree& tree, uint mode) {
    const cpu::FloatMode floatMode(mode);
    const size_t count = s.samples.size();
    std::vector<uint8_t> dark(count);
    for (size_t i = 0; i < s.casters.size(); ++i) {
        const auto first = expected.begin() + std::ptrdiff_t(i * count);
        if (std::find(first, first + std::ptrdiff_t(count), 1) == first + std::ptrdiff_t(count)) continue;
        const TinyScene one = alone(s, i);
        tree.build(one.casters, one.light, GNO_PRECISION_CONSERVATIVE, std::vector<uint>{0});
        for (size_t k = 0; k < count; ++k) dark[k] |= expected[i * count + k] != 0 && tree.ask(cpu::TopQuery::dPsv, one.samples[k]).inShadow;
    }
    tree.build(s.casters, s.light, GNO_PRECISION_CONSERVATIVE, cpu::insertionOrder(uint(s.casters.size()), mode));
    for (size_t k = 0; k < count; ++k) {
        for (const cpu::TopQuery query : cpu::kTopQueries) {
            if (dark[k] && !tree.ask(query, s.samples[k]).inShadow) return k;
        }
    }
    return count;
}

std::string where(size_t scene, const std::string& what, const TinyScene& s) {
    std::string text = "scene ";
    text += std::to_string(scene);
    text += ", ";
    text += what;
    text += '\n';
    text += show(s);
    return text;
}

}  // namespace

std::vector<uint8_t> oneByOne(const TinyScene& s) {
    std::vector<uint8_t> all;
    for (size_t i = 0; i < s.casters.size(); ++i) {
        const std::vector<uint8_t> answers = exactAnswers(alone(s, i));
        all.insert(all.end(), answers.begin(), answers.end());
    }
    return all;
}

std::string failure(const Case& c, cpu::TopTree& tree, size_t scenes) {
    for (size_t i = 0; i < std::min(c.scenes.size(), scenes); ++i) {
        const TinyScene& s = c.scenes[i];
        const uint mode = uint(i) % cpu::kFloatModes;
        if (c.check == Check::decision) {
            const cpu::FloatMode floatMode(mode);
            for (size_t k = 0; k < s.samples.size(); ++k) {
                const bool got = tree.decide(s.light, s.casters[0], s.samples[k].position, GNO_PRECISION_CERTIFIED);
                if (got != (c.expected[i][k] != 0)) return where(i, "decision on sample " + std::to_string(k), s);
            }
            continue;
        }
        if (c.check == Check::nothingLost) {
            const size_t lost = firstLost(s, c.expected[i], tree, mode);
            if (lost < s.samples.size()) return where(i, "sample " + std::to_string(lost) + " is lost", s);
            continue;
        }
        const uint precision = c.check == Check::conservative ? GNO_PRECISION_CONSERVATIVE : GNO_PRECISION_CERTIFIED;
        const uint count = uint(s.casters.size());
        std::vector<uint> order(count);
        for (uint way = 0; way < 3 && (way == 0 || count > 1); ++way) {  // forwards, backwards, the program's own
            for (uint k = 0; k < count; ++k) order[k] = way == 0 ? k : count - 1 - k;
            if (way == 2) order = cpu::insertionOrder(count, uint(i));
            const std::string wrong = firstWrong(tree, s, c.expected[i], precision, order, mode);
            if (!wrong.empty()) return where(i, wrong + ", order " + std::to_string(way), s);
        }
    }
    return {};
}

}  // namespace gno::mutants
