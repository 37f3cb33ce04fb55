#ifndef ENVIRONMENT_SPECULAR_SUMS
#define ENVIRONMENT_SPECULAR_SUMS

// A lobe of reflectance F0 (Schlick's, of F90 = 1) reflects F0 scale + bias.
struct SpecularSums
{
    vec3 scale;
    vec3 bias;
};

// What arrives of an environment's lamps at a surface, where points stand for them, else nothing: irradiance / pi, and the same of light
// that is weighed by (1 - VoH)^5 and by (1 - NoL)^5.
struct LampIrradiance
{
    vec3 whole;
    vec3 atVoH;
    vec3 atNoL;
};

float fifthPower(float x)
{
    float x2 = x * x;
    return x2 * x2 * x;
}

// Light of one direction, as the two sums take it.
void addReflected(inout SpecularSums sums, vec3 light, float VoH)
{
    float schlick = fifthPower(max(1.0 - VoH, 0.0));
    sums.scale += light * (1.0 - schlick);
    sums.bias += light * schlick;
}

// Irradiance / pi of one direction; nothing from below.
void addArriving(inout LampIrradiance lamps, vec3 irradiance, float VoH, float NoL)
{
    lamps.whole += irradiance;
    lamps.atVoH += irradiance * fifthPower(max(1.0 - VoH, 0.0));
    lamps.atNoL += irradiance * fifthPower(1.0 - NoL);
}

#endif
