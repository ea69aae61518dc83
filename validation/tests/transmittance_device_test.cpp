// SPDX-License-Identifier: MIT
// core/transmittance.glsl on the device: against the same text compiled as C++ and against the oracle, to the bit; and a whole scene added up in
// several orders, by the device, by the CPU and by the oracle.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <spirv_cross/spirv_cross.hpp>

#include "host_min/error.hpp"
#include "host_min/frame/inputs.hpp"
#include "host_min/vulkan/recording.hpp"
#include "validation/oracle/transmission.hpp"
#include "validation/support/device_test.hpp"
#include "validation/support/glsl_as_cpp.hpp"
#include "validation/support/grid_questions.hpp"
#include "validation/support/spirv_file.hpp"

namespace gno {
namespace {
std::vector<uint32_t> materialOf, texels, sums;
std::vector<GnoSurface> surfaces;
std::vector<GnoMaterial> materials;
}  // namespace
#define GNO_LOAD_MATERIAL_OF(caster_) materialOf[caster_]
#define GNO_LOAD_SURFACE(index_) surfaces[index_]
#define GNO_LOAD_MATERIAL(index_) materials[index_]
#define GNO_LOAD_TEXEL(index_) texels[index_]
#define GNO_TRANSMITTANCE_SUMS sums
#include "glsl/core/orient3d.glsl"
#include "glsl/core/transmittance.glsl"
#include "glsl/core/transmittance_sum.glsl"

namespace {

using host::Binding;
using host::Material;
using host::Surface;
using host::TextureImage;
using host::Wrap;
using questions::Question;
using questions::Random;

/// 24 materials over three images: all alpha modes, wrap modes and filters, with and without an image.
std::shared_ptr<const host::MaterialSet> makeLook(Random& r) {
    auto look = std::make_shared<host::MaterialSet>();
    for (const auto& [width, height] : {std::pair{1u, 1u}, {16u, 16u}, {5u, 3u}}) {
        TextureImage& image = look->images.emplace_back(TextureImage{width, height, {}});
        image.isLinear = width == 5;
        for (uint32_t i = 0; i < width * height; ++i)
            for (int c = 0; c < 4; ++c) image.rgba.push_back(static_cast<uint8_t>(c == 3 && r.below(2) == 0 ? 255 * r.below(2) : r.below(256)));
    }
    for (int i = 0; i < 24; ++i) {
        Material& m = look->materials.emplace_back();
        m.alpha = static_cast<Material::Alpha>(i % 3);
        m.image = i % 4 - 1;
        m.linearFilter = r.below(2) == 0;
        m.wrapU = static_cast<Wrap>(r.below(3));
        m.wrapV = static_cast<Wrap>(r.below(3));
        const auto factor = [&] { return static_cast<float>(0.5 + 0.5 * r.real()); };
        m.baseColor = {factor(), factor(), factor(), m.alpha == Material::Alpha::blend ? 0.3f * factor() : 1.0f};
        m.transmission = m.alpha == Material::Alpha::opaque ? 1.0f : r.below(2) == 0 ? 0.0f : factor();
    }
    return look;
}

Surface makeSurface(Random& r, size_t materialCount) {
    Surface surface;
    surface.material = static_cast<uint32_t>(r.below(static_cast<int>(materialCount)));
    const int reach = r.below(4) == 0 ? (1 << 30) - 1 : 40000;
    for (glm::ivec2& corner : surface.corners) corner = {static_cast<int>(r.real() * reach), static_cast<int>(r.real() * reach)};
    return surface;
}

/// The C++ copies of the modules read what the device's buffers hold.
void installOnCpu(const host::Frame& frame) {
    materialOf = frame.surfaceOf;
    surfaces.clear();
    for (const Surface& s : frame.surfaces) surfaces.push_back({s.corners[0], s.corners[1], s.corners[2], s.material, 0});
    texels.clear();
    std::vector<uint32_t> first;
    for (const TextureImage& image : frame.look->images) {
        first.push_back(static_cast<uint32_t>(texels.size()));
        const auto packed = host::packTexels(image);
        texels.insert(texels.end(), packed.begin(), packed.end());
    }
    materials.clear();
    for (const Material& m : frame.look->materials)
        materials.push_back(
            host::packMaterial(m, m.image < 0 ? nullptr : &frame.look->images[size_t(m.image)], m.image < 0 ? 0 : first[size_t(m.image)]));
}

struct Asked {
    vec4 light, a, b, c, p;
};

TEST(TransmittanceDevice, IsTheCpusAndTheOraclesToTheBit) {
    Random r(20141);
    host::Frame frame;
    frame.look = makeLook(r);
    std::vector<Question> all;
    std::vector<Asked> asked;
    for (const questions::Family& family : questions::kFamilies)
        for (int i = 0; i < 6000; ++i) {
            Question q = family.make(r);
            if (i % 2 == 0) {  // behind the caster, or on the edge of its volume
                const double s = 0.5 * r.real() + 0.5, t = (0.5 * r.real() + 0.5) * (1 - s), k = 0.5 + r.real();
                const glm::dvec3 a(q.t.a), on = a + (glm::dvec3(q.t.b) - a) * s + (glm::dvec3(q.t.c) - a) * t, l(vec3(q.light));
                q.p = r.nudge(q.light.w != 0.0f ? on + (on - l) * k : on - l * k);
            }
            all.push_back(q);
            asked.push_back({q.light, vec4(q.t.a, 0), vec4(q.t.b, 0), vec4(q.t.c, 0), vec4(q.p, 0)});
            frame.triangles.push_back({q.t.a, q.t.b, q.t.c});
            frame.surfaceOf.push_back(r.below(16) == 0 ? host::kOpaque : static_cast<uint32_t>(frame.surfaces.size()));
            if (frame.surfaceOf.back() != host::kOpaque) frame.surfaces.push_back(makeSurface(r, frame.look->materials.size()));
        }
    installOnCpu(frame);

    const host::Device& device = test::passes().device();
    const host::MaterialBuffers buffers(device, frame);
    host::Buffer in(device, asked.size() * sizeof(Asked)), out(device, asked.size() * 32), unused(device, 16);
    in.upload(std::span<const Asked>(asked));
    out.fill(0xDEADBEEFu);
    const host::ComputePass pass(device, test::readSpirv(GNOMON_TRANSMITTANCE_SPIRV));
    const std::array resources{Binding{"gnoMaterialOf", &buffers.of()},
                               Binding{"gnoSurfaces", &buffers.surfaces()},
                               Binding{"gnoMaterials", &buffers.list()},
                               Binding{"gnoTexels", &buffers.texels()},
                               Binding{"gnoTransmittances", &unused},
                               Binding{"questions", &in},
                               Binding{"answers", &out}};
    const auto count = static_cast<uint32_t>(asked.size());
    host::Recording recording(device);
    recording.beginPass("transmittance");
    pass.dispatch(recording, resources, std::as_bytes(std::span(&count, 1)), (count + 63) / 64);
    recording.endPass();
    recording.submit();
    const auto got = out.downloadAs<glm::uvec4>();

    uint64_t partial = 0, volumes = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const Question& q = all[i];
        const uvec3 weights = gnoHitWeights(q.light, q.t, q.p), add = gnoTransmittance(i, q.t, q.light, q.p);
        ASSERT_EQ(got[2 * i], glm::uvec4(weights, gnoWeightedMean(weights, uvec3(0u, 0x80000000u, 0xFFFFFFFFu)))) << questions::show(q);
        ASSERT_EQ(got[2 * i + 1], glm::uvec4(add, gnoContribution(i & 255u))) << questions::show(q);
        if (!gnoInShadowOf(q.light, q.t, q.p)) continue;
        const host::OracleQuestion question{frame.triangles, {}, q.light, {}, frame.surfaceOf, frame.surfaces, frame.look.get()};
        ++volumes;
        ASSERT_EQ(add, host::oracle::contributionOf(question, i, q.p)) << questions::show(q);
        partial += add != uvec3(0) && add != uvec3(GNO_TRANSMITTANCE_OPAQUE) ? 1u : 0u;
    }
    EXPECT_GT(volumes, 10000u);
    EXPECT_GT(partial, 4000u);
    RecordProperty("volumes", std::to_string(volumes));
    RecordProperty("partial", std::to_string(partial));
}

/// 40 layers, one above the other: leaves cut out of masks, panes of coloured glass, blended veils, a few small opaque cards.
struct Layers {
    host::Frame frame;
    std::vector<host::OracleSample> samples;

    explicit Layers(uint64_t seed) {
        Random r(seed);
        frame.look = makeLook(r);
        for (int layer = 0; layer < 40; ++layer) {
            const double z = 0.8 - 0.02 * layer, reach = layer % 10 == 9 ? 0.15 : 0.7;
            const auto corner = [&](double x, double y) {
                return r.nudge({x * reach + 0.05 * r.real(), y * reach + 0.05 * r.real(), z + 0.009 * r.real()});
            };
            const vec3 a = corner(-1, -1), b = corner(1, -1), c = corner(1, 1), d = corner(-1, 1);
            const bool opaque = layer % 10 == 9;
            for (const auto& [t, second] : {std::pair{host::Triangle{a, b, c}, false}, {host::Triangle{a, c, d}, true}}) {
                frame.triangles.push_back(t);
                frame.surfaceOf.push_back(opaque ? host::kOpaque : static_cast<uint32_t>(frame.surfaces.size()));
                if (opaque) continue;
                const int side = 256 * 48;
                frame.surfaces.push_back(
                    {{glm::ivec2(0), second ? glm::ivec2(side) : glm::ivec2(side, 0), second ? glm::ivec2(0, side) : glm::ivec2(side)},
                     static_cast<uint32_t>(layer % frame.look->materials.size())});
            }
        }
        for (int i = 0; i < 3000; ++i) {
            const auto own = static_cast<uint32_t>(r.below(static_cast<int>(frame.triangles.size())));
            samples.push_back(
                {questions::snap(glm::dvec3(0.8 * r.real(), 0.8 * r.real(), 0.4 + 0.5 * r.real())), i % 5 == 0 ? own : host::kNoCaster});
        }
    }
};

struct Push {
    vec4 light;
    uint32_t casters, samples, seed;
};

std::vector<uvec3> sumsOnDevice(const Layers& scene, vec4 light, uint32_t seed) {
    const host::Device& device = test::passes().device();
    const host::MaterialBuffers buffers(device, scene.frame);
    host::Buffer casters(device, scene.frame.triangles.size() * 36), samples(device, scene.samples.size() * 16),
        result(device, scene.samples.size() * 16);
    casters.upload(std::span<const host::Triangle>(scene.frame.triangles));
    samples.upload(std::span<const host::OracleSample>(scene.samples));
    result.fill(0);
    static const host::ComputePass pass(device, test::readSpirv(GNOMON_TRANSMITTANCE_SUM_SPIRV));
    const std::array resources{Binding{"gnoCasters", &casters},
                               Binding{"gnoMaterialOf", &buffers.of()},
                               Binding{"gnoSurfaces", &buffers.surfaces()},
                               Binding{"gnoMaterials", &buffers.list()},
                               Binding{"gnoTexels", &buffers.texels()},
                               Binding{"gnoTransmittances", &result},
                               Binding{"samples", &samples}};
    const Push push{light, static_cast<uint32_t>(scene.frame.triangles.size()), static_cast<uint32_t>(scene.samples.size()), seed};
    const uint32_t groups = (push.casters * push.samples + 63) / 64;
    host::Recording recording(device);
    recording.beginPass("sums");
    pass.dispatch(recording, resources, std::as_bytes(std::span(&push, 1)).first(28), 1024, (groups + 1023) / 1024);
    recording.endPass();
    recording.submit();
    sums = result.downloadAs<uint32_t>();
    std::vector<uvec3> all;
    for (uint i = 0; i < push.samples; ++i) all.push_back(gnoTransmittanceSum(i));
    return all;
}

std::vector<uvec3> sumsOnCpu(const Layers& scene, vec4 light, bool backwards) {
    installOnCpu(scene.frame);
    sums.assign(4 * scene.samples.size(), 0);
    const auto count = static_cast<uint>(scene.frame.triangles.size());
    for (uint pixel = 0; pixel < scene.samples.size(); ++pixel)
        for (uint i = 0; i < count; ++i) {
            const uint caster = backwards ? count - 1 - i : i;
            const host::Triangle& from = scene.frame.triangles[caster];
            const GnoCaster t{from.a, from.b, from.c};
            const auto [p, own] = scene.samples[pixel];
            if (caster != own && gnoInShadowOf(light, t, p)) gnoAddTransmittance(pixel, gnoTransmittance(caster, t, light, p));
        }
    std::vector<uvec3> all;
    for (uint i = 0; i < scene.samples.size(); ++i) all.push_back(gnoTransmittanceSum(i));
    return all;
}

TEST(TransmittanceDevice, AddsUpFortyLayersInAnyOrderAsTheOracleDoes) {
    for (const vec4 light : {vec4(0.25f, -0.125f, 0.9375f, 1), vec4(0.25f, 0.125f, 1, 0)}) {
        const Layers scene(17);
        std::printf("seed 17, %s light\n", light.w != 0 ? "point" : "directional");
        const host::OracleAnswer want = host::makeOracle()->ask(
            {scene.frame.triangles, {}, light, scene.samples, scene.frame.surfaceOf, scene.frame.surfaces, scene.frame.look.get()}, {});
        ASSERT_EQ(want.sums.size(), scene.samples.size());
        for (const uint32_t seed : {1u, 2u, 3u}) EXPECT_EQ(sumsOnDevice(scene, light, seed), want.sums) << "order " << seed;
        EXPECT_EQ(sumsOnCpu(scene, light, false), want.sums);
        EXPECT_EQ(sumsOnCpu(scene, light, true), want.sums);
        uint64_t dark = 0, some = 0, coloured = 0, lit = 0;
        for (const uvec3& sum : want.sums) {
            dark += sum == uvec3(host::kNoLight);
            lit += sum == uvec3(0);
            some += sum != uvec3(host::kNoLight) && sum != uvec3(0);
            coloured += sum.x != sum.y || sum.y != sum.z;
        }
        std::printf("%zu samples: %llu lit, %llu dark, %llu between (%llu coloured)\n", want.sums.size(), static_cast<unsigned long long>(lit),
                    static_cast<unsigned long long>(dark), static_cast<unsigned long long>(some), static_cast<unsigned long long>(coloured));
        EXPECT_GT(dark, 100u);
        EXPECT_GT(lit, 100u);
        EXPECT_GT(coloured, 500u);
    }
}

TEST(MaterialBuffers, RefuseMoreTexelsThanABindingHolds) {
    auto look = std::make_shared<host::MaterialSet>();
    look->materials.emplace_back().image = 0;
    const uint64_t limit = test::passes().device().facts().maxStorageBufferRange / 4;
    look->images.push_back({1u << 15, static_cast<uint32_t>(limit >> 15) + 1, {}});
    host::Frame frame;
    frame.triangles.resize(1);
    frame.surfaceOf = {0};
    frame.surfaces.resize(1);
    frame.look = look;
    try {
        const host::MaterialBuffers buffers(test::passes().device(), frame);
        ADD_FAILURE() << "no error";
    } catch (const host::InputError& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("over the limit of " + std::to_string(limit)), std::string::npos) << text;
        EXPECT_EQ(text.find('\n'), std::string::npos);
    }
}

/// One definition for C++ and GLSL: offsets and strides in the compiled SPIR-V.
TEST(MaterialBuffers, LieInSpirvAsInCpp) {
    const std::vector<uint32_t> spirv = test::readSpirv(GNOMON_TRANSMITTANCE_SPIRV);
    const spirv_cross::Compiler compiler(spirv.data(), spirv.size());
    struct Member {
        std::string name;
        size_t offset;
    };
    const auto expectLayout = [&](const std::string& buffer, const std::vector<Member>& want, size_t bytes) {
        SCOPED_TRACE(buffer);
        for (const spirv_cross::Resource& resource : compiler.get_shader_resources().storage_buffers) {
            if (compiler.get_name(resource.id) != buffer) continue;
            const spirv_cross::SPIRType& block = compiler.get_type(resource.base_type_id);
            EXPECT_EQ(compiler.type_struct_member_array_stride(block, 0), bytes);
            const spirv_cross::TypeID element = compiler.get_type(block.member_types[0]).self;
            const spirv_cross::SPIRType& type = compiler.get_type(element);
            ASSERT_EQ(type.member_types.size(), want.size());
            for (uint32_t i = 0; i < want.size(); ++i) {
                EXPECT_EQ(compiler.get_member_name(element, i), want[i].name);
                EXPECT_EQ(compiler.type_struct_member_offset(type, i), want[i].offset) << want[i].name;
            }
            return;
        }
        ADD_FAILURE() << "no such buffer";
    };
#define MEMBER(type, member) Member{#member, offsetof(type, member)}
    expectLayout("gnoMaterials",
                 {MEMBER(GnoMaterial, kind), MEMBER(GnoMaterial, width), MEMBER(GnoMaterial, height), MEMBER(GnoMaterial, firstTexel),
                  MEMBER(GnoMaterial, red), MEMBER(GnoMaterial, green), MEMBER(GnoMaterial, blue), MEMBER(GnoMaterial, alpha),
                  MEMBER(GnoMaterial, cutoff), MEMBER(GnoMaterial, transmission), MEMBER(GnoMaterial, unused0), MEMBER(GnoMaterial, unused1)},
                 sizeof(GnoMaterial));
    expectLayout("gnoSurfaces",
                 {MEMBER(GnoSurface, a), MEMBER(GnoSurface, b), MEMBER(GnoSurface, c), MEMBER(GnoSurface, material), MEMBER(GnoSurface, unused)},
                 sizeof(GnoSurface));
}

/// A frame of opaque casters asks for none of it.
TEST(MaterialBuffers, AreNotForOpaqueFrames) {
    host::Frame frame;
    frame.triangles = {{{-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0, 0.5f, 0}}};
    frame.material = frame.object = {0};
    frame.closed = {0};
    const std::vector<host::OracleSample> samples{{{0, 0, -0.5f}, host::kNoCaster}};
    const host::FrameInputs opaque(test::passes(), frame, samples);
    EXPECT_FALSE(opaque.hasMaterials());
    Random r(3);
    frame.look = makeLook(r);
    frame.surfaceOf = {0};
    frame.surfaces = {makeSurface(r, 24)};
    const host::FrameInputs leafy(test::passes(), frame, samples);
    ASSERT_TRUE(leafy.hasMaterials());
    EXPECT_EQ(&leafy.materials(), &leafy.materials());
    EXPECT_EQ(leafy.materials().of().downloadAs<uint32_t>().at(0), 0u);
    EXPECT_EQ(leafy.materials().texels().bytes(), 4u * (1 + 256 + 15));
}

}  // namespace
}  // namespace gno
