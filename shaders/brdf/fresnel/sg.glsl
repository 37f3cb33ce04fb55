// Karis 2013, eq. 5: Schlick's term with a spherical Gaussian for the fifth power.
vec3 F_sg(float VoH, float oneLessVoH, vec3 f0, vec3 f90, float ior, vec3 eta, vec3 k, vec3 f82)
{
    return f0 + (f90 - f0) * exp2(-VoH * (5.55473 * VoH + 6.98316));
}
