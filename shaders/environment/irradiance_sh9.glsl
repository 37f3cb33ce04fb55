// Irradiance / pi from nine harmonics: Ramamoorthi & Hanrahan 2001, eq. 13; order and signs of src/math/spherical_harmonics.h.
// n is unit. Harmonics of a small bright sun swing below zero on its far side: there is no negative light, so they end at 0.
vec3 irradianceSh9(vec3 c[9], vec3 n)
{
    vec3 sum = 0.28209479 * c[0];
    sum += 0.48860251 * (n.y * c[1] + n.z * c[2] + n.x * c[3]);
    sum += 1.09254843 * (n.x * n.y * c[4] + n.y * n.z * c[5] + n.x * n.z * c[7]);
    sum += 0.31539157 * (3.0 * n.z * n.z - 1.0) * c[6];
    sum += 0.54627422 * (n.x * n.x - n.y * n.y) * c[8];
    return max(sum, vec3(0.0));
}
