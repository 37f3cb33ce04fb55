#include "shared/constants.h"

// A normal that points away from the viewer (n.v < kMinNoV) is turned in the plane of n and v until n.v = kMinNoV (to first
// order): the surface is visible, so some of it faces the viewer. n and v unit; the result is unit.
vec3 bendNormal(vec3 n, vec3 v)
{
    float NoV = dot(n, v);
    return NoV < kMinNoV ? normalize(n + (kMinNoV - NoV) * v) : n;
}
