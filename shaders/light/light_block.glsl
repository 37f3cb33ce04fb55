#ifndef LIGHT_LIGHT_BLOCK
#define LIGHT_LIGHT_BLOCK
// The lights of the scene, by kind; behind them the points of the environment's lamps, where a method reads them.
#include "shared/light.h"

// The frame's own block once more: three uniform blocks are the most that a shader may have (src/gpu/pipeline.cpp).
layout(set = 0, binding = kBindFrame, scalar) uniform LightBlock { Frame sameFrame; Light lights[kMaxLights]; };

#endif
