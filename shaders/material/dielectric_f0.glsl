#ifndef TORRANCE_DIELECTRIC_F0
#define TORRANCE_DIELECTRIC_F0

// Reflectance at normal incidence of a dielectric of this index against air (KHR_materials_ior). Near 1 the difference is exact: nothing
// cancels. Index 0 stands for one without bound, as there: everything is reflected.
float dielectricF0(float ior)
{
    float r = (ior - 1.0) / (ior + 1.0);
    return r * r;
}

#endif
