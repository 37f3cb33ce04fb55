// Shirley et al. 1997: in through a smooth interface, and out again.
vec3 W_fresnel_nol_nov(vec3 F, vec3 FNoV, vec3 FNoL, vec3 lobeAlbedo)
{
    return (1.0 - FNoL) * (1.0 - FNoV);
}
