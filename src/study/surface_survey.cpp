#include "study/surface_survey.h"

#include "brdf/albedo.h"
#include "math/latlong.h"
#include "math/norm.h"
#include "reference/punctual_light.h"
#include "reference/shade.h"
#include "scene/phong.h"

#include <algorithm>
#include <cmath>

namespace torrance {
namespace {

dvec3 meanRadiance(const Scene& scene)
{
    if (!scene.environment)
        return dvec3(0.0);
    const Image& panorama = scene.environment->radiance;
    dvec3 sum(0.0);
    for (int y = 0; y < panorama.height; ++y) {
        dvec3 row(0.0);
        for (int x = 0; x < panorama.width; ++x) {
            const float* texel = panorama.at(x, y);
            row += dvec3(texel[0], texel[1], texel[2]);
        }
        sum += row * latLongTexelSolidAngle(y, panorama.width, panorama.height);
    }
    return sum * (scene.environment->intensity / (4.0 * kPi));
}

/// What a surface sends, by its ways.
struct Sent
{
    double body = 0.0, lobe = 0.0, spheres = 0.0, rest = 0.0;
    double all() const { return body + lobe + spheres + rest; }
};

Sent lightOf(const Scene& scene, const brdf::Preset& methods, const dvec3& even, const dvec3& origin,
             const VisibleSurface& seen)
{
    const MaterialPoint& m = seen.material;
    Sent light;
    light.rest = norm1(m.unlit ? m.baseColor : m.emissive);
    if (m.unlit)
        return light;
    const double NoV = std::clamp(glm::dot(m.normal, seen.surface.view), 0.0, 1.0);
    const brdf::AlbedoTerms terms = brdf::ggxAlbedo(NoV, m.perceptualRoughness);
    const double f0 = reflectanceOfIor(m.ior);
    const auto reflected = [&](const dvec3& reflectance) { return reflectance * terms.scale + terms.bias; };
    light.lobe =
        m.occlusion * norm1(even * (reflected(dvec3(f0)) * (1.0 - m.metallic) + reflected(m.baseColor) * m.metallic));
    light.body = m.occlusion * norm1(even * m.baseColor) * (1.0 - m.metallic) * (1.0 - f0) *
                 (1.0 - brdf::schlickDiffuseWeight(NoV));
    for (const torrance::Light& lamp : scene.lights) {
        const double sent =
            norm1(shadePunctual(methods, m, seen.surface.view, sampleLight(lamp, origin, seen.surface.position)));
        (lamp.radius > 0.0 ? light.spheres : light.rest) += sent;
    }
    return light;
}

} // namespace

std::vector<SeenSurface> surveySurfaces(const PixelEstimator& estimator, const brdf::Preset& methods,
                                        std::span<const CoveredPixel> pixels)
{
    const Scene& scene = estimator.rays().scene();
    const dvec3 even = meanRadiance(scene), origin = estimator.rays().origin();
    std::vector<SeenSurface> surfaces;
    double all = 0.0;
    for (const CoveredPixel& pixel : pixels)
        for (const VisibleSurface& seen :
             estimator.surfacesAt({pixel.x + 0.5, pixel.y + 0.5}, {pixel.x, pixel.y}).surfaces) {
            const Sent light = lightOf(scene, methods, even, origin, seen);
            const MaterialPoint& m = seen.material;
            const dvec3 f0 = dvec3(reflectanceOfIor(m.ior)) * (1.0 - m.metallic) + m.baseColor * m.metallic;
            all += seen.share * light.all();
            surfaces.push_back({.perceptualRoughness = m.perceptualRoughness,
                                .NoV = glm::dot(m.normal, seen.surface.view),
                                .f0 = norm1(f0) / 3.0,
                                .body = seen.share * light.body,
                                .lobe = seen.share * light.lobe,
                                .spheres = seen.share * light.spheres});
        }
    for (SeenSurface& surface : surfaces)
        for (double* share : {&surface.body, &surface.lobe, &surface.spheres})
            *share = all > 0.0 ? *share / all : 0.0;
    return surfaces;
}

} // namespace torrance
