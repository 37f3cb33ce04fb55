// About how much of the light from around each of many directions a surface reflects towards the viewer: for choosing
// directions, so that no method needs to match it.
#pragma once

#include "reference/environment_sampler.h"
#include "reference/material_point.h"

#include <vector>

namespace torrance {

/// By tile, up to a common factor: a Lambertian body and a GGX lobe with Schlick's Fresnel term, of the tile's centre,
/// the lobe widened by the tile's size; above 0 where a direction of the tile lies above the surface. `view` is unit,
/// in the world, above the surface.
std::vector<double> reflectedImportance(std::span<const EnvironmentSampler::Tile> tiles, const MaterialPoint& material,
                                        const dvec3& view);

} // namespace torrance
