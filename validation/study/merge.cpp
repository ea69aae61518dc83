// SPDX-License-Identifier: MIT
#include "validation/study/merge.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <map>

#include "host_min/error.hpp"
#include "host_min/output/atomic_file.hpp"

namespace gno::study {
namespace fs = std::filesystem;
namespace {

/// A picture's name as a row may hold it: pictures/FILE and nothing that leads elsewhere.
bool isPictureName(const Row& name) {
    if (!name.is_string()) return false;
    const fs::path path = name.get<std::string>();
    return path.parent_path() == "pictures" && path.has_filename() && path.filename() != "..";
}

bool copyPicture(const fs::path& from, const fs::path& to) {
    std::error_code ignored;
    if (fs::equivalent(from, to, ignored)) return true;
    std::ifstream in(from, std::ios::binary);
    if (!in || !fs::is_regular_file(from, ignored)) return false;
    host::makeFolder(to.parent_path());
    host::AtomicFile out(to);
    if (in.peek() != std::ifstream::traits_type::eof()) out.stream() << in.rdbuf();
    out.commit();
    return true;
}

fs::path folderOf(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

}  // namespace

Merged mergeResults(std::span<const fs::path> files, const fs::path& into) {
    Merged merged;
    std::vector<std::pair<Row, fs::path>> rows;  // and the folder of its pictures
    std::map<std::string, size_t> byJob;
    std::vector<fs::path> all;
    std::error_code ignored;
    if (fs::exists(into, ignored)) all.push_back(into);
    all.insert(all.end(), files.begin(), files.end());
    for (const fs::path& file : all) {
        ReadResults read = readResults(file);
        for (const Problem& problem : read.problems) merged.notes.push_back(fmt::format("{}: {}; left out", file.string(), textOf(problem)));
        for (Row& row : read.rows) {
            const auto [at, isNew] = byJob.emplace(row["job"].get<std::string>(), rows.size());
            if (isNew) {
                rows.emplace_back(std::move(row), folderOf(file));
                continue;
            }
            ++merged.twice;
            auto& there = rows[at->second];
            if (there.first.contains("unavailable") && !row.contains("unavailable")) there = {std::move(row), folderOf(file)};
        }
    }
    host::AtomicFile out(into);
    for (auto& [row, folder] : rows) {
        if (row.contains("pictures")) {
            Row kept = Row::object();
            for (const auto& [key, name] : row["pictures"].items()) {
                if (!isPictureName(name) || !copyPicture(folder / name.get<std::string>(), folderOf(into) / name.get<std::string>())) {
                    merged.notes.push_back(fmt::format("{}: picture {} is missing; left out", folder.string(), name.dump()));
                    continue;
                }
                kept[key] = name;
                ++merged.pictures;
            }
            row["pictures"] = std::move(kept);
        }
        out.stream() << lineOf(row);
        ++merged.rows;
    }
    out.commit();
    return merged;
}

void addMerge(CLI::App& program, Action& chosen) {
    CLI::App* command = program.add_subcommand("merge", "join results files; pictures are copied along");
    const auto files = std::make_shared<std::vector<std::filesystem::path>>();
    const auto into = std::make_shared<std::filesystem::path>();
    command->add_option("FILES", *files, "results files")->required();
    command->add_option("--into", *into, "results file; what it holds already stays")->required();
    command->callback([=, &chosen] {
        chosen = [=] {
            const Merged merged = mergeResults(*files, *into);
            for (const std::string& note : merged.notes) fmt::print(stderr, "gnomon-study: {}\n", note);
            fmt::print("{}: {} rows of {} files, {} left out because their job was there, {} pictures\n", into->string(), merged.rows, files->size(),
                       merged.twice, merged.pictures);
            return 0;
        };
    });
}

}  // namespace gno::study
