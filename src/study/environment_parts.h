// What the device's way of lighting by an environment comes to at one point, in double: each method by its formula.
#pragma once

#include "plan/settings.h"
#include "reference/environment_sampler.h"
#include "reference/material_point.h"

namespace torrance {

/// Radiance towards the viewer.
struct EnvironmentParts
{
    dvec3 body = dvec3(0.0);
    dvec3 lobe = dvec3(0.0);
};

/// Where the lobe's albedos come from.
enum class AlbedoSource
{
    exact,  // quadrature
    method, // the formula of the slot dfg
};

/// As shaders/environment/lighting.glsl puts the methods together. Of composed presets whose environment methods have
/// formulas; `environment` is not dark, `view` is unit, in the world.
EnvironmentParts environmentParts(const Settings& settings, const EnvironmentSampler& environment,
                                  const MaterialPoint& material, const dvec3& view, AlbedoSource albedos);

} // namespace torrance
