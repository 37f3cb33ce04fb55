// The surface of an analytic shape under a pixel: exact but for the rounding of its inputs.
#include "material/bend_normal.glsl"
#include "material/surface.glsl"
#ifdef AA_TOKUYOSHI
#include "material/aa_tokuyoshi.glsl"
#endif
#include "shared/instance.h"

layout(set = 0, binding = kBindInstance, scalar) uniform InstanceBlock { Instance instance; };

struct PixelRay
{
    vec3 origin;    // relative to the eye
    vec3 direction; // unit
};

PixelRay pixelRay(vec2 pixel)
{
    vec3 q = frame.corner + pixel.x * frame.across + pixel.y * frame.down;
    return PixelRay(q * frame.orthographic, normalize(mix(q, frame.forward, frame.orthographic)));
}

struct Hit
{
    bool found;
    vec3 position;
    vec3 normal; // unit, the side that the shape calls outside
};

// Nearest hit of a sphere. The distance of the ray from the centre comes from the vector between them: b^2 - c, the
// textbook form, loses the bits that decide near the silhouette (Haines et al., Precision Improvements for Ray/Sphere
// Intersection, Ray Tracing Gems, 2019).
Hit hitSphere(PixelRay ray, vec3 center, float radius)
{
    vec3 toCenter = center - ray.origin;
    float along = dot(toCenter, ray.direction);
    vec3 apart = toCenter - along * ray.direction;
    float apartLength = length(apart);
    float half2 = (radius - apartLength) * (radius + apartLength);
    Hit hit;
    hit.found = half2 >= 0.0 && along > 0.0;
    vec3 normal = -(apart + sqrt(max(half2, 0.0)) * ray.direction) / radius;
    hit.normal = normal;
    hit.position = center + radius * normal;
    return hit;
}

// The square |x|, |y| <= 1 of the plane z = 0 of the instance's axes, scale `size`.
Hit hitSquare(PixelRay ray, mat3 axes, vec3 center, float size)
{
    vec3 normal = axes[2];
    vec3 toCenter = center - ray.origin;
    float distance = dot(toCenter, normal) / dot(ray.direction, normal);
    vec3 offset = distance * ray.direction - toCenter;
    Hit hit;
    hit.found = distance > 0.0 && abs(dot(offset, axes[0])) <= size && abs(dot(offset, axes[1])) <= size;
    hit.normal = normal;
    hit.position = center + offset;
    return hit;
}

Surface readSurface()
{
    float size = length(instance.linear[0]); // a shape's scale is uniform
    PixelRay ray = pixelRay(gl_FragCoord.xy);
#ifdef SURFACE_SPHERE
    Hit hit = hitSphere(ray, instance.translation, size);
#else
    Hit hit = hitSquare(ray, instance.linear / size, instance.translation, size);
#endif
    vec3 view = -ray.direction;
    bool front = dot(hit.normal, view) > 0.0;
#ifdef AA_TOKUYOSHI
    vec3 outside = hit.normal;
#endif
#ifdef DOUBLE_SIDED
    hit.normal = front ? hit.normal : -hit.normal;
#else
    hit.found = hit.found && front;
#endif
    if (!hit.found)
        discard;
    vec4 clip = frame.clipFromEye * vec4(hit.position, 1.0);
    gl_FragDepth = clip.z / clip.w;

    Surface s;
    s.position = hit.position;
    s.geometricNormal = hit.normal;
    s.view = view;
    s.normal = bendNormal(hit.normal, view);
    s.baseColor = material.baseColorFactor.rgb;
    s.alpha = material.baseColorFactor.a;
    s.metallic = material.metallicFactor;
    s.ior = material.ior;
    s.perceptualRoughness = material.roughnessFactor;
#ifdef AA_TOKUYOSHI
    float alpha = max(s.perceptualRoughness * s.perceptualRoughness, kMinAlpha);
    // The next pixels' normals by rays of their own: derivatives would need neighbours outside of the triangle, and lavapipe's read
    // zeros for the frame.
#ifdef SURFACE_SPHERE
    vec3 right = hitSphere(pixelRay(gl_FragCoord.xy + vec2(1.0, 0.0)), instance.translation, size).normal;
    vec3 below = hitSphere(pixelRay(gl_FragCoord.xy + vec2(0.0, 1.0)), instance.translation, size).normal;
#else
    vec3 right = outside, below = outside;
#endif
    float filtered = AA_tokuyoshi(right - outside, below - outside, alpha);
    s.perceptualRoughness = filtered == alpha ? s.perceptualRoughness : sqrt(filtered);
#endif
    s.occlusion = 1.0;
    s.emissive = material.emissiveFactor;
    return s;
}
