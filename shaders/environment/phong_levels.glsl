// Radiance under source E's cosine powers: of 8 levels, level i holds the exponent s of rough = i / 7, and rough =
// sqrt(sqrt(2 / (s + 2))) = sqrt(alpha). `direction` in the environment's axes, not necessarily unit.
vec3 phongRadiance(samplerCube chain, vec3 direction, float alpha)
{
    return textureLod(chain, direction, 7.0 * sqrt(alpha)).rgb;
}
