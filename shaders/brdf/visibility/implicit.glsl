// G = NoL NoV (Hoffman 2013): nothing is left but the 4.
float V_implicit(float NoV, float NoL, float NoH, float VoH, float alpha, float perceptualRoughness)
{
    if (NoV <= 0.0 || NoL <= 0.0)
        return 0.0;
    return 0.25;
}
