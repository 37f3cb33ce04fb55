// The light that leaves a surface point towards the eye, integrated exactly: punctual lights, a uniform environment,
// emission.
#pragma once

#include "brdf/method.h"
#include "reference/material_point.h"
#include "reference/punctual_light.h"

#include <optional>
#include <span>

namespace torrance {

/// Radiance towards `view` (unit, away from the surface) that one light's irradiance causes.
dvec3 shadePunctual(const brdf::Preset& preset, const MaterialPoint& material, const dvec3& view,
                    const LightSample& light);

/// The same for light of one radiance from every direction: the furnace, in closed form. F = F0 + (1 - F0) w5 splits
/// the specular integral into F0 scale + bias, and glTF's diffuse (1 - F) c / pi integrates to (1 - F0)(1 - w) c
/// (brdf/albedo.h); every method of multiple scattering and every weight of the body has its own closed form. Where
/// n.v <= 0 it is the limit n.v = 0. Occlusion is not applied. Throws Error (usage) for methods that the closed form
/// does not cover: anything but ggx, smith_corr, schlick and lambert.
dvec3 shadeFurnace(const brdf::Preset& preset, const MaterialPoint& material, const dvec3& view, const dvec3& radiance);

/// Everything that a point sees: where it stands, and from where light comes.
struct Illumination
{
    std::span<const Light> lights;
    dvec3 uniformRadiance = dvec3(0.0);
};

/// Emission + punctual lights + occlusion * furnace; the base colour alone where the material is unlit. `position` is
/// relative to `origin`.
dvec3 shade(const brdf::Preset& preset, const Illumination& illumination, const MaterialPoint& material,
            const dvec3& origin, const dvec3& position, const dvec3& view);

/// The radiance, times intensity, of an environment that is the same in all directions.
std::optional<dvec3> uniformRadiance(const Environment& environment);

} // namespace torrance
