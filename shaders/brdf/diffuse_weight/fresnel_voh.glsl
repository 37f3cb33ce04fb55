// glTF 2.0, Appendix B, fresnel_mix.
vec3 W_fresnel_voh(vec3 F, vec3 FNoV, vec3 FNoL, vec3 lobeAlbedo)
{
    return 1.0 - F;
}
