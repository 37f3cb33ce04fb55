// What every curve does with an input that is no radiance (src/image/tone_curves.h): NaN and negative count as 0, and nothing for more than 2^60.
const float kMaxToneInput = 1152921504606846976.0;

vec3 admitted(vec3 c)
{
    return mix(vec3(0.0), min(c, vec3(kMaxToneInput)), greaterThan(c, vec3(0.0))); // a NaN compares false
}
