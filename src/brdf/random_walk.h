// Light that is reflected again and again between the facets of a rough surface, followed facet by facet: Heitz,
// Hanika, d'Eon & Dachsbacher, Multiple-Scattering Microfacet BSDFs with the Smith Model, 2016. GGX, Smith, even
// heights.
#pragma once

#include "math/number_stream.h"
#include "math/vector.h"

namespace torrance::brdf {

/// What facets are made of: a conductor (channels r, g, b of the results) and, along the same paths, a dielectric
/// (channel a), whose transmitted light does not come back.
struct FacetInterface
{
    dvec3 eta = dvec3(1.0), k = dvec3(0.0); // conductor
    double ior = 1.5;                       // dielectric; 0: infinite, a perfect mirror
};

/// Both at the cosine of incidence on a facet.
dvec4 facetReflectance(const FacetInterface& facets, double cosine);

/// An unbiased estimate of f(v, l) NoL, 1/sr, of all light that is reflected `firstOrder` times or more. The estimate
/// joins every facet of one walk from v to l: the paper's section 6. v, l are unit, above the surface (+Z).
dvec4 walkResponse(const dvec3& v, const dvec3& l, double alpha, const FacetInterface& facets, int firstOrder,
                   NumberStream& numbers);

/// An unbiased estimate of the directional albedo at v, all orders: what one walk has left when it leaves the surface.
dvec4 walkAlbedo(const dvec3& v, double alpha, const FacetInterface& facets, NumberStream& numbers);

} // namespace torrance::brdf
