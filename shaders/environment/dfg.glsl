// Where (NoV, perceptual roughness) lies in a table of directional albedos: src/prepare/dfg_table.h. 0 and 1 are the centres
// of the first and the last texel. The root follows the lobe's albedo, which turns within NoV ~ alpha; the fourth power
// follows the diffuse weight, which falls steeply towards NoV = 1. NoV and roughness in [0, 1].
vec2 dfgUv(float NoV, float perceptualRoughness, vec2 size)
{
    float NoV2 = NoV * NoV;
    vec2 p = vec2(0.78 * sqrt(NoV) + 0.22 * NoV2 * NoV2, sqrt(perceptualRoughness));
    return (p * (size - 1.0) + 0.5) / size;
}
