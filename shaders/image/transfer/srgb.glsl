// IEC 61966-2-1: display-linear to codes, with its straight piece at black.
vec3 transfer_srgb(vec3 linear)
{
    vec3 x = mix(vec3(0.0), linear, greaterThan(linear, vec3(0.0)));
    return mix(1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055, 12.92 * x, lessThanEqual(x, vec3(0.0031308)));
}
