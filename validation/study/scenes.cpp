// SPDX-License-Identifier: MIT
#include "validation/study/scenes.hpp"

#include <charconv>

#include "host_min/error.hpp"
#include "host_min/output/atomic_file.hpp"
#include "scenes/generator/catalogue.hpp"
#include "scenes/generator/glb.hpp"

namespace gno::study {
namespace fs = std::filesystem;

std::optional<GeneratedScene> generatedScene(const std::string& text) {
    const size_t colon = text.find(':');
    const std::string name = text.substr(0, colon);
    for (const scenes::Kind& kind : scenes::catalogue()) {
        if (name != kind.name || kind.build == nullptr) continue;
        GeneratedScene scene{name, kind.defaultSize};
        if (colon == std::string::npos) return scene;
        const std::string size = text.substr(colon + 1);
        const auto [end, error] = std::from_chars(size.data(), size.data() + size.size(), scene.triangles);
        if (error != std::errc{} || end != size.data() + size.size() || scene.triangles < kind.low || scene.triangles > kind.high)
            throw host::InputError("scene " + text + ": the triangles of " + name + " must be a whole number of " + std::to_string(kind.low) +
                                   " to " + std::to_string(kind.high));
        return scene;
    }
    return std::nullopt;
}

std::string sceneName(const std::string& text) {
    if (const auto made = generatedScene(text)) return made->kind + "_" + std::to_string(made->triangles);
    return fs::path(text).stem().string();
}

const host::SceneFile& SceneShelf::load(const std::string& text) {
    if (file_ && name_ == text) return *file_;
    file_.reset();
    const auto made = generatedScene(text);
    fs::path path = text;
    if (made) {
        path = folder_ / (sceneName(text) + ".glb");
        std::error_code ignored;
        if (!fs::exists(path, ignored)) {
            host::makeFolder(folder_);
            const scenes::Kind& kind = scenes::findKind(made->kind);
            const std::string bytes = scenes::encodeGlb(scenes::makeScene(kind, made->triangles, GeneratedScene::kSeed, {}), kind.name);
            host::AtomicFile file(path);
            file.stream().write(bytes.data(), std::streamsize(bytes.size()));
            file.commit();
        }
    } else if (std::error_code ignored; !fs::exists(path, ignored)) {
        std::string names;
        for (const scenes::Kind& kind : scenes::catalogue())
            if (kind.build != nullptr) names += std::string(names.empty() ? "" : ", ") + kind.name;
        throw host::InputError("scene " + text + ": no such file, and none that is generated; those are " + names + ", with :TRIANGLES behind");
    }
    file_.emplace(host::SceneFile::load(path));
    name_ = text;
    return *file_;
}

}  // namespace gno::study
