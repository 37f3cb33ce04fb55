// The triangle of passes/fullscreen.vert, for passes/resolve.frag.
#include "selected.glsl"
#include "shared/bindings.h"
#include "shared/frame.h"
#include "shared/material.h"

#ifdef FLAT_UNIFORMS
layout(set = 0, binding = kBindFrame, scalar) uniform FrameBlock { Frame frame; };
#ifndef MATERIAL_LIST
layout(set = 0, binding = kBindMaterial, scalar) uniform MaterialBlock { Material material; };
#endif
#define PIXEL_RAYS
#include "passes/uniforms_out.glsl"
#endif

void main()
{
#ifdef FLAT_UNIFORMS
    tellUniforms();
#endif
    vec2 p = vec2(gl_VertexIndex == 1 ? 3.0 : -1.0, gl_VertexIndex == 2 ? 3.0 : -1.0);
    gl_Position = vec4(p, 0.0, 1.0);
}
