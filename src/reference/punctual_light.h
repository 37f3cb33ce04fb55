// What arrives at a point from a punctual light, as KHR_lights_punctual states it.
#pragma once

#include "scene/scene.h"

namespace torrance {

struct LightSample
{
    dvec3 direction = dvec3(0.0, 0.0, 1.0); // unit, towards the light
    dvec3 irradiance = dvec3(0.0);          // lux, on a surface that faces the light
};

/// Scale of the cone's falloff is 1 / max(kLeastConeWidth, cos inner - cos outer): the extension's own guard. It alters
/// cones whose cosines differ by less.
inline constexpr double kLeastConeWidth = 0.001;

/// A light nearer than this (metres) shines as from this distance: 1/d^2 stays finite where a light lies on a surface.
/// The same constant stands in shaders/shared/constants.h.
inline constexpr double kMinLightDistance = 1e-6;

/// `origin` is what `position` is relative to. At the light's own place, where it has no direction,
/// nothing arrives.
LightSample sampleLight(const Light& light, const dvec3& origin, const dvec3& position);

} // namespace torrance
