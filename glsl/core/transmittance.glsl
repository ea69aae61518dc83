// SPDX-License-Identifier: MIT
// gnomon core/transmittance.glsl : how much light a caster takes from a point in its shadow volume, per channel, in integers.
// The papers claim textured and semi-transparent casters for per-triangle shadow volumes (2011, 2014: "trivially") and define none; this is ours.
//
//   uvec3 gnoTransmittance(uint caster, GnoCaster t, vec4 light, vec3 p)   contribution of caster t, numbered `caster`, to a p in its shadow volume
//   bool  gnoIsOpaqueCaster(uint caster)                                   it lets nothing through anywhere: one load, no texture
//   ivec2 gnoHitTexel(uvec3 weights, GnoSurface s)                         texel coordinate of the hit point
//   uvec4 gnoSampleTexture(GnoMaterial m, ivec2 at)                        filtered texel, 0 to 255 a channel; 255 each without a texture
//   uint  gnoCoverage(GnoMaterial m, uvec4 texel)                          0 to 255; 0: a hole, which a camera does not see either
//   uvec3 gnoTransmitted(GnoMaterial m, uvec4 texel)                       what passes, 0 to 255 a channel
//   uint  gnoContribution(uint transmitted)                                round(-log2(transmitted / 255) * 2^16), 0 to 523918; 0:
//   GNO_TRANSMITTANCE_OPAQUE
//
// Definition. A sample's contributions, of all casters but its own in whose shadow volume it lies, are added per channel; sums stop at
// GNO_TRANSMITTANCE_OPAQUE = 16 * 2^16. The light that arrives is 2^(-sum / 2^16) of the light's; at the stop it is none. The sample is in shadow
// when all three sums are at the stop. Integers only, and addition with a stop knows no order: every device and every order of casters gives the
// same sums.
//
//   hit point  core/hit_weights.glsl: integer weights of the caster's vertices
//   texel      coordinate = floor of the vertices' coordinates' weighted mean (core/material.h: 1/256 texel). Texture level 0, no mip levels.
//              Nearest: the texel that holds it. Linear: of coordinate - 128 the low 8 bits are the fraction; the four texels' weights add up
//              to 2^16, (sum + 2^15) >> 16. Wrapped after that: repeat, mirrored repeat, clamp. Colour is filtered linear, not times alpha
//   coverage   mask: 255 where texel alpha * factor reaches the cutoff, else 0; blend: round(texel alpha * factor / 65535); solid: 255
//   passes     255 - coverage + round(coverage * colour * transmission / 255^2), colour = round(texel colour * factor / 65535)
//              So without transmission blend lets 1 - alpha of white light through; KHR_materials_transmission is what colours it
//   adds       gnoContribution of what passes. An opaque caster adds GNO_TRANSMITTANCE_OPAQUE to each channel
// Vertex colours (COLOR_0), their alpha included, are not part of it. Volumes are closed: a sample exactly in the plane through the light and an
// edge that two triangles share lies in both volumes, and both contribute.
//
// Space      caster, light and p as in core/orient3d.glsl; p in the caster's shadow volume (gnoInShadowOf). Elsewhere some contribution, no error
// Stages     any; may diverge; pure
// Requires   #version 450, no extension, no optional device feature
// Reads      casters' materials only through the macros; writes nothing; declares no binding
// Cost       opaque: one load. Others: two loads; with a texture gnoHitWeights, two gnoWeightedMean and 1 or 4 texels; then up to 3 times 24
//            umulExtended
//
// Macro                         required  default  meaning
// GNO_LOAD_MATERIAL_OF(caster)  yes       -        uint: GNO_OPAQUE_CASTER, or the number of the caster's surface
// GNO_LOAD_SURFACE(index)       yes       -        GnoSurface; asked of casters that are not opaque only
// GNO_LOAD_MATERIAL(index)      yes       -        GnoMaterial
// GNO_LOAD_TEXEL(index)         yes       -        uint: four bytes, red lowest; linear colour. Asked of materials with a texture only
#ifndef GNO_CORE_TRANSMITTANCE_GLSL
#define GNO_CORE_TRANSMITTANCE_GLSL
#include "hit_weights.glsl"
#include "material.h"
#ifndef GNO_LOAD_MATERIAL_OF
#error "core/transmittance.glsl: define GNO_LOAD_MATERIAL_OF(caster) or include core/material_bindings.glsl before this file"
#endif
#ifndef GNO_LOAD_SURFACE
#error "core/transmittance.glsl: define GNO_LOAD_SURFACE(index) or include core/material_bindings.glsl before this file"
#endif
#ifndef GNO_LOAD_MATERIAL
#error "core/transmittance.glsl: define GNO_LOAD_MATERIAL(index) or include core/material_bindings.glsl before this file"
#endif
#ifndef GNO_LOAD_TEXEL
#error "core/transmittance.glsl: define GNO_LOAD_TEXEL(index) or include core/material_bindings.glsl before this file"
#endif

ivec2 gnoHitTexel(uvec3 weights_, GnoSurface s_) {  // relative to the least coordinate, so that the mean is one of unsigned numbers
    int u_ = min(s_.a.x, min(s_.b.x, s_.c.x));
    int v_ = min(s_.a.y, min(s_.b.y, s_.c.y));
    return ivec2(u_ + int(gnoWeightedMean(weights_, uvec3(uint(s_.a.x - u_), uint(s_.b.x - u_), uint(s_.c.x - u_)))),
                 v_ + int(gnoWeightedMean(weights_, uvec3(uint(s_.a.y - v_), uint(s_.b.y - v_), uint(s_.c.y - v_)))));
}

uint gnoWrap_(int at_, uint size_, uint wrap_) {
    if (wrap_ == GNO_WRAP_CLAMP) return uint(clamp(at_, 0, int(size_) - 1));
    uint period_ = wrap_ == GNO_WRAP_MIRRORED ? 2u * size_ : size_;
    uint index_ = at_ >= 0 ? uint(at_) % period_ : period_ - 1u - uint(-1 - at_) % period_;
    return index_ < size_ ? index_ : period_ - 1u - index_;
}

uvec4 gnoTexel_(GnoMaterial m_, int x_, int y_) {
    uint column_ = gnoWrap_(x_, m_.width, (m_.kind >> GNO_MATERIAL_WRAP_U) & 3u);
    uint row_ = gnoWrap_(y_, m_.height, (m_.kind >> GNO_MATERIAL_WRAP_V) & 3u);
    uint texel_ = GNO_LOAD_TEXEL(m_.firstTexel + row_ * m_.width + column_);
    return uvec4(texel_ & 255u, (texel_ >> 8u) & 255u, (texel_ >> 16u) & 255u, texel_ >> 24u);
}

uvec4 gnoSampleTexture(GnoMaterial m_, ivec2 at_) {
    if (m_.width == 0u) return uvec4(255u);
    if ((m_.kind & GNO_MATERIAL_LINEAR) == 0u) return gnoTexel_(m_, at_.x >> 8, at_.y >> 8);
    int u_ = at_.x - 128;
    int v_ = at_.y - 128;
    uint right_ = uint(u_ & 255);
    uint below_ = uint(v_ & 255);
    int x_ = u_ >> 8;
    int y_ = v_ >> 8;
    uvec4 top_ = gnoTexel_(m_, x_, y_) * (256u - right_) + gnoTexel_(m_, x_ + 1, y_) * right_;
    uvec4 bottom_ = gnoTexel_(m_, x_, y_ + 1) * (256u - right_) + gnoTexel_(m_, x_ + 1, y_ + 1) * right_;
    return (top_ * (256u - below_) + bottom_ * below_ + uvec4(32768u)) >> uvec4(16u);
}

uint gnoTimesFactor_(uint value_, uint factor_) { return (value_ * factor_ + 32767u) / 65535u; }  // at most 255 * 65535: nothing wraps

uint gnoPassing_(uint coverage_, uint colour_, uint transmission_) {
    return 255u - coverage_ + (coverage_ * colour_ * transmission_ + 32512u) / 65025u;  // at most 255^3
}

uint gnoCoverage(GnoMaterial m_, uvec4 texel_) {
    if ((m_.kind & 3u) == GNO_MATERIAL_MASK) return texel_.w * m_.alpha >= m_.cutoff ? 255u : 0u;
    if ((m_.kind & 3u) == GNO_MATERIAL_BLEND) return gnoTimesFactor_(texel_.w, m_.alpha);
    return 255u;
}

uvec3 gnoTransmitted(GnoMaterial m_, uvec4 texel_) {
    uint coverage_ = gnoCoverage(m_, texel_);
    return uvec3(gnoPassing_(coverage_, gnoTimesFactor_(texel_.x, m_.red), m_.transmission),
                 gnoPassing_(coverage_, gnoTimesFactor_(texel_.y, m_.green), m_.transmission),
                 gnoPassing_(coverage_, gnoTimesFactor_(texel_.z, m_.blue), m_.transmission));
}

// Binary digits of log2 by squaring: x in [1, 2) with 31 bits behind the point; each square's whole part is the next digit. Cutting off the square
// errs by less than 2^-31 of it, and what a step adds to the logarithm counts half as much as the step's digit: less than 2^-29 in all, below
// a quarter of the last of the 24 digits, and a test has all 255 results right.
uint gnoContribution(uint transmitted_) {
    if (transmitted_ == 0u) return GNO_TRANSMITTANCE_OPAQUE;
    uint log_ = uint(findMSB(transmitted_));
    uint x_ = transmitted_ << (31u - log_);
    for (int i_ = 0; i_ < 24; ++i_) {
        uint high_, low_;
        umulExtended(x_, x_, high_, low_);
        uint digit_ = high_ >> 31u;
        x_ = digit_ != 0u ? high_ : (high_ << 1u) | (low_ >> 31u);
        log_ = (log_ << 1u) | digit_;
    }
    return (134122994u - log_ + 128u) >> 8u;  // round(log2(255) * 2^24)
}

bool gnoIsOpaqueCaster(uint caster_) { return GNO_LOAD_MATERIAL_OF(caster_) == GNO_OPAQUE_CASTER; }

uvec3 gnoTransmittance(uint caster_, GnoCaster t_, vec4 light_, vec3 p_) {
    uint number_ = GNO_LOAD_MATERIAL_OF(caster_);
    if (number_ == GNO_OPAQUE_CASTER) return uvec3(GNO_TRANSMITTANCE_OPAQUE);
    GnoSurface surface_ = GNO_LOAD_SURFACE(number_);
    GnoMaterial material_ = GNO_LOAD_MATERIAL(surface_.material);
    ivec2 at_ = ivec2(0);
    if (material_.width != 0u) at_ = gnoHitTexel(gnoHitWeights(light_, t_, p_), surface_);
    uvec3 transmitted_ = gnoTransmitted(material_, gnoSampleTexture(material_, at_));
    return uvec3(gnoContribution(transmitted_.x), gnoContribution(transmitted_.y), gnoContribution(transmitted_.z));
}

#endif
