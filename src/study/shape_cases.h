// Analytic shapes under every light, and spheres in every preset, pixel by pixel against the double formulas.
#pragma once

#include "study/picture_case.h"

#include <vector>

namespace torrance {

/// Four materials in the presets gltf and standard under one light: smooth and rough metal, a dielectric, half of each.
std::vector<PictureCase> shapeCases(AnalyticShape::Kind shape, Light::Kind light);

/// The same in a coloured environment of one radiance.
std::vector<PictureCase> shapeCasesInUniformLight(AnalyticShape::Kind shape);

/// Smooth and rough spheres of metal and dielectric under a point light, in one preset; of a source system, one that is
/// nearly a mirror as well.
std::vector<PictureCase> presetSpheres(const brdf::Preset& preset);

} // namespace torrance
