// Small scenes whose every pixel can be computed: one analytic shape, a material of factors, one light. Lengths in
// metres.
#pragma once

#include "scene/scene.h"

namespace torrance {

/// A material of factors alone.
Material plainMaterial(const dvec3& baseColor, double metallic, double perceptualRoughness);

/// One analytic shape, turned and off the world's origin, so that no coordinate is zero by chance. A sphere of radius
/// 0.8 or a square of half side 0.8, about kShapeCenter.
Scene shapeScene(AnalyticShape::Kind kind, const Material& material);

inline constexpr dvec3 kShapeCenter(0.3, -0.2, 0.5);

/// One light of each kind that lights shapeScene from the upper right, near enough that its distance matters; the point
/// light has a range, the spot's cone edge crosses the shape.
Light testLight(Light::Kind kind);

/// Every texel the same.
Environment uniformEnvironment(const dvec3& radiance);

} // namespace torrance
