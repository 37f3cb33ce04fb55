// The identity, for pictures that hold data.
vec3 transfer_linear(vec3 linear)
{
    return mix(vec3(0.0), linear, greaterThan(linear, vec3(0.0)));
}
