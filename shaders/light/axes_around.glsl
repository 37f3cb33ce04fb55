#ifndef LIGHT_AXES_AROUND
#define LIGHT_AXES_AROUND

// Axes about unit n, its third column: Duff et al. 2017, listing 3; the same as frameAround of src/math/frame.h.
mat3 axesAround(vec3 n)
{
    float side = n.z < 0.0 ? -1.0 : 1.0;
    float a = -1.0 / (side + n.z);
    float b = n.x * n.y * a;
    return mat3(1.0 + side * n.x * n.x * a, side * b, -side * n.x, b, side + n.y * n.y * a, -n.y, n);
}

#endif
