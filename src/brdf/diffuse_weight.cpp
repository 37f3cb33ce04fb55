#include "brdf/diffuse_weight.h"

namespace torrance::brdf {

// glTF 2.0, Appendix B: what the facet between light and viewer reflects is not there for the body.
dvec3 W_fresnel_voh(const ShadingPoint& point)
{
    return dvec3(1) - point.F;
}

// Light that enters through a smooth interface and leaves through it again: Shirley et al. 1997 without the factor that
// makes up for what is reflected back inside.
dvec3 W_fresnel_nol_nov(const ShadingPoint& point)
{
    return (dvec3(1) - point.FNoL) - (dvec3(1) - point.FNoL) * point.FNoV;
}

// What the interface has not reflected, whichever way the light came: a white body under it returns all.
dvec3 W_albedo_scaling(const ShadingPoint& point)
{
    return dvec3(1) - point.lobeAlbedo;
}

} // namespace torrance::brdf
