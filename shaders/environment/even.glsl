// The mean radiance of an environment out of its nine harmonics, irradiance / pi: of the first alone the two are the same.
vec3 evenRadiance(vec3 c[9])
{
    return 0.28209479 * c[0];
}
