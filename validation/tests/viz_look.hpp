// SPDX-License-Identifier: MIT
// Dumps of one scene and gnomon-viz run on them, files read back, damage done to dumps: what the tests of gnomon-viz share.
#pragma once
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <cstring>

#include "validation/tests/cli_child.hpp"

namespace gno::test {

namespace fs = std::filesystem;
using host::test::Json;
inline constexpr uint32_t kWidth = 96, kHeight = 64;

inline void replaceFile(const fs::path& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

inline std::vector<uint32_t> wordsOf(const fs::path& path) {
    const std::string bytes = readFile(path);
    std::vector<uint32_t> words(bytes.size() / 4);
    std::memcpy(words.data(), bytes.data(), 4 * words.size());
    return words;
}

/// Dumps of one scene, and gnomon-viz run on them. One thread: the counted run and the dumped one are then the same.
class Look {
public:
    explicit Look(std::string scene, uint32_t light = 0) : scene_(std::move(scene)), light_(std::to_string(light)) {}

    void shade(std::vector<std::string> more, const std::string& size = std::to_string(kWidth) + "x" + std::to_string(kHeight)) const {
        more.insert(more.begin(), {scene_, "--light", light_, "--size", size, "--dump", "--no-pictures"});
        ChildOptions options;
        options.environment = {{"LP_NUM_THREADS", "1"}};
        expectDone(stage_.shade(more, options));
    }
    [[nodiscard]] fs::path file(const std::string& technique, const std::string& what, const std::string& precision = "certified") const {
        return stage_.out() / (fs::path(scene_).stem().string() + "-l" + light_ + "-f000-" + technique + "." + precision + "-" + what);
    }
    [[nodiscard]] std::string dump(const std::string& technique, const std::string& precision = "certified") const {
        return file(technique, "dump.json", precision).string();
    }
    [[nodiscard]] Json record(const std::string& technique, const std::string& precision = "certified") const {
        return Json::parse(readFile(dump(technique, precision)))["record"];
    }
    /// Into the folder of the dumps.
    [[nodiscard]] Outcome viz(std::vector<std::string> arguments, std::map<std::string, std::string> environment = {}) const {
        arguments.insert(arguments.end(), {"--out", stage_.out().string()});
        ChildOptions options;
        options.program = GNOMON_VIZ_PROGRAM;
        options.environment = std::move(environment);
        return stage_.run(arguments, options);
    }
    void refuses(std::vector<std::string> arguments, const std::string& part, std::map<std::string, std::string> environment = {}) const {
        const auto before = stage_.left();
        const Outcome outcome = viz(std::move(arguments), std::move(environment));
        EXPECT_EQ(outcome.code, 2) << outcome.err;
        EXPECT_EQ(linesOf(outcome.err).size(), 1u) << outcome.err;
        EXPECT_TRUE(outcome.err.starts_with("gnomon-viz: ")) << outcome.err;
        EXPECT_NE(outcome.err.find(part), std::string::npos) << "not said: " << part << "\nsaid: " << outcome.err;
        EXPECT_EQ(stage_.left(), before);
    }
    /// As it is refused with a file of the dump changed; undone afterwards.
    template <class Change>
    void refusesDamaged(const fs::path& path, Change change, const std::vector<std::string>& command, const std::string& part) const {
        const std::string whole = readFile(path);
        replaceFile(path, change(whole));
        refuses(command, part);
        replaceFile(path, whole);
    }

private:
    Stage stage_;
    std::string scene_, light_;
};

inline vtkSmartPointer<vtkPolyData> meshIn(const fs::path& path) {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    EXPECT_EQ(reader->GetErrorCode(), 0u) << path;
    return reader->GetOutput();
}

/// Sum over an array's values; -1 when there is none of that name, or its unit is another.
inline double sumOf(vtkDataSetAttributes& data, const char* name, const char* unit = "") {
    vtkDataArray* values = data.GetArray(name);
    if (values == nullptr) return -1;
    const char* label = values->GetInformation()->Get(vtkDataArray::UNITS_LABEL());
    if (std::string(label == nullptr ? "" : label) != unit) return -1;
    double sum = 0;
    for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i) sum += values->GetComponent(i, 0);
    return sum;
}

inline double factIn(vtkDataSet& data, const char* name) {
    vtkDataArray* fact = data.GetFieldData()->GetArray(name);
    return fact == nullptr ? -1 : fact->GetComponent(0, 0);
}

/// Some hundred different colours, and no side of the picture all of one.
inline void expectPicture(const fs::path& path) {
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    vtkImageData& image = *reader->GetOutput();
    const int* size = image.GetDimensions();
    ASSERT_GT(size[0], 100) << path;
    std::set<uint32_t> colours;
    for (int y = 0; y < size[1]; ++y)
        for (int x = 0; x < size[0]; ++x) {
            const auto* pixel = static_cast<const uint8_t*>(image.GetScalarPointer(x, y, 0));
            colours.insert(uint32_t(pixel[0]) << 16 | uint32_t(pixel[1]) << 8 | pixel[2]);
        }
    EXPECT_GT(colours.size(), 100u) << path;
}

inline uint64_t counter(const Json& record, const char* name) { return record["counters"][name]; }

/// Changes of a file's bytes, for refusesDamaged.
inline auto setWord(size_t index, uint32_t value) {
    return [=](std::string bytes) {
        std::memcpy(bytes.data() + 4 * index, &value, 4);
        return bytes;
    };
}

inline std::string withoutLastWord(const std::string& bytes) { return bytes.substr(0, bytes.size() - 4); }
inline std::string firstHalf(const std::string& text) { return text.substr(0, text.size() / 2); }

/// A number of the record, one higher.
inline auto raise(const char* what, const char* name) {
    return [=](const std::string& text) {
        Json index = Json::parse(text);
        index["record"][what][name] = index["record"][what][name].get<uint64_t>() + 1;
        return index.dump();
    };
}

}  // namespace gno::test
