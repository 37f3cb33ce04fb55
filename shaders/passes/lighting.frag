// The light of the surfaces of one class, whose parameters gbuffer.frag left. Pixels of other classes and empty ones stay as they are.
#include "selected.glsl"
#include "shared/bindings.h"
#include "shared/constants.h"
#include "shared/frame.h"
#include "material/direction.glsl"
#include "material/surface.glsl"

layout(set = 0, binding = kBindFrame, scalar) uniform FrameBlock { Frame frame; };

#include "material/shade.glsl"

layout(constant_id = 6) const uint kLightingClass = 0; // those before are shading's

layout(set = 0, binding = kBindGBuffer) uniform sampler2D positionClass;
layout(set = 0, binding = kBindGBuffer + 1) uniform sampler2D normalRoughness;
layout(set = 0, binding = kBindGBuffer + 2) uniform sampler2D baseColorMetallic;
layout(set = 0, binding = kBindGBuffer + 3) uniform sampler2D emissiveOcclusion;

layout(location = 0) out vec4 outColor;

Surface readGBuffer(ivec2 pixel, vec3 position)
{
    vec4 normal = texelFetch(normalRoughness, pixel, 0);
    vec4 baseColor = texelFetch(baseColorMetallic, pixel, 0);
    vec4 emissive = texelFetch(emissiveOcclusion, pixel, 0);
    Surface s;
    s.position = position;
    s.view = directionOf(frame.towardsEye - frame.eyeWeight * position);
    s.normal = normal.xyz;
    s.geometricNormal = normal.xyz; // not kept: no lighting reads it
    s.perceptualRoughness = normal.w;
    s.baseColor = baseColor.rgb;
    s.metallic = baseColor.w;
    s.ior = kDielectricIor; // not kept: the plan refuses others here
    s.emissive = emissive.rgb;
    s.occlusion = emissive.w;
    s.alpha = 1.0;
    return s;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 position = texelFetch(positionClass, pixel, 0);
    if (position.w != float(kLightingClass + 1u))
        discard;
    outColor = vec4(shade(readGBuffer(pixel, position.xyz)), 1.0);
}
