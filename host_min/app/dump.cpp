// SPDX-License-Identifier: MIT
#include "host_min/app/dump.hpp"

#include <fmt/format.h>

#include "host_min/output/atomic_file.hpp"

namespace gno::host {
namespace {

constexpr uint32_t kSchema = 1;

template <class T>
std::vector<std::byte> bytesOf(const std::vector<T>& values) {
    const auto bytes = std::as_bytes(std::span(values));
    return {bytes.begin(), bytes.end()};
}

template <class Vector>
nlohmann::ordered_json listOf(const Vector& v) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (int i = 0; i < Vector::length(); ++i) list.push_back(v[i]);
    return list;
}

nlohmann::ordered_json cameraOf(const Camera& camera) {
    nlohmann::ordered_json result{{"perspective", camera.perspective}};
    for (int column = 0; column < 4; ++column) result["grid_from_camera"].push_back(listOf(camera.gridFromCamera[column]));
    if (camera.perspective)
        result["yfov"] = camera.yfov;
    else
        result["ymag"] = camera.ymag;
    return result;
}

/// Per pixel what the oracle says of its sample; GNO_BACKGROUND where there is none.
std::vector<DumpedBuffer> oracleBuffers(const FrameInputs& inputs, const OracleAnswer& answer) {
    std::vector<uint32_t> shadow(inputs.pixels().size(), GNO_BACKGROUND), caster(inputs.pixels().size(), GNO_BACKGROUND);
    size_t sample = 0;
    for (size_t i = 0; i < shadow.size(); ++i) {
        if (inputs.pixels()[i].own > GNO_NO_CASTER) continue;
        shadow[i] = answer.inShadow[sample];
        caster[i] = answer.caster[sample];
        ++sample;
    }
    return {{"oracle_shadow", "uint[width * height]: 1 in shadow, every caster taken for opaque; 0 lit", bytesOf(shadow)},
            {"oracle_caster", "uint[width * height]: a caster that shadows the sample, or GNO_NO_CASTER", bytesOf(caster)}};
}

}  // namespace

Dump makeDump(const FrameInputs& inputs, const TechniqueResult& result, const Record& record, const OracleAnswer* answer) {
    Dump dump{fmt::format("{}.{}", record.technique, record.precision), {}, result.dump};
    const Frame& frame = inputs.frame();
    nlohmann::ordered_json& index = dump.index;
    index["schema"] = kSchema;
    index["endianness"] = "little";
    index["casters"] = inputs.triangleCount();
    index["light"] = listOf(inputs.light());
    index["size"] = {inputs.width(), inputs.height()};
    index["grid"] = {
        {"centre", listOf(frame.grid.origin)}, {"exponent", frame.grid.exponent}, {"low", listOf(frame.low)}, {"high", listOf(frame.high)}};
    index["camera"] = cameraOf(frame.camera);
    if (result.traced) index["trace"] = {result.traced->x, result.traced->y};
    index["record"] = toJson(record);

    std::vector<std::byte> casters = inputs.casters().download(), states = inputs.states().download();
    casters.resize(inputs.triangleCount() * sizeof(Triangle));  // the buffers themselves may be longer
    states.resize(inputs.triangleCount() * sizeof(uint32_t));
    dump.buffers.push_back({"casters", "float[9 * casters], grid positions", std::move(casters), 9});
    dump.buffers.push_back({"states", "uint[casters], core/caster_state.glsl", std::move(states)});
    dump.buffers.push_back({"samples", "uvec4[width * height]: position as float bits, own caster", inputs.samples().download(), 4});
    dump.buffers.push_back({"visibility", "uint[width * height], GNO_VISIBILITY_*", bytesOf(result.visibility)});
    const auto addCounts = [&](const char* name, const std::vector<uint32_t>& counts) {
        if (!counts.empty()) dump.buffers.push_back({name, "uint[width * height]", bytesOf(counts)});
    };
    addCounts("visited_nodes", result.visitedNodes);
    addCounts("sample_tests", result.sampleTests);
    addCounts("deepest_stack", result.deepestStack);
    if (answer)
        for (DumpedBuffer& buffer : oracleBuffers(inputs, *answer)) dump.buffers.push_back(std::move(buffer));
    return dump;
}

void writeDump(const std::filesystem::path& folder, const std::string& stem, const Dump& dump) {
    nlohmann::ordered_json index = dump.index;
    for (const DumpedBuffer& buffer : dump.buffers) {
        const std::string file = fmt::format("{}-{}-{}.bin", stem, dump.suffix, buffer.name);
        AtomicFile out(folder / file);
        out.stream().write(reinterpret_cast<const char*>(buffer.bytes.data()), std::streamsize(buffer.bytes.size()));
        out.commit();
        index["buffers"].push_back({{"name", buffer.name},
                                    {"file", file},
                                    {"layout", buffer.layout},
                                    {"words", buffer.words},
                                    {"count", buffer.bytes.size() / (4 * buffer.words)},
                                    {"bytes", buffer.bytes.size()}});
    }
    AtomicFile out(folder / fmt::format("{}-{}-dump.json", stem, dump.suffix));
    out.stream() << index.dump(1) << '\n';
    out.commit();
}

}  // namespace gno::host
