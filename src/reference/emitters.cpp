#include "reference/emitters.h"

#include "core/parallel.h"
#include "math/guided_choice.h"
#include "math/low_discrepancy.h"
#include "reference/emission.h"
#include "reference/off_surface.h"

#include <algorithm>
#include <cmath>

namespace torrance {
namespace {

/// Places of a triangle whose emission is averaged where a texture or colours let it vary.
constexpr int kPlaces = 16;

bool mayEmit(const Material& material)
{
    const dvec3 color = material.unlit ? dvec3(material.baseColorFactor) : material.emissiveFactor;
    return color != dvec3(0.0);
}

bool variesWithin(const Material& material, const Primitive& primitive)
{
    const bool byAlpha = material.alphaMode != AlphaMode::opaque;
    return material.emissive.used() ||
           ((material.unlit || byAlpha) && (material.baseColor.used() || !primitive.colors.empty()));
}

/// Even over the triangle: Turk, Graphics Gems 1990, "Generating Random Points in Triangles".
dvec3 evenBarycentric(const dvec2& u)
{
    const double root = std::sqrt(u.x);
    return {1.0 - root, root * (1.0 - u.y), root * u.y};
}

/// A point of a triangle, looked at along `direction`.
SurfacePoint pointOf(const RayCaster& caster, Hit& hit, const std::array<dvec3, 3>& corners, const dvec3& direction)
{
    const dmat3 matrix(caster.scene().instances[static_cast<std::size_t>(hit.instance)].worldFromObject);
    const dvec3 front = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    hit.front = (glm::dot(front, direction) < 0.0) == (glm::determinant(matrix) >= 0.0);
    return makeSurfacePoint(caster, {dvec3(0.0), direction}, hit);
}

dvec3 emissionOf(const RayCaster& caster, const SurfacePoint& surface)
{
    const MaterialPoint material = makeMaterialPoint(caster.scene(), surface);
    return material.alpha * emittedRadiance(caster.scene(), surface, material);
}

/// The mean of the brightest channel, of the front.
double meanEmission(const RayCaster& caster, int instance, int triangle, int places)
{
    Hit hit;
    hit.instance = instance;
    hit.triangle = triangle;
    const std::array<dvec3, 3> corners = triangleCorners(caster.scene(), instance, triangle, caster.origin());
    const dmat3 matrix(caster.scene().instances[static_cast<std::size_t>(instance)].worldFromObject);
    const dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const dvec3 into = (glm::determinant(matrix) < 0.0 ? 1.0 : -1.0) * normal / glm::length(normal);
    double sum = 0.0;
    for (int i = 0; i < places; ++i) {
        const dvec2 u = hammersley(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(places));
        hit.barycentric = places == 1 ? dvec3(1.0 / 3.0) : evenBarycentric(u);
        const dvec3 emission = emissionOf(caster, pointOf(caster, hit, corners, into));
        sum += std::max({emission.r, emission.g, emission.b});
    }
    return sum / places;
}

double areaOf(const std::array<dvec3, 3>& corners)
{
    return 0.5 * glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
}

} // namespace

Emitters::Emitters(const RayCaster& rays) : caster(rays), radiosities(rays.scene().instances.size())
{
    const Scene& scene = caster.scene();
    double total = 0.0;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Primitive& primitive = scene.primitives[static_cast<std::size_t>(scene.instances[i].primitive)];
        const Material& material = materialOf(scene, primitive.material);
        if (primitive.topology != Topology::triangles || !mayEmit(material))
            continue;
        std::vector<double>& perArea = radiosities[i];
        perArea.resize(primitive.indices.size() / 3);
        const int places = variesWithin(material, primitive) ? kPlaces : 1;
        std::vector<double> areas(perArea.size());
        parallelFor(perArea.size(), 64, [&](std::size_t t) {
            areas[t] = areaOf(triangleCorners(scene, static_cast<int>(i), static_cast<int>(t), caster.origin()));
            if (areas[t] > 0.0 && std::isfinite(areas[t]))
                perArea[t] = meanEmission(caster, static_cast<int>(i), static_cast<int>(t), places);
        });
        for (std::size_t t = 0; t < perArea.size(); ++t) {
            if (!(perArea[t] > 0.0))
                continue;
            total += perArea[t] * areas[t];
            triangles.push_back({static_cast<int>(i), static_cast<int>(t)});
            sums.push_back(total);
        }
    }
    guide.resize(sums.size());
    if (!dark())
        makeGuide(sums, guide);
}

double Emitters::inSolidAngle(const Hit& hit, const SurfacePoint& surface) const
{
    const double cosine = std::abs(glm::dot(surface.geometricNormal, surface.view));
    const std::vector<double>& perArea = radiosities[static_cast<std::size_t>(hit.instance)];
    return perArea[static_cast<std::size_t>(hit.triangle)] / sums.back() * hit.distance * hit.distance / cosine;
}

double Emitters::density(const Hit& hit, const SurfacePoint& surface) const
{
    if (dark() || hit.instance < 0)
        return 0.0;
    const std::vector<double>& perArea = radiosities[static_cast<std::size_t>(hit.instance)];
    if (perArea.empty() || perArea[static_cast<std::size_t>(hit.triangle)] == 0.0)
        return 0.0;
    return inSolidAngle(hit, surface);
}

std::optional<EmitterSample> Emitters::draw(const dvec3& from, double choice, const dvec2& u) const
{
    const Triangle& triangle = triangles[choose(sums, guide, choice).index];
    Hit hit;
    hit.instance = triangle.instance;
    hit.triangle = triangle.index;
    hit.barycentric = evenBarycentric(u);
    const std::array<dvec3, 3> corners = triangleCorners(caster.scene(), hit.instance, hit.triangle, caster.origin());
    const dvec3 place =
        hit.barycentric[0] * corners[0] + hit.barycentric[1] * corners[1] + hit.barycentric[2] * corners[2];
    hit.distance = glm::length(place - from);
    if (!(hit.distance > 0.0))
        return std::nullopt;
    EmitterSample sample;
    sample.direction = (place - from) / hit.distance;
    const SurfacePoint surface = pointOf(caster, hit, corners, sample.direction);
    sample.light = {emissionOf(caster, surface), inSolidAngle(hit, surface)};
    if (sample.light.radiance == dvec3(0.0) || !std::isfinite(sample.light.density))
        return std::nullopt;
    sample.target = offSurface(caster.origin(), surface.position, surface.geometricNormal);
    return sample;
}

} // namespace torrance
