// (scale, bias) of the polynomial of Narkowicz 2014, Analytical DFG Term for IBL: fitted to GGX of alpha = (1 - gloss)^4 with the
// uncorrelated Smith visibility. His fade of the bias below F0 = 0.02 is a convention of his engine for materials without
// a highlight, and left out.
vec2 DFG_narkowicz(float NoV, float perceptualRoughness)
{
    float x = 1.0 - sqrt(perceptualRoughness);
    float y = NoV;
    float bias = clamp(min(x * (-0.1688 + 1.895 * x), 0.9903 + y * (-4.853 + y * (8.404 - 5.069 * y))), 0.0, 1.0);
    float delta = clamp(0.6045 + x * (1.699 + x * (-3.603 + 2.661 * x)) + y * (-0.5228 + 1.404 * x + 0.1939 * y), 0.0, 1.0);
    return vec2(delta - bias, bias);
}
