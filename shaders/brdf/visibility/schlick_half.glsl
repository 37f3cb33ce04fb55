// Schlick 1994, eq. 19, with k = alpha/2 (Karis 2013).
float V_schlick_half(float NoV, float NoL, float NoH, float VoH, float alpha, float perceptualRoughness)
{
    if (NoV <= 0.0 || NoL <= 0.0)
        return 0.0;
    float k = 0.5 * alpha;
    return 0.25 / ((NoV * (1.0 - k) + k) * (NoL * (1.0 - k) + k));
}
