#ifndef ENVIRONMENT_SAMPLE_POINTS
#define ENVIRONMENT_SAMPLE_POINTS
// Points of the unit square that a pixel's samples are made from.

// Two fractions in [0, 1) from a pixel and the picture's number among those that make up one: PCG2D of Jarzynski & Olano, Hash
// Functions for GPU Rendering, 2020. The same on every device.
vec2 pixelRotation(uvec2 pixel, uint picture)
{
    uvec2 v = uvec2(pixel.x, pixel.y + 32768u * picture); // no picture is higher
    v = v * 1664525u + 1013904223u;
    v.x += v.y * 1664525u;
    v.y += v.x * 1664525u;
    v ^= v >> 16u;
    v.x += v.y * 1664525u;
    v.y += v.x * 1664525u;
    v ^= v >> 16u;
    return vec2(v >> 8u) * (1.0 / 16777216.0);
}

// Point i of the Hammersley set of `count`, its first coordinate in the middle of its stratum, moved by `rotation` modulo 1
// (Cranley & Patterson 1976). In [0, 1).
vec2 samplePoint(uint i, uint count, vec2 rotation)
{
    vec2 p = vec2((float(i) + 0.5) / float(count), float(bitfieldReverse(i) >> 8u) * (1.0 / 16777216.0));
    vec2 moved = p + rotation;
    return moved - step(vec2(1.0), moved);
}

#endif
