// Read by GLSL and by C++: numbers that both must agree on.
#ifndef TORRANCE_SHARED_CONSTANTS_H
#define TORRANCE_SHARED_CONSTANTS_H

#ifdef __cplusplus
#define SHARED_FLOAT(name, value) inline constexpr float name = value
namespace torrance::shared {
#else
#define SHARED_FLOAT(name, value) const float name = value
#endif

SHARED_FLOAT(PI, 3.14159265358979323846f);

// alpha = max(r * r, kMinAlpha): alters perceptual roughness below 0.01 only (src/brdf/shading_point.h).
SHARED_FLOAT(kMinAlpha, 1e-4f);

#ifdef __cplusplus
}
#endif

#endif
