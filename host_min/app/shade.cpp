// SPDX-License-Identifier: MIT
#include "host_min/app/shade.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

#include "host_min/app/effects.hpp"
#include "host_min/app/outputs.hpp"
#include "host_min/app/refusals.hpp"
#include "host_min/app/result.hpp"
#include "host_min/error.hpp"
#include "host_min/interrupt.hpp"
#include "host_min/output/atomic_file.hpp"
#include "host_min/output/table.hpp"
#include "host_min/scene/one_line.hpp"
#include "host_min/vulkan/faults.hpp"

namespace gno::host {
namespace {

/// Before the work and not after it: what is to be written can be written.
void checkOutputs(const ShadeOptions& options) {
    if (options.pictures || options.dump) {
        makeFolder(options.out);
        const AtomicFile probe(options.out / "probe");  // gone again at the end of this scope
    }
    if (options.json.empty()) return;
    std::error_code ignored;
    const auto kind = std::filesystem::status(options.json, ignored).type();
    using enum std::filesystem::file_type;
    if (kind == fifo || kind == character || kind == socket) return;  // whoever reads it would see its end
    const AtomicFile probe(options.json);
}

bool looksUpMaterials(const Technique& technique, const ShadeOptions& options) {
    return answersForMaterials(technique.info()) && Settings(technique.info().settings, options.settings).word("materials") != "off";
}

/// Pixels without a view sample have no query.
void checkTrace(const ShadeOptions& options, const FrameInputs& inputs) {
    if (!options.trace) return;
    const glm::uvec2 at = *options.trace;
    if (inputs.pixels()[size_t(at.y) * inputs.width() + at.x].own > GNO_NO_CASTER)
        throw InputError(fmt::format(
            "--trace {},{}: that pixel shows the background or a surface that faces away from the light, so it has no query", at.x, at.y));
}

std::string lightName(const Frame& frame, int light) {
    const std::string& name = frame.lights[size_t(light)].name;
    return name.empty() ? fmt::format("light {}", light) : fmt::format("light {} ({})", light, name);
}

/// What the grid does to the picture: far lights (once), a warning, or an InputError.
void tellGrid(const Frame& frame, const ShadeOptions& options, bool anyway, bool isFirst) {
    for (size_t i = 0; i < frame.lights.size() && isFirst; ++i) {
        const Light& light = frame.lights[i];
        if (light.isFar)
            fmt::print("{} is far away: taken as directional, which moves no boundary by more than {:.2g} pixel\n", lightName(frame, int(i)),
                       light.parallaxPixels);
    }
    const GridHarm& harm = frame.harm;
    if (harm.changed) fmt::print("the grid is another one than in the frame before\n");
    if (harm.movedPixels < kHarmTold) return;
    const std::string cause = harm.forLight < 0 ? "triangles" : lightName(frame, harm.forLight);
    const std::string what = fmt::format(
        "putting positions on the grid moves what the camera sees by up to {:.3g} pixel{}: the grid reaches {:.3g} "
        "units from there, for {}",
        harm.movedPixels, harm.movedPixels < 1.5 ? "" : "s", harm.reach, cause);
    if (harm.movedPixels >= kHarmRefused && !anyway)
        throw InputError(fmt::format("{}: {}; move that nearer, or add --set grid=anyway", oneLine(options.scene.string()), what));
    fmt::print(stderr, "warning: {}\n", what);
}

/// Of the frame, and of what this run makes of it.
std::vector<std::string> noticesOf(const Frame& frame, const std::vector<Technique*>& chosen, const ShadeOptions& options) {
    std::vector<std::string> notices = frame.facts.notices;
    const double aspect = double(options.width) / options.height, named = frame.camera.fileAspect;
    if (named > 0 && std::abs(named / aspect - 1) > 0.01)
        notices.push_back(
            fmt::format("width of the camera's view: not the file's ({:.3g} times its height) but the picture's ({:.3g} times); its height is kept",
                        named, aspect));
    if (frame.surfaces.empty()) return notices;
    std::vector<std::string> names;
    for (const Technique* technique : chosen)
        if (!looksUpMaterials(*technique, options)) names.push_back(technique->info().name);
    if (!names.empty())
        notices.push_back(fmt::format("alpha-tested and coloured casters: {} of {} taken for opaque by {} (marked in the table)",
                                      frame.surfaces.size(), counted(frame.triangles.size(), "triangle"), fmt::join(names, ", ")));
    return notices;
}

}  // namespace

bool shade(const ShadeOptions& options) {
    std::string leftOut;
    std::vector<Technique*> chosen = chooseTechniques(options, leftOut);
    const Settings forFrame(frameSettings(), options.settings);
    const Cull cull = cullByName(forFrame.word("cull"));
    const std::unique_ptr<Oracle> oracle = options.check ? makeOracle() : nullptr;
    if (options.check && !oracle) throw InputError("--check: this build has no oracle; configure with GNOMON_VALIDATION=ON");

    Progress progress;
    progress.show("loading");
    const SceneFile file = SceneFile::load(options.scene, options.animation);
    const uint32_t lightCount = file.lightCount();
    if (options.camera >= file.cameraCount())
        throw InputError(fmt::format("--camera {}: the scene has {} (0..{})", options.camera, file.cameraCount(), file.cameraCount() - 1));
    if (options.light && *options.light >= lightCount)
        throw InputError(fmt::format("--light {}: the scene has {} (0..{})", *options.light, lightCount, lightCount - 1));
    const Device device(DeviceOptions::fromEnvironment());
    checkSize(device.facts(), options.width, options.height);
    for (const Technique* technique : chosen) {
        const std::string missing = missingFor(technique->info(), device.facts());
        if (missing.empty()) continue;
        if (!options.allTechniques) throw InputError(fmt::format("technique {}: the device lacks {}", technique->info().name, missing));
        leftOut += fmt::format("{}left out {}: the device lacks {}", leftOut.empty() ? "" : "\n", technique->info().name, missing);
    }
    std::erase_if(chosen, [&](const Technique* technique) { return !missingFor(technique->info(), device.facts()).empty(); });
    if (options.trace && std::none_of(chosen.begin(), chosen.end(), [](const Technique* technique) { return technique->info().traces; }))
        throw InputError("--trace: none of the techniques can log a query: use psv, d-psv, d-stackless or d-hybrid");
    checkOutputs(options);
    PassCache passes(device);
    std::vector<Record> records;
    std::map<uint32_t, StructureCache> structuresOf;  // per light; they outlive frames
    std::set<std::string, std::less<>> told;
    if (!leftOut.empty()) fmt::print("{}\n", leftOut);
    if (device.facts().timestampValidBits == 0) fmt::print("the device has no time stamps: times are missing\n");
    const bool automatic = options.techniques.empty() && !options.allTechniques;
    using Asked = Refusals::Asked;
    Refusals refusals(automatic               ? Asked::automatically
                      : options.allTechniques ? Asked::all
                                              : Asked::byName,
                      device.facts(), options.settings, progress);

    std::optional<Grid> grid;  // of the frame before
    const auto shadeFrame = [&](uint32_t number) {
        throwIfInterrupted();
        progress.show("scene");
        const Frame frame = file.evaluate(number, View{options.camera, options.width, options.height, options.light, grid});
        grid = frame.grid;
        tellGrid(frame, options, forFrame.word("grid") == "anyway", number == options.firstFrame);
        const FrameLoad load{frame.triangles.size(), options.width, options.height, !frame.surfaces.empty()};
        const auto choose = [&] {
            const Choice choice =
                chooseAutomatically(frame, options.precision, {device.facts(), options.width, options.height, options.settings, refusals.refused()});
            if (choice.technique == nullptr) throw InputError(choice.why);
            progress.clear();
            if (chosen.empty() || chosen.back() != choice.technique) fmt::print("auto: {}\n", choice.why);
            return choice.technique;
        };
        if (automatic) chosen = {choose()};
        std::erase_if(chosen, [&](const Technique* technique) { return !refusals.holds(*technique, load); });
        if (chosen.empty()) return;
        if (!options.quiet) printNotices(noticesOf(frame, chosen, options), told);
        FrameInputs inputs(passes, frame, options.width, options.height);
        for (uint32_t light = options.light.value_or(0); light <= options.light.value_or(lightCount - 1); ++light) {
            progress.show("view samples");
            inputs.setLight(frame.lights.at(light).homogeneous, cull);
            if (number == options.firstFrame && light == options.light.value_or(0) && !inputs.leftWhole().empty())
                fmt::print("{}\n", inputs.leftWhole());
            checkTrace(options, inputs);
            const double floorMs = measureFloor(inputs, std::max(options.repeat, 3u), true);
            std::optional<OracleAnswer> answer;
            const bool withSums =
                inputs.hasMaterials() && std::any_of(chosen.begin(), chosen.end(), [](Technique* t) { return answersForMaterials(t->info()); });
            if (oracle) {
                answer = askOracle(*oracle, inputs, withSums, [&](double fraction) {
                    throwIfInterrupted();
                    progress.show("oracle", fraction);
                });
            }
            StructureCache& structures = structuresOf[light];
            structures.nextFrame();
            FrameOutputs outputs(options, inputs, file, number, light);
            const size_t firstRecord = records.size();
            const auto answerBy = [&](const Technique* technique) {
                const TechniqueResult result = technique->run(inputs, structures, Settings(technique->info().settings, options.settings),
                                                              {options.precision, options.repeat, true, options.dump, true, options.trace});
                Record record = makeRecord(inputs, result);
                record.scene = options.scene.string();
                record.technique = technique->info().name;
                record.precision = name(options.precision);
                record.settings = Settings(technique->info().settings, options.settings).json();
                record.settings.update(forFrame.json());
                record.frame = number;
                if (!file.clips().empty()) record.animation = file.clip() ? nlohmann::ordered_json(*file.clip()) : nlohmann::ordered_json("all");
                record.light = light;
                record.floorMs = floorMs;
                for (const Effect& effect : effectsOf(file, frame, int(light))) record.effects.push_back(effect.name);
                if (answer) record.check = compare(result, inputs, *answer);
                outputs.add(record, result, answer ? &*answer : nullptr);
                records.push_back(std::move(record));
            };
            for (size_t i = 0; i < chosen.size() && !refusals.gone(); ++i) {
                throwIfInterrupted();
                progress.show(chosen[i]->info().name);
                if (!refusals.run(*chosen[i], [&] { answerBy(chosen[i]); }) && automatic && refusals.onlyLimits()) chosen.push_back(choose());
            }
            std::erase_if(chosen, [&](const Technique* technique) { return refusals.refused().contains(technique); });
            throwIfInterrupted();
            if (records.size() > firstRecord) {
                progress.clear();
                fmt::print("{}", formatTable(std::span(records).subspan(firstRecord), wantsColor(1)));
                std::fflush(stdout);
                progress.show("writing");
                outputs.write();
            }
            if (chosen.empty() || refusals.gone()) return;
        }
    };
    // What is done stays, whatever stops the rest: but an interrupt, which leaves nothing of what it cut off.
    const auto writeDone = [&] {
        if (!options.json.empty() && !records.empty()) writeRecords(options.json, records);
    };
    try {
        for (uint32_t number = options.firstFrame; number <= options.lastFrame && !refusals.gone(); ++number) {
            if (number > options.firstFrame && chosen.empty()) break;
            withVulkanFaults([&] { shadeFrame(number); });
        }
    } catch (const Interrupted&) {
        throw;
    } catch (...) {
        try {
            writeDone();
        } catch (const std::exception&) {  // the first fault is the one to be told
        }
        throw;
    }
    writeDone();
    progress.clear();
    refusals.finish();
    if (records.empty()) throw InputError("no technique holds this scene on this device (see above)");
    return device.validationMessages() == 0;
}

}  // namespace gno::host
