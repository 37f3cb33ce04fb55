// The identity: what lies above 1 is clipped when it is stored.
#include "image/admitted.glsl"

vec3 tone_none(vec3 color)
{
    return admitted(color);
}
