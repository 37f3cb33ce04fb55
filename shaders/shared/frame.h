// What is the same for all surfaces of a picture. Positions are relative to the eye, axes are the world's: coordinates of
// a million metres lose nothing.
#ifndef TORRANCE_SHARED_FRAME_H
#define TORRANCE_SHARED_FRAME_H

#include "shared/language.h"

SHARED_BEGIN

struct Frame
{
    mat4 clipFromEye; // eye-relative position to clip, reversed depth, moved by the sample's place in the pixel

    // The direction to the viewer is normalize(towardsEye - eyeWeight * position): perspective (0, 1), orthographic (back, 0).
    vec3 towardsEye;
    float eyeWeight;

    // The ray of a pixel: q = corner + x * across + y * down (x, y in pixels from the top left).
    // Perspective: from 0 along q. Orthographic: from q along forward.
    vec3 corner;
    vec3 across;
    vec3 down;
    vec3 forward;
    float orthographic; // 0 or 1
    vec4 viewFromDepth; // (c.x z + c.y) / (c.z z + c.w) = distance along the axis of view of depth z

    mat3 environmentFromWorld; // rotation
    float environmentIntensity;
    float environmentLastLevel; // of the prefiltered chain
    vec2 lampDensities; // 1/sr: of the points on the environment's wide and on its small lamps
    vec3 irradianceHarmonics[9]; // irradiance / pi in shBasis's order, for environment_diffuse sh9
    float panoramaLevel;        // mip of what is seen behind the scene: of the panorama, the one of about one texel a pixel
    uint picture;               // number of this picture among those whose mean is the result

    uint viewTerm;  // shared/view.h: read by passes/surface_view.frag
    uint viewLight; // number of the light whose terms are viewed
};

SHARED_END

#endif
