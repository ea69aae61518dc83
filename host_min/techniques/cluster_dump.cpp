// SPDX-License-Identifier: MIT
// What a cluster hierarchy tells of its arrays.
#include <algorithm>

#include "host_min/techniques/cluster_hierarchy.hpp"

namespace gno::host {

std::vector<glm::uvec3> ClusterHierarchy::sums() const {
    const auto words = arrays_["gnoTransmittances"].downloadAs<glm::uvec4>();
    std::vector<glm::uvec3> result(size_t(inputs_->width()) * inputs_->height());
    for (size_t i = 0; i < result.size(); ++i)
        for (int channel = 0; channel < 3; ++channel)
            result[i][channel] = (words[i].w >> channel & 1u) != 0 ? GNO_TRANSMITTANCE_OPAQUE : words[i][channel];
    return result;
}

NamedNumbers ClusterHierarchy::bytes() const {
    NamedNumbers result{{"masks", arrays_.bytes({"gnoClusterMasks"})},
                        {"shade", arrays_.bytes({"gnoClusterShade"})},
                        {"volumes", arrays_.bytes({"gnoClusterVolumes", "gnoClusterInfo"})}};
    if (options_.form != ClusterForm::implicitBounds) result.push_back({"bounds", arrays_.bytes({"gnoClusterLow", "gnoClusterHigh"})});
    if (options_.form == ClusterForm::compact) result.push_back({"pointers", arrays_.bytes({"gnoClusterPointers"})});
    if (options_.split > 0) result.push_back({"jobs", arrays_.bytes({"gnoClusterJobs"})});
    if (options_.layers) result.push_back({"materials", inputs_->materials().bytes() + arrays_.bytes({"gnoTransmittances"})});
    return result;
}

std::vector<DumpedBuffer> ClusterHierarchy::dump() const {
    const auto words = [&](std::string_view name, uint64_t count) {  // the buffer itself may be longer
        std::vector<std::byte> bytes = arrays_[name].download();
        bytes.resize(4 * count);
        return bytes;
    };
    const uint64_t masks = clusterWordCount(layout_);
    const bool flat = options_.form == ClusterForm::flat, compact = options_.form == ClusterForm::compact;
    const uint32_t boxWords = flat ? 1 : 3;
    std::vector<DumpedBuffer> result{
        {"frame", "GnoClusterFrame, GnoClusterLayout", words("gnoClusterFrame", sizeof(ClusterUniform) / 4), sizeof(ClusterUniform) / 4},
        {"header", "GnoClusterHeader", words("gnoClusterHeader", sizeof(GnoClusterHeader) / 4), sizeof(GnoClusterHeader) / 4},
        {"slices", "float start[slices + 1]", words("gnoClusterSliceTable", uint64_t(clusterSlices(layout_)) + 1)},
        {"masks", "uint word[words]: as the traversal left them, without the nodes that were accepted", words("gnoClusterMasks", masks)},
        {"volumes", "vec4 plane[7 * casters]", words("gnoClusterVolumes", 28 * uint64_t(inputs_->triangleCount())), 28}};
    if (options_.form != ClusterForm::implicitBounds) {
        const uint64_t boxes = compact ? std::min(options_.boxCapacity, header().boxCount) : clusterNodeCount(layout_);
        for (const auto& [name, array] : {std::pair("low", "gnoClusterLow"), std::pair("high", "gnoClusterHigh")})
            result.push_back({name, flat ? "float depth[nodes]" : "float xyz[3 * boxes]", words(array, boxWords * boxes), boxWords});
    }
    if (compact) result.push_back({"pointers", "uvec2 firstBoxAndMask[words]", words("gnoClusterPointers", 2 * masks), 2});
    run(clusterHierarchyPasses(inputs_->width(), inputs_->height(), options_));  // gives the accepted nodes back
    result.push_back({"masks_built", "uint word[words]: as built, a bit for each occupied child", words("gnoClusterMasks", masks)});
    run(passes_.list());
    return result;
}

}  // namespace gno::host
