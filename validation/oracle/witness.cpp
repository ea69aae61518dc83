// SPDX-License-Identifier: MIT
#include "validation/oracle/witness.hpp"

#include "validation/oracle/embree_scene.hpp"
#include "validation/oracle/parallel.hpp"

namespace gno::host::oracle {

std::vector<uint8_t> askWitness(const OracleQuestion& question, const std::function<void(double)>& progress) {
    std::vector<uint8_t> answer(question.samples.size(), 0);
    if (question.triangles.empty() || answer.empty()) return answer;
    const EmbreeScene scene(question.triangles, question.isCaster, EmbreeMode::robust);
    const auto work = [&](size_t begin, size_t end) {
        scene.ask(question.samples.subspan(begin, end - begin), question.light, answer.data() + begin);
    };
    forEachChunk(answer.size(), work, progress);
    return answer;
}

}  // namespace gno::host::oracle
