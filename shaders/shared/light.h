#ifndef TORRANCE_SHARED_LIGHT_H
#define TORRANCE_SHARED_LIGHT_H

#include "shared/language.h"

SHARED_BEGIN

// Lights of a scene, KHR_lights_punctual, and behind them points of an environment's lamps, which have a direction,
// their energy as intensity and their density as coneScale. KHR_lights_punctual. Directional lights use direction and
// intensity; point lights add position and range; spot lights add the cone.
SHARED_UINT(kMaxLights,
            1024); // with the frame before them they fit into 64 KiB, the uniform block that every device has

struct Light
{
    vec3 position;      // relative to the eye
    vec3 direction;     // towards the light: minus the way it travels
    vec3 intensity;     // colour times lux or candela
    float inverseRange; // 0 = unlimited
    float radius;       // metres; 0 = a point
    float coneScale;    // angular attenuation = clamp(cos * scale + offset, 0, 1)^2
    float coneOffset;
};

SHARED_END

#endif
