// Radiance under source B's lobes: lod = 5 r and r = sqrt(alpha), for level i holds alpha = (i / 5)^2. `direction` in the environment's
// axes, not necessarily unit.
vec3 ggxLevelRadiance(samplerCube chain, vec3 direction, float alpha, float lastLevel)
{
    return textureLod(chain, direction, min(5.0 * sqrt(alpha), lastLevel)).rgb;
}
