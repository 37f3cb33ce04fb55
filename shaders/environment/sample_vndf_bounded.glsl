// The cap of Dupuy & Benyoub, cut where it would reflect below the horizon: Eto & Tokuyoshi 2023, listing 1 and eqs. 5 and 8.
#include "environment/lobe_sample.glsl"

LobeSample Es_vndf_bounded(vec3 v, float alpha, vec2 u)
{
    vec3 stretched = stretchedView(v, alpha);
    float size = length(stretched);
    vec3 w = stretched / size;
    float a2 = alpha * alpha;
    float s = 1.0 + length(v.xy);
    float share = (1.0 - a2) / (1.0 + a2 * (v.z * v.z) / (s * s));
    float z = 1.0 - u.x * (1.0 + share * w.z);
    float phi = 2.0 * PI * u.y;
    vec3 cap = vec3(sqrt(max((1.0 - z) * (1.0 + z), 0.0)) * vec2(cos(phi), sin(phi)), z);
    vec3 n = cap + w;
    vec3 h = normalize(vec3(alpha * n.xy, n.z));
    return lobeSample(v, h, alpha, 0.5 / (share * v.z + size));
}
