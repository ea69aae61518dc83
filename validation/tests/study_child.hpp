// SPDX-License-Identifier: MIT
// gnomon-study as a child process, and its rows.
#pragma once
#include <string>
#include <vector>

#include "validation/study/results_file.hpp"
#include "validation/tests/cli_child.hpp"

namespace gno::test {

/// Words of a line, split at blanks.
inline std::vector<std::string> words(const std::string& line) {
    std::stringstream stream(line);
    std::vector<std::string> list;
    for (std::string word; stream >> word;) list.push_back(word);
    return list;
}

/// One driver thread: insertions do not race, and every counter is the same again.
inline const ChildOptions kOneThread{{{"LP_NUM_THREADS", "1"}}, {}};

class Study : public testing::Test {
protected:
    const Stage stage;
    const std::filesystem::path results = stage.out() / "results.jsonl";

    /// `sweep LINE --results out/results.jsonl`
    [[nodiscard]] Outcome sweep(const std::string& line, const ChildOptions& options = kOneThread) const {
        return stage.run(words("sweep " + line + " --results " + results.string()), options);
    }
    [[nodiscard]] std::vector<study::Row> rows() const { return study::readResults(results).rows; }
};

}  // namespace gno::test
