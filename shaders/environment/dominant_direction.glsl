// Where most of a rough lobe's light comes from: between the mirror direction r and the normal n. Lagarde & de Rousiers 2014,
// listing 22. Not unit: a cube map needs no length.
vec3 dominantDirection(vec3 n, vec3 r, float alpha)
{
    float smoothness = clamp(1.0 - alpha, 0.0, 1.0);
    return mix(n, r, smoothness * (sqrt(smoothness) + alpha));
}
