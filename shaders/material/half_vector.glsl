// Halfway between two unit vectors, with the digits that the cosines of it would lose.
#ifndef TORRANCE_MATERIAL_HALF_VECTOR
#define TORRANCE_MATERIAL_HALF_VECTOR

struct HalfVector
{
    vec3 t; // along h, of length 2 v.h
    float NoH;
    float VoH;
    float oneLessVoH; // 1 - v.h
    float sin2H;      // 1 - n.h^2
};

// t is not normalised: its length is 2 VoH, and its cross product with n keeps the digits that 1 - NoH^2 would lose. v and l are unit
// up to rounding only, and at grazing, where t is short, what their lengths differ by would tilt it: |v| - |l| = t.d / 2 to first
// order, taken out along d.
HalfVector halfVector(vec3 n, vec3 v, vec3 l, float NoV, float NoL)
{
    HalfVector h;
    vec3 t = v + l;
    vec3 d = v - l;
    t -= d * (0.25 * dot(t, d));
    vec3 nxt = cross(n, t);
    float length2 = dot(t, t);
    h.t = t;
    h.NoH = (NoV + NoL) * inversesqrt(length2);
    h.VoH = 0.5 * sqrt(length2);
    h.oneLessVoH = 0.25 * dot(d, d) / (1.0 + h.VoH);
    h.sin2H = dot(nxt, nxt) / length2;
    return h;
}

#endif
