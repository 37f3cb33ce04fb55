// Smith 1967; Walter et al. 2007, eqs. 23 and 34: masking and shadowing independent of each other.
float V_smith_uncorr(float NoV, float NoL, float NoH, float VoH, float alpha, float perceptualRoughness)
{
    if (NoV <= 0.0 || NoL <= 0.0)
        return 0.0;
    float a2 = alpha * alpha;
    float view = NoV + sqrt(a2 + (1.0 - a2) * NoV * NoV);
    float light = NoL + sqrt(a2 + (1.0 - a2) * NoL * NoL);
    return 1.0 / (view * light);
}
