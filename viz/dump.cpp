// SPDX-License-Identifier: MIT
#include "viz/dump.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <fstream>

#include "host_min/error.hpp"

namespace gno::viz {
namespace {

using host::InputError;
using nlohmann::json;
constexpr const char* kEnding = "-dump.json";
constexpr uint32_t kSchema = 1;
static_assert(std::endian::native == std::endian::little, "buffers are read as they were written");

json parseIndex(const std::filesystem::path& path) {
    if (!path.filename().string().ends_with(kEnding))
        throw InputError(
            fmt::format("{}: not the index of a dump; `gnomon shade SCENE --dump` writes files that end in {}", path.string(), kEnding));
    std::ifstream file(path);
    if (!file) throw InputError(fmt::format("{}: cannot be opened", path.string()));
    return json::parse(file);
}

glm::dvec3 vectorOf(const json& list) {
    glm::dvec3 v;
    for (int i = 0; i < 3; ++i) {
        v[i] = list.at(size_t(i)).get<double>();
        if (!std::isfinite(v[i])) throw InputError("a coordinate that is not finite");
    }
    return v;
}

DumpCamera cameraOf(const json& camera) {
    const json& columns = camera.at("grid_from_camera");
    DumpCamera result{camera.at("perspective"), vectorOf(columns.at(3)), vectorOf(columns.at(0)), vectorOf(columns.at(1)), vectorOf(columns.at(2))};
    if (result.perspective)
        result.yfov = camera.at("yfov");
    else
        result.ymag = camera.at("ymag");
    return result;
}

}  // namespace

Dump Dump::load(const std::filesystem::path& path) {
    Dump dump;
    dump.path_ = path;
    try {
        const json index = parseIndex(path);
        if (index.at("schema") != kSchema || index.at("endianness") != "little")
            throw InputError(fmt::format("not schema {}, little endian", kSchema));
        const std::string file = path.filename().string();
        dump.name_ = file.substr(0, file.size() - std::strlen(kEnding));
        dump.record_ = index.at("record");
        for (const char* key : {"scene", "technique", "precision"}) (void)dump.record_.at(key).get_ref<const std::string&>();
        dump.casterCount_ = index.at("casters");
        dump.width_ = index.at("size").at(0);
        dump.height_ = index.at("size").at(1);
        dump.light_ = glm::vec4(vectorOf(index.at("light")), index.at("light").at(3).get<float>());
        const json& grid = index.at("grid");
        dump.low_ = vectorOf(grid.at("low"));
        dump.high_ = vectorOf(grid.at("high"));
        dump.centre_ = vectorOf(grid.at("centre"));
        dump.metres_ = std::ldexp(1.0, grid.at("exponent").get<int>());
        dump.camera_ = cameraOf(index.at("camera"));
        if (index.contains("trace")) dump.traced_ = {index["trace"].at(0).get<uint32_t>(), index["trace"].at(1).get<uint32_t>()};
        for (const json& entry : index.at("buffers")) {
            const std::filesystem::path name = entry.at("file").get<std::string>();
            if (name.has_parent_path()) throw InputError(fmt::format("buffer {} is not beside it", name.string()));
            const Buffer buffer{path.parent_path() / name, entry.at("words"), entry.at("count")};
            std::error_code error;
            const uint64_t bytes = std::filesystem::file_size(buffer.file, error);
            if (error) throw InputError(fmt::format("buffer {} is missing", name.string()));
            if (buffer.words == 0 || buffer.words > 4096 || bytes % (4 * buffer.words) != 0 || bytes / (4 * buffer.words) != buffer.count)
                throw InputError(
                    fmt::format("buffer {} has {} bytes instead of {} records of {} words", name.string(), bytes, buffer.count, buffer.words));
            dump.buffers_[entry.at("name")] = buffer;
        }
    } catch (const json::exception& error) {
        throw InputError(fmt::format("{}: not the index of a dump: {}", path.string(), error.what()));
    } catch (const InputError& error) {
        const std::string text = error.what();
        throw InputError(text.starts_with(path.string()) ? text : fmt::format("{}: {}", path.string(), text));
    }
    return dump;
}

std::string Dump::title() const {
    return fmt::format("{}, light {}, frame {}: {} {}, {}x{}", std::filesystem::path(record_["scene"].get<std::string>()).stem().string(),
                       record_.value("light", 0), record_.value("frame", 0), technique(), precision(), width_, height_);
}

uint64_t Dump::counter(const std::string& key) const {
    const auto counters = record_.find("counters");
    if (counters == record_.end() || !counters->contains(key) || !(*counters)[key].is_number_unsigned())
        throw InputError(fmt::format("{}: its record has no counter {}", path_.string(), key));
    return (*counters)[key];
}

std::vector<char> Dump::readBytes(const std::string& name, size_t recordBytes, uint64_t count, bool mayBeLonger) const {
    const auto at = buffers_.find(name);
    if (at == buffers_.end()) throw InputError(fmt::format("{}: has no buffer {}", path_.string(), name));
    const Buffer& buffer = at->second;
    const uint64_t bytesHeld = 4 * buffer.words * buffer.count;
    const bool isWhole =
        (buffer.words == 1 || 4 * buffer.words == recordBytes) && bytesHeld % recordBytes == 0;  // an array of words may be one of records
    if (!(mayBeLonger ? bytesHeld >= recordBytes : isWhole) || (count > 0 && bytesHeld / recordBytes != count))
        throw InputError(fmt::format("{}: buffer {} holds {} records of {} words; {} of {} are wanted", path_.string(), name, buffer.count,
                                     buffer.words, count > 0 ? std::to_string(count) : "any number", recordBytes / 4));
    std::vector<char> bytes(bytesHeld);
    std::ifstream file(buffer.file, std::ios::binary);
    if (!file.read(bytes.data(), std::streamsize(bytes.size()))) throw InputError(fmt::format("{}: cannot be read", buffer.file.string()));
    return bytes;
}

}  // namespace gno::viz
