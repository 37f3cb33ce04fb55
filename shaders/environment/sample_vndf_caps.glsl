// A normal that v sees, of density G1 D(h) VoH / NoV: Dupuy & Benyoub 2023, listing 3. In the stretched space the reflected
// directions fill a spherical cap evenly.
#include "environment/lobe_sample.glsl"

LobeSample Es_vndf_caps(vec3 v, float alpha, vec2 u)
{
    vec3 stretched = stretchedView(v, alpha);
    float size = length(stretched);
    vec3 w = stretched / size;
    float z = 1.0 - u.x * (1.0 + w.z);
    float phi = 2.0 * PI * u.y;
    vec3 cap = vec3(sqrt(max((1.0 - z) * (1.0 + z), 0.0)) * vec2(cos(phi), sin(phi)), z);
    vec3 n = cap + w;
    vec3 h = normalize(vec3(alpha * n.xy, n.z));
    return lobeSample(v, h, alpha, 0.5 / (v.z + size));
}
