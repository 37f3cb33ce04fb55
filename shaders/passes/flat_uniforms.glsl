// What shading reads of the frame, of the first light and of the material, as the vertex shader tells it to fragments: the same numbers at
// all vertices. lavapipe (Mesa 22.3) reads a fragment's uniform blocks lane by lane, some 25 instructions a number, because its first lane
// may be dead; a flat input costs one. FLAT_OUT: included by a vertex shader. Locations lie behind those of passes/surface_vertex.glsl.
#ifndef PASSES_FLAT_UNIFORMS
#define PASSES_FLAT_UNIFORMS

#ifdef FLAT_OUT
#define FLAT flat out
#else
#define FLAT flat in
#endif

#ifdef LIT
layout(location = 13) FLAT vec4 flatEye; // towardsEye, eyeWeight
#endif
#ifdef ENVIRONMENT_LIGHT
layout(location = 14) FLAT vec4 flatEnvironmentX; // columns of environmentFromWorld; environmentIntensity
layout(location = 15) FLAT vec4 flatEnvironmentY; // environmentLastLevel
layout(location = 16) FLAT vec3 flatEnvironmentZ;
#endif
#ifdef PUNCTUAL_LIGHTS
layout(location = 17) FLAT vec3 flatLightDirection;
layout(location = 18) FLAT vec3 flatLightIntensity;
#endif
#ifdef PIXEL_RAYS
layout(location = 19) FLAT vec3 flatCorner;
layout(location = 20) FLAT vec3 flatAcross;
layout(location = 21) FLAT vec3 flatDown;
#endif
#ifndef MATERIAL_LIST
layout(location = 22) FLAT vec4 flatBaseColor;
layout(location = 23) FLAT vec4 flatEmissive; // normalScale
layout(location = 24) FLAT vec4 flatScalars;  // metallicFactor, roughnessFactor, occlusionStrength, ior
#ifdef PIXEL_RAYS
layout(location = 25) FLAT vec4 flatLevels;
layout(location = 26) FLAT float flatOcclusionLevel;
#endif
#endif

#endif
