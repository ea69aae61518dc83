// SPDX-License-Identifier: MIT
// VTK XML files that open in ParaView. Arrays have names, and units where they have one (vtkDataArray::UNITS_LABEL, which the file keeps). Files are
// complete or not there.
#pragma once
#include <filesystem>
#include <span>
#include <string>

#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace gno::viz {

/// An array of `components` numbers per entry, copied. `unit` may be empty.
vtkSmartPointer<vtkDataArray> array(const std::string& name, const std::string& unit, std::span<const float> values, int components = 1);
vtkSmartPointer<vtkDataArray> array(const std::string& name, const std::string& unit, std::span<const uint32_t> values, int components = 1);

/// One number or text about the whole, as field data.
void addFact(vtkDataSet& data, const std::string& name, double value);
void addFact(vtkDataSet& data, const std::string& name, const std::string& text);

/// .vtp, and .vti. Both throw InputError or WorkError like AtomicFile.
void writeFile(const std::filesystem::path& path, vtkPolyData& data);
void writeFile(const std::filesystem::path& path, vtkImageData& data);

}  // namespace gno::viz
