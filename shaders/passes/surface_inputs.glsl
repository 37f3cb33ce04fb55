// What every surface pass binds, and its surface under the fragment.
#include "shared/bindings.h"
#include "shared/frame.h"
#include "shared/material.h"

layout(set = 0, binding = kBindFrame, scalar) uniform FrameBlock { Frame frame; };
layout(set = 0, binding = kBindMaterial, scalar) uniform MaterialBlock { Material material; };

#if defined(SURFACE_SPHERE) || defined(SURFACE_PLANE)
#include "material/shape_surface.glsl"
#else
#include "material/mesh_surface.glsl"
#endif
#include "material/coverage.glsl"
