#include "shared/material.h"

// KHR_texture_transform, as an affine map made on the CPU.
vec2 transformUv(UvTransform transform, vec2 uv)
{
    return vec2(dot(transform.u, vec3(uv, 1.0)), dot(transform.v, vec3(uv, 1.0)));
}
