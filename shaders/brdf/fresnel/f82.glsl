// Hoffman 2019: Schlick's term less a c (1 - c)^6, whose height a gives the reflectance f82 * Schlick's (the tint of Kutz et al. 2021) at the
// cosine 1/7. Held within [0, 1], which tints below 25/49 and above 1 leave.
vec3 F_f82(float VoH, float oneLessVoH, vec3 f0, vec3 f90, float ior, vec3 eta, vec3 k, vec3 f82)
{
    const float kPower5 = 0.462664366631; // (6/7)^5
    const float kInverseDip = 17.6513846022; // 7^7 / 6^6
    float x2 = oneLessVoH * oneLessVoH;
    float x5 = x2 * x2 * oneLessVoH;
    vec3 at82 = mix(f0, f90, kPower5);
    vec3 a = (at82 - at82 * f82) * kInverseDip;
    return clamp(f0 + (f90 - f0) * x5 - a * (VoH * x5 * oneLessVoH), 0.0, 1.0);
}
