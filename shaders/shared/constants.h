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

// Added to denominators that vanish with both cosines: keeps D V below 1.6e37, alters V by less than 1e-7 below 1e22.
SHARED_FLOAT(kLeastDenominator, 1e-30f);

// The dielectric part of a glTF material: index 1.5, normal reflectance ((1.5 - 1) / (1.5 + 1))^2 (glTF 2.0, Appendix B).
SHARED_FLOAT(kDielectricIor, 1.5f);
SHARED_FLOAT(kDielectricF0, 0.04f);

// A light nearer than this (metres) shines as from this distance: 1/d^2 stays finite where a light lies on a surface.
SHARED_FLOAT(kMinLightDistance, 1e-6f);

// A shading normal that interpolation or a normal map turned away from the viewer is bent until n.v has this value: the
// surface is seen, so its normal cannot point away. Alters surfaces with n.v below it only.
SHARED_FLOAT(kMinNoV, 1e-4f);

// Four samples of a pixel are one surface where they lie within so many of its widths of a plane, in depth: shading differs
// little there. So much, too, is it worth to a sample that a surface was shaded nearer to it, a squared pixel.
SHARED_FLOAT(kPixelFlatness, 0.1f);

#ifdef __cplusplus
}
#endif

#endif
