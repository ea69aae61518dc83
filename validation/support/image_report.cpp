// SPDX-License-Identifier: MIT
#include "validation/support/image_report.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "host_min/output/atomic_file.hpp"
#include "host_min/output/png.hpp"
#include "host_min/output/shade_picture.hpp"

namespace gno::test {
namespace {

host::Raster<uint8_t> raster(const MaskReport& report, std::span<const uint32_t> mask) {
    host::Raster<uint8_t> result(report.width, report.height);
    for (size_t i = 0; i < mask.size(); ++i) result.pixels[i] = uint8_t(std::min(mask[i], 255u));  // what is no visibility stays none
    return result;
}

}  // namespace

std::filesystem::path writeReport(const std::filesystem::path& folder, const MaskReport& report) {
    const size_t count = size_t(report.width) * report.height;
    for (const size_t size : {report.got.size(), report.want.size(), report.pixels.size(), report.caster.size()})
        if (size != count) throw std::logic_error(fmt::format("a report of {} x {} pixels was given {}", report.width, report.height, size));
    const std::filesystem::path place = folder / report.name;
    std::filesystem::create_directories(place);
    const auto got = raster(report, report.got), want = raster(report, report.want);
    host::writePng(place / "got.png", host::maskPicture(got));
    host::writePng(place / "want.png", host::maskPicture(want));
    host::writePng(place / "diff.png", host::differencePicture(got, want));
    host::AtomicFile table(place / "pixels.csv");
    table.stream() << "x,y,sample_x,sample_y,sample_z,own,caster,got,want\n";
    for (size_t i = 0; i < count; ++i) {
        if (report.got[i] == report.want[i]) continue;
        const host::OracleSample& pixel = report.pixels[i];
        table.stream() << fmt::format("{},{},{},{},{},{},{},{},{}\n", i % report.width, i / report.width, pixel.position.x, pixel.position.y,
                                      pixel.position.z, pixel.own, report.caster[i], report.got[i], report.want[i]);
    }
    table.commit();
    return place;
}

PixelAnswer spread(const host::OracleAnswer& answer, std::span<const host::OracleSample> pixels) {
    PixelAnswer result;
    size_t sample = 0;
    for (const host::OracleSample& pixel : pixels) {
        const bool isSample = pixel.own <= GNO_NO_CASTER;
        if (isSample && sample >= answer.inShadow.size()) throw std::logic_error("the oracle answered for fewer samples");
        result.caster.push_back(isSample ? answer.caster[sample] : host::kNoCaster);
        result.want.push_back(isSample                      ? answer.inShadow[sample] ? GNO_VISIBILITY_SHADOW : GNO_VISIBILITY_LIT
                              : pixel.own == GNO_BACKGROUND ? GNO_VISIBILITY_BACKGROUND
                                                            : GNO_VISIBILITY_FACING_AWAY);
        sample += isSample;
    }
    if (sample != answer.inShadow.size()) throw std::logic_error("the oracle answered for more samples");
    return result;
}

}  // namespace gno::test
