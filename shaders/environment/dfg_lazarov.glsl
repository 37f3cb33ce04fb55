// (scale, bias) of Lazarov 2013, Environment BRDF, whose a0 and a1 are the albedos at reflectance 0 and 1. Fitted to Blinn's
// distribution of power 8192^gloss with Schlick's visibility; the power that goes with GGX's alpha is 2/alpha^2 - 2.
vec2 DFG_lazarov(float NoV, float perceptualRoughness)
{
    const float kLog2Greatest = 13.0; // 8192
    float r2 = perceptualRoughness * perceptualRoughness;
    float a2 = max(r2 * r2, 1e-8); // alpha >= kMinAlpha; the gloss ends at 1 long before
    float gloss = clamp(log2(max((2.0 - 2.0 * a2) / a2, 1.0)) / kLog2Greatest, 0.0, 1.0);
    vec4 t = vec4(1.0 / 0.96, 0.475, (0.0275 - 0.25 * 0.04) / 0.96, 0.25) * gloss;
    t += vec4(0.0, 0.0, (0.015 - 0.75 * 0.04) / 0.96, 0.75);
    float a0 = t.x * min(t.y, exp2(-9.28 * NoV)) + t.z;
    return vec2(t.w - a0, a0);
}
