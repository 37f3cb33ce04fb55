// Kulla & Conty 2017: what the interface does not reflect towards the viewer, of light from all directions.
vec3 W_albedo_scaling(vec3 F, vec3 FNoV, vec3 FNoL, vec3 lobeAlbedo)
{
    return 1.0 - lobeAlbedo;
}
