// Turquin 2019, eq. 16. E is the directional albedo, at NoV and with F = 1, of the lobe's own D and V.
vec3 M_scale(vec3 single, vec3 spread, vec3 f0, float bias, float E, float ELight, float EAverage)
{
    return single * (1.0 + f0 * ((1.0 - E) / E));
}
