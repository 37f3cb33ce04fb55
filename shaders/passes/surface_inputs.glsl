// What every surface pass binds, and its surface under the fragment.
#include "passes/uniforms.glsl"

#if defined(SURFACE_SPHERE) || defined(SURFACE_PLANE)
#include "material/shape_surface.glsl"
#else
#include "material/mesh_surface.glsl"
#endif
#include "material/coverage.glsl"
