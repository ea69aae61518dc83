// SPDX-License-Identifier: MIT
#include "host_min/scene/notices.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host_min/scene/one_line.hpp"

namespace gno::host {

std::string_view subjectOf(std::string_view notice) { return notice.substr(0, notice.find(": ")); }

bool Notices::add(std::string notice) {
    const auto isSame = [&](const std::string& line) { return subjectOf(line) == subjectOf(notice); };
    if (std::any_of(lines_.begin(), lines_.end(), isSame)) return false;
    if (lines_.size() < kMost)
        lines_.push_back(std::move(notice));
    else
        ++leftOut_;
    return true;
}

std::vector<std::string> Notices::lines() const {
    std::vector<std::string> all = lines_;
    if (leftOut_ > 0) all.push_back(fmt::format("more of this kind: {} left out", counted(leftOut_, "line")));
    return all;
}

std::string enumerated(const std::vector<std::pair<size_t, std::string>>& things) {
    constexpr size_t kFew = 4;
    std::string text;
    for (size_t i = 0; i < std::min(things.size(), kFew); ++i) {
        text += fmt::format("{}{}", i > 0 ? ", " : "", things[i].first);
        if (!things[i].second.empty()) text += fmt::format(" ({})", things[i].second);
    }
    return things.size() > kFew ? text + fmt::format(" and {} more", things.size() - kFew) : text;
}

}  // namespace gno::host
