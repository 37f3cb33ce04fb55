// How far a pixel of an analytic shape may move because its inputs are floats.
#pragma once

#include "reference/shade.h"

#include <functional>
#include <optional>
#include <vector>

namespace torrance {

/// One pixel of one analytic shape without textures: every number that a device is given as floats. Places are relative
/// to the camera.
struct PixelInputs
{
    Ray ray;
    AnalyticShape shape;
    Material material;
    std::vector<Light> lights;
    dvec3 uniformRadiance = dvec3(0.0);
};

/// The pixel whose top-left corner is (x, y), seen through its centre. Takes all lights and the environment where it is
/// uniform.
PixelInputs pixelInputs(const Scene& scene, int shape, const Camera& camera, int width, int height, int x, int y);

/// What the pixel shows; nothing where the ray misses the shape.
std::optional<dvec3> pixelRadiance(const brdf::Preset& preset, const PixelInputs& inputs);

/// The surface that the pixel shows: what a shading term is computed from.
struct PixelSurface
{
    MaterialPoint material;
    dvec3 position = dvec3(0.0); // relative to the camera
    dvec3 view = dvec3(0.0);     // unit, towards the camera
};
std::optional<PixelSurface> pixelSurface(const PixelInputs& inputs);

/// Any value of a pixel; nothing where the ray misses.
using PixelFormula = std::function<std::optional<dvec3>(const PixelInputs&)>;

/// kInputRounding of a number's size is what rounding it to float may change. A vector's components count by the
/// vector's length, because a rotation spreads its rounding over all of them.
inline constexpr double kInputRounding = 5.9604644775390625e-08; // 2^-24

/// Whether moving any one input by kInputRounding leaves the ray meeting, or missing, the shape.
bool coverageIsDecided(const PixelInputs& inputs);

/// The sum over every input of the absolute change that moving it by kInputRounding, up or down, makes: ray direction,
/// the shape's place, axes and radius, the lights' places, directions, ranges and cones, the roughness. This is kappa
/// 2^-24 |c| of the pixel as a whole, geometry included; near a silhouette it grows without bound. Infinite where
/// coverageIsDecided is false, 0 where the ray misses.
dvec3 pixelCondition(const PixelFormula& formula, const PixelInputs& inputs);
/// The same of pixelRadiance.
dvec3 pixelCondition(const brdf::Preset& preset, const PixelInputs& inputs);

} // namespace torrance
