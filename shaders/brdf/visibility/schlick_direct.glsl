// Karis 2013, eq. 4: k = (r + 1)^2 / 8, for punctual and area lights.
float V_schlick_direct(float NoV, float NoL, float NoH, float VoH, float alpha, float perceptualRoughness)
{
    if (NoV <= 0.0 || NoL <= 0.0)
        return 0.0;
    float k = (perceptualRoughness + 1.0) * (perceptualRoughness + 1.0) / 8.0;
    return 0.25 / ((NoV * (1.0 - k) + k) * (NoL * (1.0 - k) + k));
}
