// Fdez-Aguera 2019: F_ms E_ms = F_ss F / (1 - F (1 - E)) * (1 - E), F the mean of Schlick's term, spread as a Lambertian surface's light.
vec3 M_fdez_aguera(vec3 single, vec3 spread, vec3 f0, float bias, float E, float ELight, float EAverage)
{
    vec3 F = f0 + (1.0 - f0) * (1.0 / 21.0);
    float Ems = max(1.0 - E, 0.0);
    vec3 FssEss = f0 * (E - bias) + bias;
    return single + spread * (FssEss * F * Ems / (1.0 - F * Ems));
}
