#ifndef ENVIRONMENT_SPECULAR_SUMS
#define ENVIRONMENT_SPECULAR_SUMS

// A lobe of reflectance F0 (Schlick's, of F90 = 1) reflects F0 scale + bias.
struct SpecularSums
{
    vec3 scale;
    vec3 bias;
};

// Light of one direction, as the two sums take it.
void addReflected(inout SpecularSums sums, vec3 light, float VoH)
{
    float x = max(1.0 - VoH, 0.0);
    float x2 = x * x;
    float schlick = x2 * x2 * x;
    sums.scale += light * (1.0 - schlick);
    sums.bias += light * schlick;
}

#endif
