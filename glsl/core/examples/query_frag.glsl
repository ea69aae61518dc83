// SPDX-License-Identifier: MIT
// main() of every query in a fragment shader behind fullscreen.vert; the visibility goes to an R32_UINT attachment.
layout(set = 2, binding = 2, rgba32ui) uniform readonly uimage2D gnoSamples;
layout(location = 0) out uint gnoVisibilityOut;

void main() {
    GnoViewSample s = gnoUnpackViewSample(imageLoad(gnoSamples, ivec2(gl_FragCoord.xy)));
    uint visibility = s.own == GNO_BACKGROUND ? GNO_VISIBILITY_BACKGROUND : GNO_VISIBILITY_FACING_AWAY;
    if (s.own <= GNO_NO_CASTER) visibility = GNO_EXAMPLE_QUERY(s);
    gnoVisibilityOut = visibility;
}
