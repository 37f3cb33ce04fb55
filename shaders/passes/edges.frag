// Marks the pixels whose samples lie on more than one surface: by depth, so that the pass that works on them is spared the others.
#include "passes/sample_depths.glsl"

void main()
{
    ivec2 p = ivec2(gl_FragCoord.xy);
    float here = texelFetch(depths, p, 0).r;
    vec4 z = sampleDepths(p);
    // Samples 0 and 3, and 1 and 2, lie opposite each other: on a plane through the centre their means are its depth.
    vec2 bend = abs(z.xy + z.wz - 2.0 * here);
    bool plane = here > 0.0 && max(bend.x, bend.y) <= 2.0 * kPixelFlatness * widthInDepth(here);
    bool empty = here == 0.0 && z == vec4(0.0);
    gl_FragDepth = plane || empty ? 1.0 : 0.0; // passes/fullscreen.vert lies at 0
}
