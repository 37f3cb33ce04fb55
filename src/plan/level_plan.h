// Which levels of its textures a picture can read at all.
#pragma once

#include "plan/shading_plan.h"

#include <vector>

namespace torrance {

/// What samplers add to a texture's level: each of N samples of a pixel stands for 1/N of its area, so that the level
/// may be finer by half a step per doubling.
double levelBias(const Settings& settings);

/// By ShadingPlan::textures: the finest level that a picture of this camera may read; those before it need be neither
/// made nor kept. A bound, from each triangle's texels a metre and its least depth: 0 where a texture is magnified
/// somewhere, where its size is not the level's times a power of two (its texels would lie elsewhere), and where there
/// are too many triangles to ask.
std::vector<int> finestLevels(const Scene& scene, const ShadingPlan& plan, const Camera& camera);

} // namespace torrance
