// Which methods do not go together, or not with this scene: refused before anything is drawn.
#pragma once

#include "plan/shading_plan.h"

namespace torrance {

/// Of a plan whose surfaces and lights are known. Throws Error (usage).
void checkMethods(const ShadingPlan& plan);

} // namespace torrance
