// A pixel's mean over four samples from one shading a pixel: Chajdas, McGuire & Luebke 2011, Subpixel Reconstruction Antialiasing for
// Deferred Shading, with planes of depth in the place of the paper's bilateral weights. Of the pixels that passes/edges.frag marked; the
// same in double: src/brdf/pixel_sampling.cpp.
#include "passes/sample_depths.glsl"

layout(set = 0, binding = kBindSource) uniform sampler2D source;

layout(location = 0) out vec4 outColor;

// Vulkan's standard places of four samples, pixels from the centre.
const vec2 kPlaces[4] = vec2[](vec2(-0.125, -0.375), vec2(0.375, -0.125), vec2(-0.375, 0.125), vec2(0.125, 0.375));
const float kNoSurface = 3e38; // the score of a pixel that a sample's surface was not shaded in

float depthAt(ivec2 p)
{
    return texelFetch(depths, clamp(p, ivec2(0), textureSize(depths, 0) - 1), 0).r;
}

// Per pixel, along a line of depths about the middle one: of the sides that hold a surface, that which bends less on its way to the
// second; one that has no second counts as if the surface should lie flat.
float slope(float before2, float before, float here, float after, float after2)
{
    float back = here - before, on = after - here;
    float bendBack = before2 == 0.0 ? back : back - (before - before2);
    float bendOn = after2 == 0.0 ? on : on - (after2 - after);
    if (before == 0.0)
        return after == 0.0 ? 0.0 : on;
    return after == 0.0 || abs(bendBack) < abs(bendOn) ? back : on;
}

float slopeAlong(ivec2 q, float d, ivec2 step)
{
    return slope(depthAt(q - 2 * step), depthAt(q - step), d, depthAt(q + step), depthAt(q + 2 * step));
}

void main()
{
    ivec2 p = ivec2(gl_FragCoord.xy);
    vec4 z = sampleDepths(p);
    vec4 own = texelFetch(source, p, 0);
    vec4 colors[4] = vec4[](own, own, own, own);
    vec4 scores = vec4(kNoSurface);
    vec4 widths = vec4(widthInDepth(z.x), widthInDepth(z.y), widthInDepth(z.z), widthInDepth(z.w));
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            ivec2 q = clamp(p + ivec2(x, y), ivec2(0), textureSize(depths, 0) - 1);
            float d = depthAt(q);
            vec2 slopes = vec2(slopeAlong(q, d, ivec2(1, 0)), slopeAlong(q, d, ivec2(0, 1)));
            vec4 color = texelFetch(source, q, 0);
            for (int s = 0; s < 4; ++s) {
                vec2 step = kPlaces[s] - vec2(q - p);
                float off = z[s] == 0.0 ? 0.0 : abs(d + dot(slopes, step) - z[s]) / widths[s];
                float score = off + kPixelFlatness * dot(step, step);
                if ((d == 0.0) == (z[s] == 0.0) && score < scores[s]) {
                    scores[s] = score;
                    colors[s] = color;
                }
            }
        }
    outColor = 0.25 * (colors[0] + colors[1] + colors[2] + colors[3]);
}
