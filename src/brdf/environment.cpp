#include "brdf/environment.h"

#include "brdf/albedo.h"
#include "brdf/distribution.h"
#include "brdf/irradiance_window.h"
#include "brdf/visibility.h"
#include "math/frame.h"
#include "math/low_discrepancy.h"
#include "math/pixel_rotation.h"
#include "math/powers.h"
#include "math/quadrature.h"
#include "math/sampling.h"
#include "math/spherical_harmonics.h"

#include <algorithm>
#include <cmath>

namespace torrance::brdf {
namespace {

constexpr int kNodes = 48; // of the polar angle; twice as many round the axis

/// Integral of f(local direction) over the sphere's part with z in [lowest, 1].
template <typename Function>
dvec3 integrateSphere(double lowest, const Function& f)
{
    static const QuadratureRule half = gaussLegendre(kNodes, 0.0, 1.0), whole = gaussLegendre(kNodes, -1.0, 1.0);
    const QuadratureRule& rule = lowest < 0.0 ? whole : half;
    dvec3 sum(0);
    for (std::size_t i = 0; i < rule.size(); ++i)
        for (int j = 0; j < 2 * kNodes; ++j) {
            const double z = rule.nodes[i], s = std::sqrt(1.0 - z * z), phi = kPi * (j + 0.5) / kNodes;
            sum += rule.weights[i] * f(dvec3(s * std::cos(phi), s * std::sin(phi), z));
        }
    return sum * (kPi / kNodes);
}

std::array<dvec3, 9> irradianceHarmonics(const EnvironmentQuery& query)
{
    constexpr std::array<int, 9> kBand = {0, 1, 1, 1, 2, 2, 2, 2, 2};
    std::array<dvec3, 9> harmonics;
    for (std::size_t i = 0; i < 9; ++i)
        harmonics[i] = integrateSphere(-1.0, [&](const dvec3& d) { return query.radiance(d) * shBasis(d)[i]; }) *
                       (clampedCosineBand(kBand[i]) / kPi);
    return harmonics;
}

dvec3 sumOf(const std::array<dvec3, 9>& harmonics, std::size_t count, const dvec3& n)
{
    const Sh9 basis = shBasis(n);
    dvec3 sum(0);
    for (std::size_t i = 0; i < count; ++i)
        sum += harmonics[i] * basis[i];
    return glm::max(sum, dvec3(0));
}

double alphaOf(const EnvironmentQuery& query)
{
    return std::max(query.perceptualRoughness * query.perceptualRoughness, kMinAlpha);
}

dvec3 albedoOf(const EnvironmentQuery& query)
{
    const AlbedoTerms terms = ggxAlbedo(std::clamp(glm::dot(query.n, query.v), 0.0, 1.0), query.perceptualRoughness);
    return query.f0 * terms.scale + terms.bias;
}

dvec3 splitSum(const EnvironmentQuery& query, const dvec3& direction)
{
    return ggxMean(query, direction, alphaOf(query)) * albedoOf(query);
}

/// The mean over the points of f(v, l) NoL L(l) / density(l); `draw` gives l, `density` is per steradian of it.
template <typename Draw, typename Density>
dvec3 estimate(const EnvironmentQuery& query, const Draw& draw, const Density& density)
{
    const dmat3 axes = frameAround(query.n);
    const dvec3 v = query.v * axes;
    dvec3 sum(0);
    for (int i = 0; i < query.samples; ++i) {
        const auto count = static_cast<std::uint32_t>(query.samples);
        const dvec3 l = draw(v, rotatedPoint(hammersley(static_cast<std::uint32_t>(i), count), query.rotation));
        const double p = l.z > 0 ? density(v, l) : 0;
        if (!(p > 0))
            continue;
        const ShadingPoint point = makeShadingPoint(dvec3(0, 0, 1), v, l, query.perceptualRoughness);
        const dvec3 fresnel = query.f0 + (dvec3(1) - query.f0) * fifthPower(point.oneLessVoH);
        sum += fresnel * query.radiance(axes * l) * (D_ggx(point) * V_smith_corr(point) * point.NoL / p);
    }
    return sum / static_cast<double>(query.samples);
}

dvec3 reflectedIn(const dvec3& v, const dvec3& h)
{
    return 2.0 * glm::dot(v, h) * h - v;
}

double visibleDensity(const dvec3& v, const dvec3& l, const dvec2& alpha)
{
    const dvec3 h = glm::normalize(v + l);
    return ggxVisibleNormalDensity(v, alpha, h) / (4.0 * glm::dot(v, h));
}

} // namespace

dvec3 Ed_irradiance_cube(const EnvironmentQuery& query)
{
    const dmat3 axes = frameAround(query.n);
    return integrateSphere(0.0, [&](const dvec3& d) { return query.radiance(axes * d) * d.z; }) / kPi;
}

dvec3 Ed_sampled(const EnvironmentQuery& query)
{
    return Ed_irradiance_cube(query);
}

dvec3 Ed_sh4(const EnvironmentQuery& query)
{
    return sumOf(irradianceHarmonics(query), 4, query.n);
}

dvec3 Ed_even(const EnvironmentQuery& query)
{
    return sumOf(irradianceHarmonics(query), 1, query.n);
}

dvec3 Ed_sh9(const EnvironmentQuery& query)
{
    return sumOf(irradianceHarmonics(query), 9, query.n);
}

dvec3 Ed_sh9_windowed(const EnvironmentQuery& query)
{
    return sumOf(windowedHarmonics(irradianceHarmonics(query)), 9, query.n);
}

dvec3 Es_even(const EnvironmentQuery& query)
{
    return Ed_even(query) * albedoOf(query);
}

dvec3 Es_split_sum(const EnvironmentQuery& query)
{
    return splitSum(query, mirrorDirection(query));
}

dvec3 Es_split_sum_dominant(const EnvironmentQuery& query)
{
    const double a = alphaOf(query), t = (1.0 - a) * (std::sqrt(1.0 - a) + a);
    return splitSum(query, query.n * (1.0 - t) + mirrorDirection(query) * t);
}

dvec3 Es_filtered_importance(const EnvironmentQuery& query)
{
    const dvec2 alpha(alphaOf(query));
    return estimate(
        query, [&](const dvec3& v, const dvec2& u) { return reflectedIn(v, sampleGgxNormal(alpha, u)); },
        [&](const dvec3& v, const dvec3& l) {
            const dvec3 h = glm::normalize(v + l);
            return ggxNormalDensity(alpha, h) * h.z / (4.0 * glm::dot(v, h));
        });
}

dvec3 Es_vndf(const EnvironmentQuery& query)
{
    const dvec2 alpha(alphaOf(query));
    return estimate(
        query, [&](const dvec3& v, const dvec2& u) { return reflectedIn(v, sampleGgxVisibleNormalHeitz(v, alpha, u)); },
        [&](const dvec3& v, const dvec3& l) { return visibleDensity(v, l, alpha); });
}

dvec3 Es_vndf_caps(const EnvironmentQuery& query)
{
    const dvec2 alpha(alphaOf(query));
    return estimate(
        query, [&](const dvec3& v, const dvec2& u) { return reflectedIn(v, sampleGgxVisibleNormal(v, alpha, u)); },
        [&](const dvec3& v, const dvec3& l) { return visibleDensity(v, l, alpha); });
}

dvec3 Es_vndf_bounded(const EnvironmentQuery& query)
{
    const dvec2 alpha(alphaOf(query));
    return estimate(
        query, [&](const dvec3& v, const dvec2& u) { return sampleGgxReflection(v, alpha, u); },
        [&](const dvec3& v, const dvec3& l) { return ggxReflectionDensity(v, alpha, l); });
}

// Written over the squares of both densities, where the device weighs by their ratio: f L N p / ((N p)^2 + (K q)^2) for
// directions, and f E (K q)^2 / ((K q)^2 + (N p)^2) for points of energy E.
dvec3 Es_vndf_lamps(const EnvironmentQuery& query)
{
    const dvec2 alpha(alphaOf(query));
    const dmat3 axes = frameAround(query.n);
    const dvec3 v = query.v * axes;
    const double directions = query.samples, points = static_cast<double>(query.lampPoints.size());
    const auto reflected = [&](const dvec3& l) {
        const ShadingPoint point = makeShadingPoint(dvec3(0, 0, 1), v, l, query.perceptualRoughness);
        const dvec3 fresnel = query.f0 + (dvec3(1) - query.f0) * fifthPower(point.oneLessVoH);
        return fresnel * (D_ggx(point) * V_smith_corr(point) * point.NoL);
    };
    dvec3 sum(0);
    for (int i = 0; i < query.samples; ++i) {
        const auto count = static_cast<std::uint32_t>(query.samples);
        const dvec3 l = sampleGgxReflection(
            v, alpha, rotatedPoint(hammersley(static_cast<std::uint32_t>(i), count), query.rotation));
        const double p = l.z > 0 ? directions * ggxReflectionDensity(v, alpha, l) : 0;
        if (!(p > 0))
            continue;
        const LampLight lamp = query.lamps ? query.lamps(axes * l) : LampLight();
        const dvec3 rest = query.radiance(axes * l) - lamp.radiance;
        const double q = points * lamp.density;
        sum += reflected(l) * (rest / p + lamp.radiance * (p / (p * p + q * q)));
    }
    for (const LampPoint& lamp : query.lampPoints) {
        const dvec3 l = lamp.direction * axes;
        if (l.z > 0 && lamp.density > 0) {
            const double p = directions * ggxReflectionDensity(v, alpha, l), q = points * lamp.density;
            sum += reflected(l) * lamp.energy * (q * q / (p * p + q * q));
        }
    }
    return sum;
}

int lampPointCount(int samples)
{
    return std::clamp(4 * samples, kLeastLampPoints, kMostLampPoints);
}

// The light of normals drawn from the lobe, weighed by NoL (Karis 2013, section "Pre-Filtered Environment Map"), with
// Gauss' nodes in place of random numbers: over those whose light is above the horizon, h.z^2 > 1/2, that is u.x < 1 /
// (1 + alpha^2).
dvec3 ggxMean(const EnvironmentQuery& query, const dvec3& direction, double alpha)
{
    static const QuadratureRule rule = gaussLegendre(kNodes, 0.0, 1.0);
    const dmat3 axes = frameAround(glm::normalize(direction));
    const double last = 1.0 / (1.0 + alpha * alpha);
    dvec3 sum(0);
    double weights = 0;
    for (std::size_t i = 0; i < rule.size(); ++i)
        for (int j = 0; j < 2 * kNodes; ++j) {
            const dvec3 h = sampleGgxNormal(dvec2(alpha), {last * rule.nodes[i], (j + 0.5) / (2 * kNodes)});
            const dvec3 l = 2.0 * h.z * h - dvec3(0, 0, 1);
            const double weight = l.z * rule.weights[i];
            sum += weight * query.radiance(axes * l);
            weights += weight;
        }
    return sum / weights;
}

dvec3 mirrorDirection(const EnvironmentQuery& query)
{
    return 2.0 * glm::dot(query.n, query.v) * query.n - query.v;
}

dvec3 Es_mirror(const EnvironmentQuery& query)
{
    return query.radiance(mirrorDirection(query));
}

bool hasLampPoints(const Method& environmentSpecular)
{
    return environmentSpecular.id == "vndf_lamps";
}

bool drawsSamples(const Method& environmentSpecular)
{
    constexpr std::string_view kLookUps[] = {"even",         "split_sum",  "split_sum_dominant",
                                             "phong_levels", "ggx_levels", "mirror"};
    return std::ranges::find(kLookUps, environmentSpecular.id) == std::end(kLookUps);
}

} // namespace torrance::brdf
