#ifndef ENVIRONMENT_LOBE_SAMPLE
#define ENVIRONMENT_LOBE_SAMPLE
#include "shared/constants.h"

// One direction drawn for a GGX lobe, in axes whose +Z is the normal.
struct LobeSample
{
    vec3 l;        // unit, where light is looked for; below the horizon it adds nothing
    vec3 h;        // unit, the microfacet's normal
    float density; // of l, 1/sr
    float weight;  // D(h) NoL over the density, without V and F
};

// GGX as Heitz 2014, eq. 85, has it: of h stretched by 1/alpha, which loses no digits where h is near the normal.
float ggxOf(vec3 h, float alpha)
{
    vec3 stretched = vec3(h.xy / alpha, h.z);
    float length2 = dot(stretched, stretched);
    return 1.0 / (PI * alpha * alpha * length2 * length2);
}

// v stretched by alpha: its length is what Smith's masking needs, its direction is v's in the space where the surface is a
// hemisphere.
vec3 stretchedView(vec3 v, float alpha)
{
    return vec3(alpha * v.xy, v.z);
}

// The reflection of v in a normal that was drawn with `densityOverD` D(h), both per steradian of l.
LobeSample lobeSample(vec3 v, vec3 h, float alpha, float densityOverD)
{
    vec3 l = 2.0 * dot(v, h) * h - v;
    return LobeSample(l, h, densityOverD * ggxOf(h, alpha), max(l.z, 0.0) / densityOverD);
}

#endif
