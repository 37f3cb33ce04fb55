#include "brdf/random_walk.h"

#include "brdf/fresnel.h"
#include "math/sampling.h"

#include <algorithm>
#include <cmath>

namespace torrance::brdf {
namespace {

/// Smith's Lambda of GGX for any direction; below the horizon it is -1 and less. Heitz 2014, eq. 72; downwards the
/// square root changes its sign (Heitz et al. 2016, section 4).
double lambda(const dvec3& w, double alpha)
{
    const double x = alpha * alpha * (w.x * w.x + w.y * w.y) / (w.z * w.z);
    const double root = std::sqrt(1.0 + x);
    if (w.z < 0.0)
        return -0.5 * (1.0 + root);
    return x < 1.0 ? 0.5 * x / (1.0 + root) : 0.5 * (root - 1.0); // neither cancels
}

/// A ray among the facets. Heights count by the share of the surface that lies below them: 1 is above all of it.
struct Walker
{
    dvec3 direction;
    double below = 1.0;

    /// Goes to the next facet; false where it leaves the surface. Heitz et al. 2016, algorithm 1: upwards it leaves
    /// with the probability below^Lambda.
    bool advance(double alpha, double number)
    {
        const double L = lambda(direction, alpha);
        if (direction.z > 0.0 && !(number < 1.0 - std::pow(below, L)))
            return false;
        below *= std::pow(1.0 - number, -1.0 / L);
        return below <= 1.0;
    }

    /// Reflects at a facet that it can see, and returns the cosine there.
    double reflect(double alpha, const dvec2& numbers)
    {
        const dvec3 back = -direction;
        const dvec3 m = sampleGgxVisibleNormal(back, dvec2(alpha), numbers);
        const double cosine = std::min(1.0, glm::dot(back, m));
        direction = glm::normalize(2.0 * cosine * m - back);
        return cosine;
    }
};

dvec2 pair(NumberStream& numbers)
{
    const double x = numbers.next();
    return {x, numbers.next()};
}

/// The density, 1/sr, in which a facet sends what arrives from `back` to l, times its reflectance.
dvec4 phase(const dvec3& back, const dvec3& l, double alpha, const FacetInterface& facets)
{
    const dvec3 sum = back + l;
    if (!(sum.z > 0.0)) // facets look upwards
        return dvec4(0.0);
    const dvec3 m = glm::normalize(sum);
    const double length = glm::length(dvec3(alpha * back.x, alpha * back.y, back.z));
    return facetReflectance(facets, std::min(1.0, glm::dot(back, m))) *
           (ggxNormalDensity(dvec2(alpha), m) / (2.0 * (back.z + length)));
}

} // namespace

dvec4 facetReflectance(const FacetInterface& facets, double cosine)
{
    ShadingPoint point;
    point.VoH = cosine;
    point.oneLessVoH = 1.0 - cosine;
    point.ior = facets.ior;
    point.eta = facets.eta;
    point.k = facets.k;
    return {F_exact_conductor(point), F_exact_dielectric(point).r};
}

dvec4 walkResponse(const dvec3& v, const dvec3& l, double alpha, const FacetInterface& facets, int firstOrder,
                   NumberStream& numbers)
{
    const double outwards = lambda(l, alpha);
    Walker walker{-v};
    dvec4 weight(1.0), sum(0.0);
    for (int order = 1; walker.advance(alpha, numbers.next()); ++order) {
        if (order >= firstOrder)
            sum += weight * phase(-walker.direction, l, alpha, facets) * std::pow(walker.below, outwards);
        weight *= facetReflectance(facets, walker.reflect(alpha, pair(numbers)));
    }
    return sum;
}

dvec4 walkAlbedo(const dvec3& v, double alpha, const FacetInterface& facets, NumberStream& numbers)
{
    Walker walker{-v};
    dvec4 weight(1.0);
    while (walker.advance(alpha, numbers.next()))
        weight *= facetReflectance(facets, walker.reflect(alpha, pair(numbers)));
    return weight;
}

} // namespace torrance::brdf
