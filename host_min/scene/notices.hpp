// SPDX-License-Identifier: MIT
// What a file holds and the program does not use, or takes for something else: nothing is ignored without a word.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gno::host {

/// What a notice is about: its text up to the first ": ".
std::string_view subjectOf(std::string_view notice);

/// Lines "SUBJECT: what becomes of it". A subject is told once, and a file that is odd in very many ways gets kMost lines and a count.
class Notices {
public:
    static constexpr size_t kMost = 32;

    /// True: nothing was said about this subject before.
    bool add(std::string notice);
    [[nodiscard]] std::vector<std::string> lines() const;

private:
    std::vector<std::string> lines_;
    size_t leftOut_ = 0;
};

/// "0 (lamp), 3 and 2 more": numbers with their names, where they have one; a few of many.
std::string enumerated(const std::vector<std::pair<size_t, std::string>>& things);

}  // namespace gno::host
