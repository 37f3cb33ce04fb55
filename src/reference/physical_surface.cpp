#include "reference/physical_surface.h"

#include "brdf/diffuse.h"
#include "brdf/distribution.h"
#include "brdf/visibility.h"
#include "core/parallel.h"

#include <algorithm>
#include <cmath>

namespace torrance {
namespace {

constexpr int kCosines = 33;
constexpr int kRoughnesses = 17;
constexpr int kWalks = 4096; // a node is within 0.3 % of the incoming light

/// Nodes crowd at grazing, where the albedo turns.
double cosineOfNode(int i)
{
    const double x = std::max(i, 1) / double(kCosines - 1); // the last one before 0 stands for the limit too
    return x * x;
}

double alphaOf(double perceptualRoughness)
{
    return std::max(perceptualRoughness * perceptualRoughness, brdf::kMinAlpha);
}

double albedoByWalks(double NoV, double alpha, double ior, std::uint64_t key)
{
    const dvec3 v(std::sqrt(1.0 - NoV * NoV), 0.0, NoV);
    const brdf::FacetInterface facets = {.ior = ior};
    double sum = 0.0;
    for (std::uint64_t i = 0; i < kWalks; ++i) {
        NumberStream numbers((key << 32) + i * 0x632be59bd9b4e019u);
        sum += brdf::walkAlbedo(v, alpha, facets, numbers).a;
    }
    return sum / kWalks;
}

struct Place
{
    int low;
    double fraction;
};

Place placeOf(double x, int nodes)
{
    const double scaled = std::clamp(x, 0.0, 1.0) * (nodes - 1);
    const int low = std::min(static_cast<int>(scaled), nodes - 2);
    return {low, scaled - low};
}

} // namespace

InterfaceAlbedo::InterfaceAlbedo(double ior) : index(ior), nodes(kCosines * kRoughnesses), averages(kRoughnesses)
{
    parallelFor(nodes.size(), 1, [&](std::size_t i) {
        const int cosine = static_cast<int>(i) % kCosines, roughness = static_cast<int>(i) / kCosines;
        nodes[i] = albedoByWalks(cosineOfNode(cosine), alphaOf(roughness / double(kRoughnesses - 1)), ior, i);
    });
    // 2 E mu dmu with mu = x^2: 4 E x^3 dx, by the trapezoidal rule over the nodes in x
    for (int roughness = 0; roughness < kRoughnesses; ++roughness)
        for (int i = 1; i < kCosines; ++i) {
            const double x = i / double(kCosines - 1), end = i == kCosines - 1 ? 0.5 : 1.0;
            averages[static_cast<std::size_t>(roughness)] +=
                end * 4.0 * x * x * x * node(i, roughness) / double(kCosines - 1);
        }
}

double InterfaceAlbedo::node(int cosine, int roughness) const
{
    return nodes[static_cast<std::size_t>(roughness * kCosines + cosine)];
}

double InterfaceAlbedo::at(double NoV, double perceptualRoughness) const
{
    const Place c = placeOf(std::sqrt(std::clamp(NoV, 0.0, 1.0)), kCosines),
                r = placeOf(perceptualRoughness, kRoughnesses);
    const auto row = [&](int roughness) {
        return std::lerp(node(c.low, roughness), node(c.low + 1, roughness), c.fraction);
    };
    return std::lerp(row(r.low), row(r.low + 1), r.fraction);
}

double InterfaceAlbedo::average(double perceptualRoughness) const
{
    const Place r = placeOf(perceptualRoughness, kRoughnesses);
    const auto low = static_cast<std::size_t>(r.low);
    return std::lerp(averages[low], averages[low + 1], r.fraction);
}

PhysicalSurface::PhysicalSurface(const InterfaceAlbedo& a, const MaterialPoint& material)
    : albedo(a), baseColor(glm::clamp(material.baseColor, dvec3(0.0), dvec3(1.0))), metallic(material.metallic),
      perceptualRoughness(material.perceptualRoughness)
{
    const dvec3 reflectance = glm::min(baseColor, dvec3(kMostReflectance));
    facets.k = 2.0 * glm::sqrt(reflectance / (1.0 - reflectance));
    facets.ior = a.ior();
}

dvec3 PhysicalSurface::response(const dvec3& v, const dvec3& l, NumberStream& numbers) const
{
    brdf::ShadingPoint point = brdf::makeShadingPoint(dvec3(0, 0, 1), v, l, perceptualRoughness);
    if (!(point.NoV > 0.0) || !(point.NoL > 0.0))
        return dvec3(0.0);
    point.baseColor = baseColor;
    const double once = brdf::D_ggx(point) * brdf::V_smith_corr(point) * point.NoL;
    const dvec4 specular = once * brdf::facetReflectance(facets, point.VoH) +
                           brdf::walkResponse(point.v, point.l, point.alpha, facets, 2, numbers);
    const double left = (1.0 - albedo.at(point.NoV, perceptualRoughness)) *
                        (1.0 - albedo.at(point.NoL, perceptualRoughness)) / (1.0 - albedo.average(perceptualRoughness));
    const dvec3 dielectric = brdf::Fd_eon(point) * (left * point.NoL) + specular.a;
    return dielectric * (1.0 - metallic) + dvec3(specular) * metallic;
}

} // namespace torrance
