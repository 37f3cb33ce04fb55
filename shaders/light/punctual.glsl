#include "shared/constants.h"
#include "shared/light.h"

// KHR_lights_punctual: 1/d^2, windowed to the range: max(min(1 - (d / range)^4, 1), 0) / d^2. inverseRange 0 = no window.
float distanceAttenuation(float distance2, float inverseRange)
{
    float x2 = distance2 * inverseRange * inverseRange;
    float window = clamp(1.0 - x2 * x2, 0.0, 1.0);
    return window / max(distance2, kMinLightDistance * kMinLightDistance);
}

// KHR_lights_punctual: smooth step between the outer and the inner cone; cosAngle between the spot's axis and the ray.
float coneAttenuation(float cosAngle, float scale, float offset)
{
    float x = clamp(cosAngle * scale + offset, 0.0, 1.0);
    return x * x;
}
