// What the attributes path needs to know beforehand: which surfaces are shaded together once all are drawn.
#pragma once

#include "plan/shading_plan.h"

namespace torrance {

/// How many materials are shaded in one go.
inline constexpr std::size_t kMaxClassMaterials = 256;

/// Gives the opaque and masked batches that can be shaded from their attributes a class, and the materials in it a
/// slot. The others, shaded as they are drawn, are those with vertex colours, without normals, of lines, points and
/// analytic shapes, and those whose textures are not all sampled at one place and of one proportion.
void planAttributes(const Scene& scene, ShadingPlan& plan);

/// Whether a batch can be shaded from its attributes.
bool leavesAttributes(const Scene& scene, const ShadingPlan& plan, const Batch& batch);

/// What of a surface's key decides how it is shaded from its attributes.
ShaderKey resolveKey(const ShaderKey& key);

/// How many pictures hold attributes: the second is of texture coordinates, which some class must read.
std::size_t attributePictures(const ShadingPlan& plan);

} // namespace torrance
