// The same, and which material and object they belong to: for layers, which alone read it.
#define IDS
#include "passes/surface_vertex.glsl"
