// A sphere light by directions spread evenly over the cone that it fills: half angle asin(radius / distance), from its surface and
// from inside the hemisphere.
#include "environment/sample_points.glsl"
#include "light/axes_around.glsl"

layout(constant_id = 4) const uint kAreaSamples = 1;

// sin^2 of the cone's half angle.
float coneSine2(float distance2, float radius)
{
    float radius2 = radius * radius;
    return distance2 > radius2 ? radius2 / distance2 : 1.0;
}

// 1 - cos of the half angle, without cancellation where the sphere is far.
float coneHeight(float sine2)
{
    return sine2 / (1.0 + sqrt(1.0 - sine2));
}

// A direction of the cone about unit `axis`; u in [0, 1)^2.
vec3 coneDirection(vec3 axis, float height, vec2 u)
{
    float below = u.x * height;
    float phi = 2.0 * PI * u.y;
    float sine = sqrt(max(below * (2.0 - below), 0.0));
    return axesAround(axis) * vec3(sine * vec2(cos(phi), sin(phi)), 1.0 - below);
}
