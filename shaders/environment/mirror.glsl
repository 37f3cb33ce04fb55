// Source B's environment of phong: the map itself, level 0, whatever the roughness. `direction` in the environment's axes, not necessarily
// unit.
#include "environment/panorama.glsl"

vec3 panoramaRadiance(sampler2D map, vec3 direction)
{
    return textureLod(map, panoramaUv(direction), 0.0).rgb;
}

// GLSL's refract takes the direction that arrives, -v. A ratio of indices below 1 refracts all of them.
vec3 refractedDirection(vec3 n, vec3 v)
{
    const float kRatio = 0.8; // the source's, outside over inside
    return refract(-v, n, kRatio);
}
