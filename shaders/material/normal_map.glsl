// Tangent-space normal of a normal map's texel (glTF 2.0, 3.9.3): (2 c - 1) * (scale, scale, 1), not normalised.
vec3 decodeNormal(vec3 texel, float scale)
{
    return (2.0 * texel - 1.0) * vec3(scale, scale, 1.0);
}

// Into the frame of unit normal n and tangent t (xyz, sign of the bitangent), both normalised after interpolation. glTF 2.0,
// 3.7.2.1: bitangent = cross(n, t.xyz) * t.w. A tangent or a sum of length zero leaves n.
vec3 applyNormalMap(vec3 n, vec4 t, vec3 texelNormal)
{
    if (dot(t.xyz, t.xyz) == 0.0)
        return n;
    vec3 tangent = normalize(t.xyz);
    vec3 m = tangent * texelNormal.x + (t.w * cross(n, tangent)) * texelNormal.y + n * texelNormal.z;
    return dot(m, m) > 0.0 ? normalize(m) : n;
}
