#ifndef ENVIRONMENT_RADIANCE_LEVEL
#define ENVIRONMENT_RADIANCE_LEVEL
// The level of a cube of `size` texels a side on which a texel towards unit l fills the solid angle 1 / (count density): a
// texel of level 0 fills 4 m^3 / size^2, m the largest component of l.
float radianceLevel(vec3 l, float count, float density, float size)
{
    float m = max(max(abs(l.x), abs(l.y)), abs(l.z));
    return max(0.5 * log2(size * size / (4.0 * m * m * m * count * density)), 0.0);
}

#endif
