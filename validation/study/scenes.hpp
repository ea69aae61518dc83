// SPDX-License-Identifier: MIT
// The scenes of a study by name: files, and those that gnomon-scenes would make.
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "host_min/scene/scene.hpp"

namespace gno::study {

struct GeneratedScene {
    std::string kind;  ///< of gnomon-scenes
    uint64_t triangles = 0;
    static constexpr uint64_t kSeed = 1;
};

/// NAME or NAME:TRIANGLES of a scene that gnomon-scenes makes in any size; nullopt: no such name. Throws InputError: a size out of the kind's range.
std::optional<GeneratedScene> generatedScene(const std::string& text);

/// What a chart calls it: the file's stem, or fuzzy_16000.
std::string sceneName(const std::string& text);

/// Loads scenes; keeps the last one. Makes generated ones in `folder` where they are not there yet; their bytes depend on their name only.
class SceneShelf {
public:
    explicit SceneShelf(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Valid until the next call. Throws InputError: neither a file nor a generated scene, or a file that cannot be read.
    const host::SceneFile& load(const std::string& text);

private:
    std::filesystem::path folder_;
    std::string name_;
    std::optional<host::SceneFile> file_;
};

}  // namespace gno::study
