// Irradiance / pi by brute force: every texel of one level of a radiance cube, weighed by its cosine and its solid angle, which on
// the face is (1 + a^2 + b^2)^(-3/2) times a constant. Divided by the sum of the weights, so that an even environment stays even. n is unit.
vec3 irradianceSampled(samplerCube radiance, vec3 n)
{
    const int kGreatestFace = 32; // 6144 texels: as many as the irradiance cube is made from
    int size = textureSize(radiance, 0).x;
    float level = max(log2(float(size) / float(kGreatestFace)), 0.0);
    int side = min(size, kGreatestFace);
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
            {
                vec2 p = (2.0 * vec2(x, y) + 1.0) / float(side) - 1.0;
                // Any axes will do: each face is a square about one end of one axis.
                float end = face < 3 ? 1.0 : -1.0;
                int axis = face % 3;
                vec3 d = axis == 0 ? vec3(end, p) : axis == 1 ? vec3(p.x, end, p.y) : vec3(p, end);
                float length2 = dot(d, d);
                float weight = max(dot(n, d), 0.0) / (length2 * length2);
                sum += weight * textureLod(radiance, d, level).rgb;
                weights += weight;
            }
    return sum / weights;
}
