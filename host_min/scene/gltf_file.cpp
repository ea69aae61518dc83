// SPDX-License-Identifier: MIT
#include "host_min/scene/gltf_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <limits>
#include <string_view>

#include "host_min/error.hpp"
#include "host_min/scene/json_guard.hpp"
#include "host_min/scene/one_line.hpp"

namespace gno::host {

namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<unsigned char>;

constexpr uint32_t kMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr size_t kHeader = 12, kChunkHeader = 8;

uint32_t wordAt(const Bytes& bytes, size_t offset) {  // little endian
    return static_cast<uint32_t>(bytes[offset]) | static_cast<uint32_t>(bytes[offset + 1]) << 8 | static_cast<uint32_t>(bytes[offset + 2]) << 16 |
           static_cast<uint32_t>(bytes[offset + 3]) << 24;
}

void appendWord(Bytes& bytes, size_t word) {
    for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<unsigned char>(word >> shift & 0xFF));
}

std::string_view view(const Bytes& bytes, size_t offset, size_t length) { return {reinterpret_cast<const char*>(bytes.data()) + offset, length}; }

struct Chunks {
    std::string_view json, binary;
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

// A GLB as tinygltf wants it: aligned chunks, and no more than it needs.
Bytes joinGlb(std::string json, std::string_view binary) {
    json.append((4 - json.size() % 4) % 4, ' ');
    const size_t binarySize = (binary.size() + 3) / 4 * 4;
    const size_t total = kHeader + kChunkHeader + json.size() + (binarySize > 0 ? kChunkHeader + binarySize : 0);
    if (total > std::numeric_limits<uint32_t>::max()) throw InputError("is larger than 4 GiB");
    Bytes bytes;
    bytes.reserve(total);
    for (const size_t word : {size_t{kMagic}, size_t{2}, total, json.size(), size_t{kJsonChunk}}) appendWord(bytes, word);
    bytes.insert(bytes.end(), json.begin(), json.end());
    if (binarySize > 0) {
        appendWord(bytes, binarySize);
        appendWord(bytes, kBinaryChunk);
        bytes.insert(bytes.end(), binary.begin(), binary.end());
        bytes.resize(total, 0);
    }
    return bytes;
}

bool readBuffer(Bytes* out, std::string* error, const std::string& path, void*) {
    try {
        *out = readWholeFile(path);
        return true;
    } catch (const InputError& reason) {
        *error += reason.what();
        return false;
    }
}

// tinygltf would also look into the current directory.
bool isFileBeside(const std::string& path, void* folder) {
    std::error_code error;
    return path.starts_with(*static_cast<const std::string*>(folder)) && fs::exists(path, error);
}

tinygltf::TinyGLTF makeReader(std::string& folder) {
    tinygltf::TinyGLTF reader;
    const auto ignoreImage = [](tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
        return true;
    };
    reader.SetImageLoader(ignoreImage, nullptr);
    reader.SetFsCallbacks({isFileBeside, [](const std::string& wanted, void*) { return wanted; }, readBuffer, nullptr, &folder});
    return reader;
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

tinygltf::Model openGltf(const fs::path& path, std::vector<std::string>& ignored, nlohmann::json& textureLists) {
    const Bytes bytes = readWholeFile(path);
    const bool isGlb = bytes.size() >= 4 && wordAt(bytes, 0) == kMagic;
    const std::string_view all = view(bytes, 0, bytes.size());
    if (const size_t first = all.find_first_not_of(" \t\r\n\xEF\xBB\xBF"); !isGlb && (first == all.npos || all[first] != '{'))
        throw InputError("is not a glTF file: it starts neither with the GLB magic nor with a JSON object");

    tinygltf::Model model;
    std::string error, warning;
    bool done = false;
    const Chunks chunks = isGlb ? splitGlb(bytes) : Chunks{all, {}};
    const std::string json = guardJson(chunks.json, ignored, textureLists);
    std::string folder = folderOf(path).string();
    try {
        auto reader = makeReader(folder);
        if (isGlb) {
            const Bytes glb = joinGlb(json, chunks.binary);
            done = reader.LoadBinaryFromMemory(&model, &error, &warning, glb.data(), static_cast<unsigned>(glb.size()), folder);
        } else {
            done = reader.LoadASCIIFromString(&model, &error, &warning, json.data(), static_cast<unsigned>(json.size()), folder);
        }
    } catch (const std::exception& reason) {
        throw InputError(fmt::format("is not valid glTF: {}", oneLine(reason.what())));
    }
    if (!done) throw InputError(fmt::format("is not valid glTF: {}", oneLine(error)));
    return model;
}

}  // namespace gno::host
