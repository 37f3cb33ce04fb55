// Schlick 1994, eq. 15. 1 - VoH is given apart: where VoH is near 1 its fifth power is all that a black metal reflects.
vec3 F_schlick(float VoH, float oneLessVoH, vec3 f0, vec3 f90, float ior, vec3 eta, vec3 k, vec3 f82)
{
    float x2 = oneLessVoH * oneLessVoH;
    return f0 + (f90 - f0) * (x2 * x2 * oneLessVoH);
}
