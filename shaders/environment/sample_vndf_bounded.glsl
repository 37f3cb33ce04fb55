// The cap of Dupuy & Benyoub, cut where it would reflect below the horizon: Eto & Tokuyoshi 2023, listing 1 and eqs. 5 and 8.
#include "environment/lobe_sample.glsl"

// How far the cap reaches below the horizon.
float capShare(vec3 v, float alpha)
{
    float a2 = alpha * alpha;
    float s = 1.0 + length(v.xy);
    return (1.0 - a2) / (1.0 + a2 * (v.z * v.z) / (s * s));
}

// The density of a direction above the horizon is this times D of its half vector.
float boundedDensityOverD(vec3 v, float alpha)
{
    return 0.5 / (capShare(v, alpha) * v.z + length(stretchedView(v, alpha)));
}

LobeSample Es_vndf_bounded(vec3 v, float alpha, vec2 u)
{
    vec3 w = normalize(stretchedView(v, alpha));
    float z = 1.0 - u.x * (1.0 + capShare(v, alpha) * w.z);
    float phi = 2.0 * PI * u.y;
    vec3 cap = vec3(sqrt(max((1.0 - z) * (1.0 + z), 0.0)) * vec2(cos(phi), sin(phi)), z);
    vec3 n = cap + w;
    vec3 h = normalize(vec3(alpha * n.xy, n.z));
    return lobeSample(v, h, alpha, boundedDensityOverD(v, alpha));
}
