// What the attributes path needs to know beforehand: which surfaces are shaded together once all are drawn.
#pragma once

#include "plan/shading_plan.h"

#include <optional>

namespace torrance {

/// How many materials are shaded in one go.
inline constexpr std::size_t kMaxClassMaterials = 256;

/// Gives the opaque and masked batches that can be shaded from their attributes a class, and the materials in it a
/// slot. The others, shaded as they are drawn, are those with vertex colours, without normals, of lines, points and
/// analytic shapes, and those whose textures are not all sampled at one place and of one proportion.
void planAttributes(ShadingPlan& plan);

/// Whether a batch can be shaded from its attributes.
bool leavesAttributes(const ShadingPlan& plan, const Batch& batch);

/// What of a surface's key decides how it is shaded from its attributes.
ShaderKey resolveKey(const ShaderKey& key);

/// The texture of these whose level of detail is kept: the largest, for what is kept ends at 0, and told in a smaller
/// one's texels it would end where that one is magnified. Nothing where there are none.
std::optional<TextureRole> levelRole(const ShadingPlan& plan, const TextureSet& textures);

/// How many pictures hold attributes: the second is of texture coordinates, which some class must read.
std::size_t attributePictures(const ShadingPlan& plan);

} // namespace torrance
