#include "study/pixel_cause.h"

#include "math/norm.h"
#include "math/scrambled_sequence.h"
#include "reference/light_integral.h"
#include "study/environment_parts.h"

#include <array>
#include <cmath>

namespace torrance {
namespace {

/// Turns of directions that an exact part is integrated with: one pixel, to a per cent of it or better.
constexpr std::uint32_t kTurns = 1024;

/// By how much a pixel would change if one slot were exact.
struct Correction
{
    brdf::Slot slot;
    dvec3 change = dvec3(0.0);
    const brdf::Method* method = nullptr; // of the nearest surface
};
using Corrections = std::array<Correction, 4>;

dvec3 integrated(const LightIntegral& integral, std::uint64_t key)
{
    return integral.sumOfTurns(hashNumbers({key}), 0, kTurns) / (double(kTurns) * kDirectionsPerTurn);
}

bool hasEnvironmentFormulas(const brdf::Preset& methods)
{
    const auto known = [](const brdf::Method* method) {
        return method && std::holds_alternative<brdf::EnvironmentFormula>(method->formula);
    };
    return brdf::isComposed(methods) && known(methods.environmentDiffuse) && known(methods.environmentSpecular);
}

void addEnvironment(const PixelEstimator& estimator, const Settings& settings, const VisibleSurface& seen, double share,
                    Corrections& corrections)
{
    const EnvironmentSampler* environment = estimator.surroundings();
    if (!environment || !hasEnvironmentFormulas(settings.methods) || seen.material.occlusion == 0.0)
        return;
    const auto exact = [&](ResponsePart part) {
        return integrated(LightIntegral(&settings.methods, environment, seen.material, seen.surface.view,
                                        DirectionChoice::combined, part),
                          static_cast<std::uint64_t>(part));
    };
    const auto parts = [&](AlbedoSource albedos) {
        return environmentParts(settings, *environment, seen.material, seen.surface.view, albedos);
    };
    const EnvironmentParts ideal = parts(AlbedoSource::exact);
    corrections[0].change += share * (exact(ResponsePart::body) - ideal.body);
    corrections[1].change += share * (exact(ResponsePart::lobe) - ideal.lobe);
    if (settings.methods.dfg->id == "table") // its formula is that of the exact integrals
        return;
    const EnvironmentParts fitted = parts(AlbedoSource::method);
    corrections[2].change += share * (ideal.body + ideal.lobe - fitted.body - fitted.lobe);
}

void addSpheres(const PixelEstimator& estimator, const Settings& settings, const VisibleSurface& seen, double share,
                Corrections& corrections)
{
    const auto* formula = std::get_if<brdf::AreaFormula>(&settings.methods.areaLight->formula);
    const dvec3 origin = estimator.rays().origin();
    for (const Light& light : estimator.rays().scene().lights) {
        if (!formula || light.kind == Light::Kind::directional || !(light.radius > 0.0))
            continue;
        const MaterialPoint& material = seen.material;
        brdf::AreaQuery query{settings.methods};
        query.surface =
            brdf::makeShadingPoint(material.normal, seen.surface.view, material.normal, material.perceptualRoughness);
        query.surface.baseColor = material.baseColor;
        query.surface.metallic = material.metallic;
        query.surface.ior = material.ior;
        query.toCenter = light.position - origin - seen.surface.position;
        query.radius = light.radius;
        query.intensity =
            sampleLight(light, origin, seen.surface.position).irradiance * glm::dot(query.toCenter, query.toCenter);
        query.samples = settings.lightSamples;
        const LightIntegral exact(&settings.methods, SphereLight(light, origin, seen.surface.position), material,
                                  seen.surface.view, DirectionChoice::combined);
        corrections[3].change += share * (integrated(exact, 0) - (*formula)(query));
    }
}

// As Settings::ofMaterials counts.
int numberOf(const Scene& scene, const VisibleSurface& seen)
{
    return seen.surface.material < 0 ? static_cast<int>(scene.materials.size()) : seen.surface.material;
}

} // namespace

PixelCause pixelCause(const PixelEstimator& estimator, const Settings& settings, int x, int y, const dvec3& drawn,
                      const dvec3& exact)
{
    const Scene& scene = estimator.rays().scene();
    Corrections corrections = {Correction{brdf::Slot::environmentDiffuse},
                               {brdf::Slot::environmentSpecular},
                               {brdf::Slot::dfg},
                               {brdf::Slot::areaLight}};
    const std::vector<dvec2> offsets = sampleOffsets(settings.samples);
    for (const dvec2& offset : offsets)
        for (const VisibleSurface& seen : estimator.surfacesAt(dvec2(x + 0.5, y + 0.5) + offset, {x, y}).surfaces) {
            if (seen.material.unlit)
                continue;
            const double share = seen.share / double(offsets.size());
            const Settings own = withLightMethods(settings, lightMethodsOf(settings, numberOf(scene, seen)));
            addEnvironment(estimator, own, seen, share, corrections);
            addSpheres(estimator, own, seen, share, corrections);
            for (Correction& correction : corrections)
                if (!correction.method)
                    correction.method = own.methods[correction.slot];
        }
    const double whole = norm1(drawn - exact);
    PixelCause cause = {.slot = "surface", .method = "", .share = 0.0};
    double best = kLeastShare;
    for (const Correction& correction : corrections) {
        const double share = 1.0 - norm1(drawn + correction.change - exact) / whole;
        if (whole > 0.0 && share >= best) {
            best = share;
            cause = {std::string(brdf::slotName(correction.slot)), std::string(correction.method->id), share};
        }
    }
    return cause;
}

} // namespace torrance
