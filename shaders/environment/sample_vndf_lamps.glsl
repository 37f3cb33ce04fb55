// Bounded visible normals find what is not a lamp: environment/lamp_specular.glsl.
#include "environment/sample_vndf_bounded.glsl"
#define SPECULAR_LAMPS

LobeSample Es_vndf_lamps(vec3 v, float alpha, vec2 u)
{
    return Es_vndf_bounded(v, alpha, u);
}
