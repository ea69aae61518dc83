// SPDX-License-Identifier: MIT
// gnomon core/bindings.glsl : our buffer of casters; leave it out and define GNO_LOAD_CASTER yourself where your storage differs.
//
//   GnoCaster gnoLoadCaster(uint index)      what GNO_LOAD_CASTER(index) is then
//
// Space      casters on the scene grid
// Stages     any with storage buffers (readonly)
// Requires   #version 450, no extension
//
// Macro                     required  default  meaning
// GNO_CORE_SET              no        0        descriptor set
// GNO_CORE_BINDING_CASTERS  no        0        casters, std430 float[9 n]: three vertices on the scene grid each, tightly packed (36 bytes)
#ifdef GNO_CORE_BINDINGS_GLSL
#error "core/bindings.glsl: a second inclusion changes nothing: GNO_CORE_SET and the other numbers are read once"
#endif
#ifndef GNO_CORE_BINDINGS_GLSL
#define GNO_CORE_BINDINGS_GLSL
#include "shared_types.h"
#ifndef GNO_CORE_SET
#define GNO_CORE_SET 0
#endif
#ifndef GNO_CORE_BINDING_CASTERS
#define GNO_CORE_BINDING_CASTERS 0
#endif

layout(set = GNO_CORE_SET, binding = GNO_CORE_BINDING_CASTERS, std430) readonly buffer GnoCasterBuffer { float v[]; } gnoCasters;

GnoCaster gnoLoadCaster(uint index_) {
    uint at_ = 9u * index_;
    return GnoCaster(vec3(gnoCasters.v[at_], gnoCasters.v[at_ + 1u], gnoCasters.v[at_ + 2u]),
                     vec3(gnoCasters.v[at_ + 3u], gnoCasters.v[at_ + 4u], gnoCasters.v[at_ + 5u]),
                     vec3(gnoCasters.v[at_ + 6u], gnoCasters.v[at_ + 7u], gnoCasters.v[at_ + 8u]));
}
#define GNO_LOAD_CASTER(index_) gnoLoadCaster(index_)
#endif
