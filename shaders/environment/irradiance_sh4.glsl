// Irradiance / pi from four harmonics: Ramamoorthi & Hanrahan 2001, eq. 13, without its band 2; order and signs of
// src/math/spherical_harmonics.h. n is unit. There is no negative light: what swings below zero ends at 0.
vec3 irradianceSh4(vec3 c[9], vec3 n)
{
    vec3 sum = 0.28209479 * c[0] + 0.48860251 * (n.y * c[1] + n.z * c[2] + n.x * c[3]);
    return max(sum, vec3(0.0));
}
