// Vertices of primitives, to clip space and to what the fragment shader reads.
#include "passes/surface_vertex.glsl"
