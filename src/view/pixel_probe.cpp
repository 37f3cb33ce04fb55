#include "view/pixel_probe.h"

#include "brdf/brdf.h"
#include "brdf/lobe_albedo.h"
#include "measure/image_metrics.h"
#include "passes/probe_pass.h"
#include "reference/pixel_estimate.h"
#include "reference/punctual_light.h"
#include "study/certificate.h"
#include "study/rounded_point.h"
#include "view/mean_norm.h"

#include <array>

namespace torrance {
namespace {

using brdf::Slot;

// Towards the light whose terms are shown: the first that shines here, or the mirror image of the view.
dvec3 lightDirection(const Scene& scene, const dvec3& origin, const VisibleSurface& seen, PixelProbe& probe)
{
    for (const Light& light : scene.lights) {
        const LightSample sample = sampleLight(light, origin, seen.surface.position);
        if (sample.irradiance == dvec3(0.0) || glm::dot(sample.direction, seen.material.normal) <= 0.0)
            continue;
        probe.light = light.name.empty() ? "the first light that shines here" : light.name;
        return sample.direction;
    }
    probe.light = "the mirror image of the view";
    return glm::reflect(-seen.surface.view, seen.material.normal);
}

brdf::ShadingPoint shadingPointOf(const brdf::Preset& preset, const MaterialPoint& material, const dvec3& view,
                                  const dvec3& light)
{
    brdf::ShadingPoint point = brdf::makeShadingPoint(material.normal, view, light, material.perceptualRoughness);
    point.baseColor = material.baseColor;
    point.metallic = material.metallic;
    point.ior = material.ior;
    point.f0 = brdf::evaluateTerms(preset, point).F0;
    return point;
}

std::vector<ProbedTerm> probeTerms(const gpu::Device& device, gpu::ShaderLibrary& shaders, const brdf::Preset& preset,
                                   const brdf::ShadingPoint& point)
{
    std::vector<ProbedTerm> terms;
    for (const Slot slot : {Slot::distribution, Slot::visibility, Slot::fresnel, Slot::diffuse, Slot::diffuseWeight,
                            Slot::multipleScattering, Slot::model})
    {
        const brdf::Method* method = preset[slot];
        if (!method)
            continue; // the model has a term of its own
        const ProbeTerm term = slot == Slot::model ? makeBrdfTerm(preset) : makeProbeTerm(*method);
        brdf::ShadingPoint at = point;
        if (term.readsInterface)
            brdf::setInterface(at);
        else if (term.readsAlbedo)
            brdf::setLobeAlbedo(at);
        at = materialRounded(at, gpu::Precision::fp32); // both sides are given the same numbers
        terms.push_back({.slot = slot,
                         .id = method->id,
                         .device = probe(device, shaders, term, std::span(&at, 1)).front(),
                         .exact = term.formula(at)});
    }
    return terms;
}

} // namespace

std::optional<PixelProbe> probePixel(const gpu::Device& device, gpu::ShaderLibrary& shaders, const Scene& scene,
                                     const Camera& camera, const Settings& settings, const Image& drawn,
                                     const ivec2& pixel)
{
    requireCertifiable(scene, settings);
    const ReferenceSettings exact = exactSettings(settings, {});
    const PixelEstimator estimator(scene, camera, exact);
    const VisibleSurfaces seen = estimator.surfacesAt(dvec2(pixel) + 0.5, pixel);
    if (seen.surfaces.empty())
        return std::nullopt;
    const VisibleSurface& nearest = seen.surfaces.front();
    const float* texel = drawn.at(pixel.x, pixel.y);
    PixelProbe result;
    result.pixel = pixel;
    result.drawn = {texel[0], texel[1], texel[2]};
    const Replicates truth = estimator.replicates(pixel.x, pixel.y, kProbeDirections, exact.seed).colors;
    result.exact = truth.mean();
    result.error = relativeError(pixelError(result.drawn, truth), kPixelFloor * coveredMeanNorm(estimator, drawn));
    if (result.error.low > 0.0)
        result.cause = pixelCause(estimator, settings, pixel.x, pixel.y, result.drawn, result.exact);
    result.surface = nearest.material;
    result.NoV = glm::dot(nearest.material.normal, nearest.surface.view);
    result.material = materialOf(scene, nearest.surface.material).name;
    if (nearest.material.unlit)
        return result;
    const dvec3 light = lightDirection(scene, estimator.rays().origin(), nearest, result);
    result.terms = probeTerms(device, shaders, settings.methods,
                              shadingPointOf(settings.methods, nearest.material, nearest.surface.view, light));
    return result;
}

} // namespace torrance
