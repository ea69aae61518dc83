// SPDX-License-Identifier: MIT
#include <bit>
#include <exception>

#include "validation/fuzz/finding.hpp"

namespace gno::fuzz {
namespace {

// Counts what the queries did; says what went wrong on a rung that promises nothing but to end.
std::string runThrough(cpu::TopTree& tree, const Input& input, uint precision, std::span<const uint> order, uint64_t& visited, uint64_t& overflows) {
    try {
        const cpu::FloatMode mode(input.floatMode);
        tree.build(input.scene.casters, input.scene.light, precision, order);
        for (const GnoViewSample& sample : input.scene.samples) {
            for (const cpu::TopQuery query : cpu::kTopQueries) {
                const cpu::TopAnswer answer = tree.ask(query, sample);
                visited += answer.visitedNodes;
                overflows += answer.stackOverflows;
            }
        }
    } catch (const std::exception& error) {
        return std::string("precision ") + std::to_string(precision) + ": " + error.what();
    }
    return {};
}

}  // namespace

Finding examine(std::span<const uint8_t> bytes, const std::string& variant) {
    const Input input = sceneFromBytes(bytes);
    const std::vector<uint8_t> expected = cpu::exactAnswers(input.scene);
    const uint count = uint(input.scene.casters.size());
    Finding finding;
    uint64_t visited = 0, overflows = 0, dark = 0;
    for (const uint8_t answer : expected) dark += answer;
    for (const cpu::TopVariant& v : cpu::topVariants()) {
        if (!variant.empty() && v.name != variant) continue;
        const auto tree = v.make();
        for (const uint seed : {input.seed, input.seed + 1}) {
            const std::vector<uint> order = cpu::insertionOrder(count, seed);
            std::string wrong = firstWrong(*tree, input.scene, expected, GNO_PRECISION_CERTIFIED, order, input.floatMode);
            for (uint precision = 0; wrong.empty() && seed == input.seed && precision < 3; ++precision) {
                wrong = runThrough(*tree, input, precision, order, visited, overflows);
            }
            if (wrong.empty()) continue;
            finding.what = "'" + v.name + "', insertion seed " + std::to_string(seed) + ": " + wrong + "\n" + show(input.scene);
            return finding;
        }
    }
    finding.signature = (dark * 64 + uint64_t(std::bit_width(visited))) * 64 + uint64_t(std::bit_width(overflows)) + (uint64_t(count) << 32);
    return finding;
}

}  // namespace gno::fuzz
