// SPDX-License-Identifier: MIT
#include "host_min/output/exr.hpp"

#include <OpenEXR/Iex.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfCompression.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <fmt/format.h>

#include <set>
#include <stdexcept>

#include "host_min/error.hpp"
#include "host_min/output/atomic_file.hpp"

namespace gno::host {

namespace {

class ExrStream : public Imf::OStream {
public:
    explicit ExrStream(AtomicFile& file) : OStream(file.target().c_str()), stream_(file.stream()) {}
    void write(const char bytes[], int count) override { stop(stream_.write(bytes, count).good()); }
    uint64_t tellp() override { return static_cast<uint64_t>(std::streamoff(stream_.tellp())); }
    void seekp(uint64_t position) override { stop(stream_.seekp(static_cast<std::streamoff>(position)).good()); }

private:
    static void stop(bool good) {
        if (!good) throw IEX_NAMESPACE::IoExc("write error");  // AtomicFile knows why
    }
    std::ostream& stream_;
};

Imf::PixelType fileType(const ExrPixels& pixels) {
    if (std::holds_alternative<std::vector<float>>(pixels)) return Imf::FLOAT;
    return std::holds_alternative<std::vector<uint32_t>>(pixels) ? Imf::UINT : Imf::HALF;
}

template <class T>
Imf::Slice slice(Imf::PixelType type, const T* values, uint32_t width, Imath::V2i origin = {0, 0}) {
    return Imf::Slice::Make(type, values, origin, width, 1, sizeof(T), std::size_t{width} * sizeof(T));
}

}  // namespace

ExrLayer exrVectorLayer(std::string name, std::span<const glm::vec3> values) {
    ExrLayer layer{std::move(name), {}};
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<float> channel;
        channel.reserve(values.size());
        for (const glm::vec3& v : values) channel.push_back(v[axis]);
        layer.channels.push_back({std::string(1, "XYZ"[axis]), std::move(channel)});
    }
    return layer;
}

void writeExr(const std::filesystem::path& path, uint32_t width, uint32_t height, std::span<const ExrLayer> layers) {
    Imf::Header header(static_cast<int>(width), static_cast<int>(height));
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::FrameBuffer frame;
    std::set<std::string> names;
    std::vector<std::vector<half>> halves;  // lives until the pixels are written
    halves.reserve(64);
    for (const ExrLayer& layer : layers) {
        for (const ExrChannel& channel : layer.channels) {
            const std::string name = layer.name.empty() || channel.name.empty() ? layer.name + channel.name : layer.name + "." + channel.name;
            const std::size_t count = std::visit([](const auto& values) { return values.size(); }, channel.pixels);
            if (count != std::size_t{width} * height)
                throw std::invalid_argument(fmt::format("writeExr: channel '{}' has {} values, not {} x {}", name, count, width, height));
            if (!names.insert(name).second) throw std::invalid_argument(fmt::format("writeExr: two channels are called '{}'", name));
            const Imf::PixelType type = fileType(channel.pixels);
            header.channels().insert(name, Imf::Channel(type));
            if (const auto* floats = std::get_if<std::vector<float>>(&channel.pixels)) {
                frame.insert(name, slice(type, floats->data(), width));
            } else if (const auto* words = std::get_if<std::vector<uint32_t>>(&channel.pixels)) {
                frame.insert(name, slice(type, words->data(), width));
            } else {
                const auto& bytes = std::get<std::vector<uint8_t>>(channel.pixels);
                const std::vector<half>& values = halves.emplace_back(bytes.begin(), bytes.end());
                frame.insert(name, slice(type, values.data(), width));
            }
        }
    }
    AtomicFile file(path);
    try {
        ExrStream stream(file);
        Imf::OutputFile output(stream, header, 0);
        output.setFrameBuffer(frame);
        output.writePixels(static_cast<int>(height));
    } catch (const IEX_NAMESPACE::BaseExc& error) {
        if (!file.stream().fail()) throw WorkError(fmt::format("cannot write '{}': {}", path.string(), error.what()));
    }
    file.commit();
}

ExrFile readExr(const std::filesystem::path& path) {
    try {
        Imf::InputFile input(path.c_str(), 0);
        const Imath::Box2i window = input.header().dataWindow();
        ExrFile file;
        file.width = static_cast<uint32_t>(window.max.x - window.min.x + 1);
        file.height = static_cast<uint32_t>(window.max.y - window.min.y + 1);
        const std::size_t count = std::size_t{file.width} * file.height;
        Imf::FrameBuffer frame;
        const Imf::ChannelList& channels = input.header().channels();
        for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
            if (channel.channel().xSampling != 1 || channel.channel().ySampling != 1)
                throw InputError(fmt::format("cannot read '{}': channel '{}' is subsampled", path.string(), channel.name()));
            ExrPixels& pixels = file.channels[channel.name()];
            if (channel.channel().type == Imf::UINT) {
                frame.insert(channel.name(), slice(Imf::UINT, pixels.emplace<std::vector<uint32_t>>(count).data(), file.width, window.min));
            } else {
                frame.insert(channel.name(), slice(Imf::FLOAT, pixels.emplace<std::vector<float>>(count).data(), file.width, window.min));
            }
        }
        input.setFrameBuffer(frame);
        input.readPixels(window.min.y, window.max.y);
        return file;
    } catch (const IEX_NAMESPACE::BaseExc& error) {
        throw InputError(fmt::format("cannot read '{}': {}", path.string(), error.what()));
    } catch (const std::bad_alloc&) {
        throw InputError(fmt::format("cannot read '{}': its size does not fit in memory", path.string()));
    }
}

}  // namespace gno::host
