// What alpha does to a fragment, by the material's alpha mode (glTF 2.0, 3.9.4).
#ifdef ALPHA_MASK
// Below the cutoff there is no surface; above it the surface is opaque.
void applyAlphaMode(inout Surface s, float cutoff)
{
    if (s.alpha < cutoff)
        discard;
    s.alpha = 1.0;
}
#else
void applyAlphaMode(inout Surface s, float cutoff)
{
#ifndef ALPHA_BLEND
    s.alpha = 1.0;
#endif
}
#endif
