#include "brdf/integration_map.h"

#include "brdf/albedo.h"
#include "brdf/shading_point.h"
#include "math/powers.h"
#include "math/quadrature.h"

#include <algorithm>
#include <cmath>

namespace torrance::brdf {
namespace {

// Burley's term has 2 alpha (l.h)^2 = alpha (1 + v.l), which is linear in the cosine of the azimuth: over all azimuths
// its mean is a polynomial in x = n.l, of degree 8 with the weight x, and five nodes are exact.
double diffuseAlbedo(double NoV, double alpha)
{
    static const QuadratureRule rule = gaussLegendre(5, 0.0, 1.0);
    const double view = fifthPower(1.0 - NoV);
    return 2.0 * integrate(rule, [&](double x) {
               const double light = fifthPower(1.0 - x);
               const double even = -0.5 + alpha * (1.0 + NoV * x); // f90 - 1 = even + turning cos(azimuth)
               const double turning2 = alpha * alpha * (1.0 - NoV * NoV) * (1.0 - x * x);
               return x * (1.0 + even * (light + view) + (even * even + 0.5 * turning2) * light * view);
           });
}

} // namespace

dvec3 integrationMap(double NoV, double perceptualRoughness)
{
    const double k = (perceptualRoughness + 1.0) * (perceptualRoughness + 1.0) / 8.0;
    const auto maskingOver = [k](double x) { return 1.0 / (x * (1.0 - k) + k); }; // G1(x) / x
    const AlbedoTerms terms =
        ggxAlbedo(NoV, perceptualRoughness, [&](double NoL) { return maskingOver(NoV) * maskingOver(NoL) / 4.0; });
    return {terms.scale, terms.bias,
            diffuseAlbedo(NoV, std::max(perceptualRoughness * perceptualRoughness, kMinAlpha))};
}

} // namespace torrance::brdf
