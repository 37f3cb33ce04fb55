// Schlick 1994, eq. 15.
vec3 F_schlick(float VoH, vec3 f0, vec3 f90, float ior, vec3 eta, vec3 k)
{
    float x = 1.0 - VoH;
    float x2 = x * x;
    return f0 + (f90 - f0) * (x2 * x2 * x);
}
