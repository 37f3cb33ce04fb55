// What the deferred path needs to know beforehand.
#pragma once

#include "plan/shading_plan.h"

namespace torrance {

/// What decides the text of a lighting pass once a surface's parameters lie in the G-buffer: whether it is lit and
/// whether its lobe is compensated. A key with nothing else in it.
ShaderKey lightingClass(const ShaderKey& key);

/// Notes the classes of all opaque and masked surfaces, ordered. Throws Error (usage) where a method needs what only
/// the surface itself has.
void planDeferred(ShadingPlan& plan);

/// The place of a key's class in ShadingPlan::lightingClasses.
std::uint32_t lightingClassIndex(const ShadingPlan& plan, const ShaderKey& key);

} // namespace torrance
