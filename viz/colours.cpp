// SPDX-License-Identifier: MIT
#include "viz/colours.hpp"

#include <algorithm>

#include "host_min/output/heatmap.hpp"

namespace gno::viz {

vtkSmartPointer<vtkLookupTable> numberColours(double least, double most, bool logarithmic) {
    constexpr int kSteps = 256;
    const auto table = vtkSmartPointer<vtkLookupTable>::New();
    table->SetNumberOfTableValues(kSteps);
    for (int i = 0; i < kSteps; ++i) {
        const glm::dvec3 colour = glm::dvec3(host::heatColor(double(i) / (kSteps - 1))) / 255.0;
        table->SetTableValue(i, colour.r, colour.g, colour.b, 1);
    }
    table->SetTableRange(least, most > least ? most : least + 1);
    if (logarithmic) table->SetScaleToLog10();
    return table;
}

vtkSmartPointer<vtkLookupTable> kindColours(const std::vector<Kind>& kinds) {
    const auto table = vtkSmartPointer<vtkLookupTable>::New();
    table->SetNumberOfTableValues(vtkIdType(kinds.size()));
    for (size_t i = 0; i < kinds.size(); ++i) {
        table->SetTableValue(vtkIdType(i), kinds[i].colour.r, kinds[i].colour.g, kinds[i].colour.b, 1);
        table->SetAnnotation(vtkVariant(int(i)), kinds[i].name);
    }
    table->SetTableRange(-0.5, double(kinds.size()) - 0.5);
    return table;
}

}  // namespace gno::viz
