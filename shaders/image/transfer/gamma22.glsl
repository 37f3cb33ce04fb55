// The power 1/2.2, which some sources have in place of sRGB.
vec3 transfer_gamma22(vec3 linear)
{
    return pow(mix(vec3(0.0), linear, greaterThan(linear, vec3(0.0))), vec3(1.0 / 2.2));
}
