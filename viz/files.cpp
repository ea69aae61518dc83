// SPDX-License-Identifier: MIT
#include "viz/files.hpp"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkUnsignedIntArray.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>

#include "host_min/output/atomic_file.hpp"

namespace gno::viz {
namespace {

template <class Array, class T>
vtkSmartPointer<vtkDataArray> copy(const std::string& name, const std::string& unit, std::span<const T> values, int components) {
    const auto result = vtkSmartPointer<Array>::New();
    result->SetName(name.c_str());
    result->SetNumberOfComponents(components);
    result->SetNumberOfTuples(vtkIdType(values.size()) / components);
    std::copy(values.begin(), values.end(), result->GetPointer(0));
    if (!unit.empty()) result->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), unit.c_str());
    return result;
}

template <class Writer, class Data>
void write(const std::filesystem::path& path, Data& data) {
    vtkNew<Writer> writer;
    writer->SetInputData(&data);
    writer->SetCompressorTypeToZLib();
    writer->WriteToOutputStringOn();
    writer->Write();
    host::AtomicFile file(path);
    file.stream() << writer->GetOutputString();
    file.commit();
}

}  // namespace

vtkSmartPointer<vtkDataArray> array(const std::string& name, const std::string& unit, std::span<const float> values, int components) {
    return copy<vtkFloatArray>(name, unit, values, components);
}

vtkSmartPointer<vtkDataArray> array(const std::string& name, const std::string& unit, std::span<const uint32_t> values, int components) {
    return copy<vtkUnsignedIntArray>(name, unit, values, components);
}

void addFact(vtkDataSet& data, const std::string& name, double value) {
    vtkNew<vtkDoubleArray> fact;
    fact->SetName(name.c_str());
    fact->InsertNextValue(value);
    data.GetFieldData()->AddArray(fact);
}

void addFact(vtkDataSet& data, const std::string& name, const std::string& text) {
    vtkNew<vtkStringArray> fact;
    fact->SetName(name.c_str());
    fact->InsertNextValue(text);
    data.GetFieldData()->AddArray(fact);
}

void writeFile(const std::filesystem::path& path, vtkPolyData& data) { write<vtkXMLPolyDataWriter>(path, data); }
void writeFile(const std::filesystem::path& path, vtkImageData& data) { write<vtkXMLImageDataWriter>(path, data); }

}  // namespace gno::viz
