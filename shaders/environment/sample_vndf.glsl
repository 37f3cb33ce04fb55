// A normal that v sees, of density G1 D(h) VoH / NoV: Heitz 2018, listing 1. In the stretched space the hemisphere that v sees is a
// disk of which one half is squeezed.
#include "environment/lobe_sample.glsl"

LobeSample Es_vndf(vec3 v, float alpha, vec2 u)
{
    vec3 stretched = stretchedView(v, alpha);
    float size = length(stretched);
    vec3 w = stretched / size;
    float across2 = dot(w.xy, w.xy);
    vec3 a = across2 > 0.0 ? vec3(-w.y, w.x, 0.0) * inversesqrt(across2) : vec3(1.0, 0.0, 0.0);
    vec3 b = cross(w, a);
    float phi = 2.0 * PI * u.y;
    vec2 p = sqrt(u.x) * vec2(cos(phi), sin(phi));
    p.y = mix(sqrt(max(1.0 - p.x * p.x, 0.0)), p.y, 0.5 + 0.5 * w.z);
    vec3 n = p.x * a + p.y * b + sqrt(max(1.0 - dot(p, p), 0.0)) * w;
    vec3 h = normalize(vec3(alpha * n.xy, max(n.z, 0.0)));
    return lobeSample(v, h, alpha, 0.5 / (v.z + size));
}
