// Toksvig 2005, Mipmapping Normal Maps: the shorter the mean of the unit normals under a pixel, the smaller the power of Blinn's
// lobe, s' = s L / (L + s (1 - L)); the power that goes with GGX's alpha is 2 / alpha^2 - 2. L in [0, 1].
float AA_toksvig(float meanLength, float alpha)
{
    const float kFlat = 1.0 - 1.0 / 65535.0; // lengths are stored in 16 bits: within a step of 1 there is nothing to filter
    if (meanLength >= kFlat)
        return alpha;
    float a2 = alpha * alpha;
    // 2 / (s' + 2) with both sides of s' multiplied by alpha^2.
    float widened = a2 * meanLength + 2.0 * (1.0 - a2) * (1.0 - meanLength);
    return sqrt(widened / (widened + (1.0 - a2) * meanLength));
}
