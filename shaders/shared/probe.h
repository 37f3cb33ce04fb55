// A shading point as the device is given it, for looking at one formula without drawing (torrance probe).
#ifndef TORRANCE_SHARED_PROBE_H
#define TORRANCE_SHARED_PROBE_H

#include "shared/language.h"

SHARED_BEGIN

SHARED_UINT(kProbeWidth, 1024); // pixels, and so rows of the table, in a line of the target

struct ProbeRow
{
    vec3 n;
    vec3 v;
    vec3 l;
    float NoV;
    float NoL;
    float VoL;
    float NoH;
    float VoH;
    float oneLessVoH;
    float sin2H;
    float ToH;
    float BoH;
    float perceptualRoughness;
    float alpha;
    float alphaT;
    float alphaB;
    vec3 f0;
    vec3 f90;
    float ior;
    vec3 eta;
    vec3 k;
    vec3 f82;
    vec3 baseColor;
    float metallic;
    float E;
    float bias;
    float ELight;
    float EAverage;
    vec3 single;
    vec3 spread;
    vec3 F;
    vec3 FNoV;
    vec3 FNoL;
    vec3 lobeAlbedo;
};

SHARED_END

#endif
