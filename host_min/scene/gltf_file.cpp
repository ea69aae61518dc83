// SPDX-License-Identifier: MIT
#include "host_min/scene/gltf_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "host_min/error.hpp"
#include "host_min/scene/extensions.hpp"
#include "host_min/scene/json_guard.hpp"
#include "host_min/scene/one_line.hpp"
#include "host_min/scene/uri.hpp"

namespace gno::host {

namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<unsigned char>;
using Json = nlohmann::json;

constexpr uint32_t kMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr size_t kHeader = 12, kChunkHeader = 8;

uint32_t wordAt(const Bytes& bytes, size_t offset) {  // little endian
    return static_cast<uint32_t>(bytes[offset]) | static_cast<uint32_t>(bytes[offset + 1]) << 8 | static_cast<uint32_t>(bytes[offset + 2]) << 16 |
           static_cast<uint32_t>(bytes[offset + 3]) << 24;
}

std::string_view view(const Bytes& bytes, size_t offset, size_t length) { return {reinterpret_cast<const char*>(bytes.data()) + offset, length}; }

struct Chunks {
    std::string_view json;
    std::optional<std::string_view> binary;
};

Chunks splitGlb(const Bytes& bytes) {
    if (bytes.size() < kHeader + kChunkHeader) throw InputError("is truncated: too short for a GLB header");
    if (const uint32_t version = wordAt(bytes, 4); version != 2) throw InputError(fmt::format("GLB version {} is not supported, only 2", version));
    const size_t length = wordAt(bytes, 8);
    if (length > bytes.size()) throw InputError(fmt::format("is truncated: its header promises {} bytes, it has {}", length, bytes.size()));
    Chunks chunks;
    for (size_t offset = kHeader, index = 0; offset < length; ++index) {
        if (length - offset < kChunkHeader) throw InputError("is truncated: no room for the header of a GLB chunk");
        const size_t size = wordAt(bytes, offset);
        const uint32_t type = wordAt(bytes, offset + 4);
        offset += kChunkHeader;
        if (size > length - offset) throw InputError(fmt::format("GLB chunk {} has {} bytes, but only {} are left", index, size, length - offset));
        if (index == 0 && type != kJsonChunk) throw InputError("its first GLB chunk is not JSON");
        if (index == 0) chunks.json = view(bytes, offset, size);
        if (index == 1 && type == kBinaryChunk) chunks.binary = view(bytes, offset, size);
        offset += size + (4 - size % 4) % 4;  // chunks start at multiples of four
    }
    return chunks;
}

// One buffer of the file. A buffer without bytes of its own stays empty: only a fallback of compressed data may be one (accessors.cpp).
Bytes readBuffer(const Json& from, size_t index, const fs::path& folder, const std::optional<std::string_view>& binary) {
    const std::string what = fmt::format("buffer {}", index);
    if (!from.is_object()) throw InputError(fmt::format("{} is no object", what));
    const auto length = from.find("byteLength");
    if (length == from.end() || !length->is_number_unsigned() || length->get<uint64_t>() == 0 || length->get<uint64_t>() >= 1ull << 31)
        throw InputError(fmt::format("{}: byteLength is not a whole number in [1, 2^31)", what));
    const auto size = static_cast<size_t>(length->get<uint64_t>());
    Bytes bytes;
    if (const auto uri = from.find("uri"); uri != from.end()) {
        if (!uri->is_string()) throw InputError(fmt::format("{}: its uri is no text", what));
        bytes = readUri(folder, uri->get<std::string>(), what);
    } else if (index == 0 && binary && !isFallbackBuffer(from)) {
        const auto* first = reinterpret_cast<const unsigned char*>(binary->data());
        bytes.assign(first, first + std::min(binary->size(), size));
    } else {
        return bytes;
    }
    if (bytes.size() < size) throw InputError(fmt::format("{}: byteLength is {}, its data have {} bytes", what, size, bytes.size()));
    bytes.resize(size);
    return bytes;
}

void readBuffers(const Json& lists, const fs::path& folder, const std::optional<std::string_view>& binary, tinygltf::Model& model) {
    const auto found = lists.find("buffers");
    if (found == lists.end()) return;
    if (!found->is_array()) throw InputError("buffers is not an array");
    for (size_t i = 0; i < found->size(); ++i) model.buffers.emplace_back().data = readBuffer((*found)[i], i, folder, binary);
}

// tinygltf opens no file: buffers and images are ours.
tinygltf::FsCallbacks withoutFiles() {
    return {[](const std::string&, void*) { return false; }, [](const std::string& name, void*) { return name; },
            [](Bytes*, std::string*, const std::string&, void*) { return false; }, nullptr, nullptr};
}

}  // namespace

std::vector<unsigned char> readWholeFile(const fs::path& path) {
    std::error_code error;
    const auto status = fs::status(path, error);
    if (!fs::exists(status)) throw InputError("no such file; check the path");
    if (fs::is_directory(status)) throw InputError("is a folder; name a .glb or .gltf file");
    if (!fs::is_regular_file(status)) throw InputError("is not a regular file; name a .glb or .gltf file");
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    const auto size = fs::file_size(path, error);
    if (!file || error) throw InputError(fmt::format("cannot be opened: {}", std::strerror(errno)));
    if (size == 0) throw InputError("is empty");
    if (size > std::numeric_limits<uint32_t>::max()) throw InputError("is larger than 4 GiB");
    Bytes bytes(size);
    file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    if (static_cast<uintmax_t>(file.gcount()) != size) throw InputError("cannot be read to its end");
    return bytes;
}

fs::path folderOf(const fs::path& model) { return model.has_parent_path() ? model.parent_path() : fs::path("."); }

tinygltf::Model openGltf(const fs::path& path, Notices& notices, Json& lists) {
    const Bytes bytes = readWholeFile(path);
    const bool isGlb = bytes.size() >= 4 && wordAt(bytes, 0) == kMagic;
    const std::string_view all = view(bytes, 0, bytes.size());
    if (const size_t first = all.find_first_not_of(" \t\r\n\xEF\xBB\xBF"); !isGlb && (first == all.npos || all[first] != '{'))
        throw InputError("is not a glTF file: it starts neither with the GLB magic nor with a JSON object");

    const Chunks chunks = isGlb ? splitGlb(bytes) : Chunks{all, {}};
    const std::string json = guardJson(chunks.json, notices, lists);
    tinygltf::Model model;
    std::string error, warning;
    bool done = false;
    try {
        tinygltf::TinyGLTF reader;
        reader.SetFsCallbacks(withoutFiles());
        done = reader.LoadASCIIFromString(&model, &error, &warning, json.data(), static_cast<unsigned>(json.size()), "");
    } catch (const std::exception& reason) {
        throw InputError(fmt::format("is not valid glTF: {}", oneLine(reason.what())));
    }
    if (!done) throw InputError(fmt::format("is not valid glTF: {}", oneLine(error)));
    readBuffers(lists, folderOf(path), chunks.binary, model);
    return model;
}

}  // namespace gno::host
