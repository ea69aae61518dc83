// SPDX-License-Identifier: MIT
// gnomon rivals/light_grid_place.glsl : the cell and the sub cell of a point.
//
//   GnoForestGrid gnoLightGridFine(GnoForestGrid grid)                       the grid whose cells are the sub cells
//   uvec2 gnoLightGridPlace(vec4 light, GnoForestGrid grid, vec3 q)          x: the cell, y: which of its 8 x 8 sub cells, row by row
//   uvec3 gnoLightGridAt(GnoForestGrid grid, uint cell)                      of a cell: column, row, face
//
// A sub cell belongs to the cell that the same point is filed in: steps and resolutions differ by a power of two, so the quotient that is rounded
// down to an index is eight times the cell's, exactly, and the cell's index is the sub cell's divided by eight, whatever the rounding was; clamping
// keeps that.
//
// Space      light coordinates, q = gnoFromLight(p)
// Stages     any; pure
// Requires   #version 450, no extension
#ifndef GNO_RIVALS_LIGHT_GRID_PLACE_GLSL
#define GNO_RIVALS_LIGHT_GRID_PLACE_GLSL
#include "../forest/cells.glsl"
#include "light_grid.h"
GNO_NAMESPACE_BEGIN

GNO_INLINE GnoForestGrid gnoLightGridFine(GnoForestGrid grid_) {
    GnoForestGrid fine_ = grid_;
    fine_.stepAcross = 0.125f * grid_.stepAcross;
    fine_.stepAlong = 0.125f * grid_.stepAlong;
    fine_.resolution = 8u * grid_.resolution;
    return fine_;
}

GNO_INLINE uvec3 gnoLightGridAt(GnoForestGrid grid_, uint cell_) {
    uint row_ = cell_ / grid_.resolution;
    return uvec3(cell_ % grid_.resolution, row_ % grid_.resolution, row_ / grid_.resolution);
}

GNO_INLINE uvec2 gnoLightGridPlace(vec4 light_, GnoForestGrid grid_, vec3 q_) {
    GnoForestGrid fine_ = gnoLightGridFine(grid_);
    uvec3 at_ = gnoLightGridAt(fine_, gnoCellOf(light_, fine_, q_));
    return uvec2((at_.z * grid_.resolution + at_.y / 8u) * grid_.resolution + at_.x / 8u, (at_.y % 8u) * 8u + at_.x % 8u);
}

GNO_NAMESPACE_END
#endif
