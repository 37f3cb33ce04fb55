// Turquin 2019, eq. 16. E is the directional albedo, at NoV and with F = 1, of the lobe's own D and V.
vec3 M_scale(vec3 f0, float E)
{
    return 1.0 + f0 * ((1.0 - E) / E);
}
