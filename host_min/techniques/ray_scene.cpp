// SPDX-License-Identifier: MIT
#include "host_min/techniques/ray_scene.hpp"

namespace gno::host {

void RayScene::prepare(const FrameInputs& inputs) {
    inputs_ = &inputs;
    arrays_.fit(inputs.device(), rayQueryArrays(inputs.triangleCount()));
    top_.reset();  // both hold addresses: of the frame's casters, and of the lower one
    bottom_.reset();
    bottom_.emplace(AccelerationStructure::ofTriangles(inputs.device(), inputs.casters(), indices(), inputs.triangleCount()));
    top_.emplace(AccelerationStructure::ofInstance(inputs.device(), *bottom_));
    passes_ = PassRunner(inputs.passes(), rayQueryBuildPasses(inputs.triangleCount()), inputs.withCasters(bindings()),
                         {.command = [this](Recording& recording, const Pass& pass) { recordCommand(recording, pass); }});
}

void RayScene::record(Recording& recording, uint32_t) const { passes_.record(recording, inputs_->push()); }

std::vector<Binding> RayScene::bindings() const {
    std::vector<Binding> all = arrays_.bindings();
    all.push_back({"gnoRayStructure", &*top_});
    return all;
}

void RayScene::recordCommand(Recording& recording, const Pass& pass) const { (pass.shader == kRayTopLevel ? top_ : bottom_)->build(recording); }

NamedNumbers RayScene::bytes() const {
    return {{"indices", indices().bytes()},
            {"bottom_level", bottom_->bytes()},
            {"top_level", top_->bytes()},
            {"build_scratch", bottom_->scratchBytes() + top_->scratchBytes()}};
}

}  // namespace gno::host
