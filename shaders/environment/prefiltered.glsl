// Radiance prefiltered by roughness: the level of a chain whose level i holds alpha = (101^(i/last) - 1) / 100
// (src/prepare/environment_maps.h). `direction` in the environment's axes, not necessarily unit.
vec3 prefilteredRadiance(samplerCube chain, vec3 direction, float alpha, float lastLevel)
{
    const float kInverseLog101 = 0.150191905; // 1 / log2(101)
    float level = lastLevel * kInverseLog101 * log2(1.0 + 100.0 * alpha);
    return textureLod(chain, direction, level).rgb;
}
