// SPDX-License-Identifier: MIT
#include "validation/support/device_test.hpp"

#include <cstdlib>
#include <memory>
#include <stdexcept>

#include "validation/support/exact_reference.hpp"

namespace gno::test {

host::Frame frameOf(const Scene& scene) {
    host::Frame frame;
    frame.triangles = scene.triangles;
    frame.material.assign(scene.triangles.size(), 0);
    frame.object.assign(scene.triangles.size(), 0);
    frame.closed = scene.closed.empty() ? std::vector<uint8_t>(scene.triangles.size(), 0) : scene.closed;
    for (size_t i = 0; i < scene.triangles.size(); ++i) {
        const host::Triangle& t = scene.triangles[i];
        frame.low = glm::min(glm::min(t.a, t.b), glm::min(t.c, i == 0 ? t.a : frame.low));
        frame.high = glm::max(glm::max(t.a, t.b), glm::max(t.c, i == 0 ? t.a : frame.high));
    }
    frame.camera.gridFromCamera[3] = glm::dvec4(0, 0, 4, 1);
    if (scene.camera) frame.camera = *scene.camera;
    return frame;
}

host::PassCache& passes() {
    static const host::Device device([] {
        host::DeviceOptions options = host::DeviceOptions::fromEnvironment();
        if (!std::getenv("GNOMON_VALIDATE")) options.validation = true;
        return options;
    }());
    static host::PassCache cache(device);
    return cache;
}

std::vector<host::TechniqueResult> runAll(const Scene& scene, std::span<const std::string> techniques, host::Precision precision,
                                          std::span<const std::string> settings) {
    const host::Frame frame = frameOf(scene);
    host::FrameInputs inputs(passes(), frame, scene.samples, scene.width);
    inputs.setLight(scene.light, scene.cull);
    host::StructureCache structures;
    std::vector<host::TechniqueResult> results;
    for (const std::string& name : techniques) {
        host::Technique& technique = host::techniqueByName(name);
        results.push_back(
            technique.run(inputs, structures, host::Settings(technique.info().settings, settings), {precision, 1, true, false, false}));
        for (auto* mask : {&results.back().visibility, &results.back().visitedNodes, &results.back().deepestStack})
            if (mask->size() > scene.samples.size()) mask->resize(scene.samples.size());
    }
    return results;
}

host::TechniqueResult run(const Scene& scene, const std::string& technique, host::Precision precision, std::span<const std::string> settings) {
    return runAll(scene, std::span(&technique, 1), precision, settings).front();
}

std::vector<uint8_t> castersOf(const Scene& scene) {
    if ((uint32_t(scene.cull) & uint32_t(host::Cull::front)) == 0) return {};
    std::vector<uint8_t> kept(scene.triangles.size(), 1);
    for (size_t i = 0; i < kept.size(); ++i) {
        const host::Triangle& t = scene.triangles[i];  // orient3dLight is the opposite of orient3d(a, b, c, light)
        kept[i] = !(scene.closed[i] && exact::orient3dLight(scene.light, exact::fixed(t.a), exact::fixed(t.b), exact::fixed(t.c)) < 0);
    }
    return kept;
}

host::OracleAnswer ask(const Scene& scene) {
    const host::Frame frame = frameOf(scene);
    host::FrameInputs inputs(passes(), frame, scene.samples, scene.width);
    inputs.setLight(scene.light, scene.cull);
    const std::vector<uint8_t> casters = castersOf(scene);
    return host::makeOracle()->ask({scene.triangles, casters, scene.light, scene.samples}, [](double) {});
}

Wrong compare(const host::TechniqueResult& got, const host::OracleAnswer& want, std::span<const host::OracleSample> samples) {
    if (got.visibility.size() != want.inShadow.size()) throw std::logic_error("masks of different sizes");
    Wrong result;
    for (size_t i = got.visibility.size(); i-- > 0;) {
        uint32_t expected = want.inShadow[i] ? GNO_VISIBILITY_SHADOW : GNO_VISIBILITY_LIT;
        if (!samples.empty() && samples[i].own == GNO_FACING_AWAY) expected = GNO_VISIBILITY_FACING_AWAY;
        if (!samples.empty() && samples[i].own == GNO_BACKGROUND) expected = GNO_VISIBILITY_BACKGROUND;
        if (got.visibility[i] == expected) continue;
        ++result.wrong;
        result.leaks += want.inShadow[i] != 0;
        result.falseDark += want.inShadow[i] == 0;
        result.first = i;
    }
    return result;
}

}  // namespace gno::test
