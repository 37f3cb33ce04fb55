// A microfacet normal of density D(h) NoH: Walter et al. 2007, eqs. 35 and 36. u in [0, 1)^2. The light's density is that over
// 4 VoH; a normal that v does not see adds nothing.
#include "environment/lobe_sample.glsl"

LobeSample Es_filtered_importance(vec3 v, float alpha, vec2 u)
{
    float phi = 2.0 * PI * u.y;
    float tangent2 = alpha * alpha * u.x / (1.0 - u.x);
    float z = inversesqrt(1.0 + tangent2);
    vec3 h = vec3(sqrt(tangent2) * z * vec2(cos(phi), sin(phi)), z);
    float VoH = dot(v, h);
    LobeSample s = lobeSample(v, h, alpha, z / (4.0 * max(VoH, kLeastDenominator)));
    s.weight = VoH > 0.0 ? s.weight : 0.0;
    return s;
}
