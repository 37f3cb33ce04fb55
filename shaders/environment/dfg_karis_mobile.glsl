// (scale, bias) of Karis 2014, Physically Based Shading on Mobile: Lazarov's form, fitted to GGX of alpha = r^2 with Schlick's
// visibility of k = alpha/2.
vec2 DFG_karis_mobile(float NoV, float perceptualRoughness)
{
    vec4 r = perceptualRoughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    float a004 = min(r.x * r.x, exp2(-9.28 * NoV)) * r.x + r.y;
    return vec2(-1.04, 1.04) * a004 + r.zw;
}
