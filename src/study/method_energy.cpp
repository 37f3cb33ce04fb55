#include "study/method_energy.h"

#include "brdf/brdf.h"
#include "brdf/distribution.h"
#include "brdf/lobe_albedo.h"
#include "math/quadrature.h"
#include "passes/probe_term.h"
#include "study/method_sweep.h"

#include <algorithm>
#include <cmath>

namespace torrance {
namespace {

using brdf::Method;
using brdf::ShadingPoint;
using brdf::Slot;

constexpr dvec3 kNormal = dvec3(0, 0, 1);
constexpr int kAngles = 256;
constexpr int kAzimuths = 32; // of half a turn: the other half mirrors it

double greatest(const dvec3& value)
{
    return std::max({value.x, value.y, value.z});
}

// Mean over half vectors that are distributed as D ggx, of weight(h): tan^2 = a^2 u / (1 - u), u even on [0, 1].
// u = s^2 (3 - 2 s): square roots at both ends become smooth.
// `lastAzimuth`, of cos and sin of the angle to n, bounds the azimuths at which there is anything.
template <typename Weight, typename Limit>
double meanOverFacets(double alpha, const Limit& lastAzimuth, const Weight& weight)
{
    static const QuadratureRule shares = gaussLegendre(kAngles, 0.0, 1.0);
    static const QuadratureRule turns = gaussLegendre(kAzimuths, 0.0, 1.0);
    return integrate(shares, [&](double s) {
        const double tangent2 = alpha * alpha * s * s * (3 - 2 * s) / ((1 - s) * (1 - s) * (1 + 2 * s));
        const double cosine = 1 / std::sqrt(1 + tangent2), sine = std::sqrt(tangent2) * cosine;
        const double last = lastAzimuth(cosine, sine);
        return 6 * s * (1 - s) * last / kPi * integrate(turns, [&](double turn) {
                   const double azimuth = last * turn;
                   return weight(dvec3(sine * std::cos(azimuth), sine * std::sin(azimuth), cosine));
               });
    });
}

double alphaOf(double r)
{
    return brdf::makeShadingPoint(kNormal, kNormal, kNormal, r).alpha;
}

double facetArea(const ProbeTerm& term, double r)
{
    const auto everywhere = [](double, double) { return kPi; };
    return meanOverFacets(alphaOf(r), everywhere, [&](const dvec3& h) {
        const ShadingPoint point = brdf::makeShadingPoint(kNormal, h, h, r);
        return term.formula(point).x / brdf::D_ggx(point);
    });
}

// f NoL dl, with dl = 4 VoH dh and D ggx dh = (even measure) / NoH, of f over D ggx. Light is above the surface where
// 2 VoH NoH > NoV.
template <typename Lobe>
double lobeReturn(const dvec3& v, double r, const Lobe& overGgx)
{
    const auto horizon = [&](double cosine, double sine) {
        const double needed = v.z * (0.5 / cosine - cosine);
        return v.x * sine > 0 ? std::acos(std::clamp(needed / (v.x * sine), -1.0, 1.0)) : (needed < 0 ? kPi : 0.0);
    };
    return meanOverFacets(alphaOf(r), horizon, [&](const dvec3& h) {
        const double VoH = glm::dot(v, h);
        const ShadingPoint point = brdf::makeShadingPoint(kNormal, v, 2 * VoH * h - v, r);
        return point.NoL > 0 ? overGgx(point) * point.NoL * 4 * VoH / h.z : 0.0;
    });
}

// f NoL dl over the hemisphere, for an f without a highlight.
template <typename Lobe>
double diffuseReturn(const dvec3& v, double r, const Lobe& f)
{
    static const QuadratureRule cosines = gaussLegendre(kAngles, 0.0, 1.0);
    double sum = 0;
    for (int i = 0; i < kAzimuths; ++i) {
        const double azimuth = kPi * (i + 0.5) / kAzimuths;
        sum += integrate(cosines, [&](double NoL) {
            const double sine = std::sqrt((1 - NoL) * (1 + NoL));
            ShadingPoint point =
                brdf::makeShadingPoint(kNormal, v, {sine * std::cos(azimuth), sine * std::sin(azimuth), NoL}, r);
            point.baseColor = dvec3(1);
            return f(point) * NoL;
        });
    }
    return sum * 2 * kPi / kAzimuths;
}

// A model is judged in the plainest preset that has it.
const brdf::Preset& presetOf(const Method& model)
{
    return model.id == "gltf" ? *brdf::findPreset("gltf")
                              : *std::ranges::find(brdf::allPresets(), &model, &brdf::Preset::model);
}

// Highlight and diffuse part apart, each by the rule that resolves it; their cosine is the model's own.
double modelReturn(const Method& model, const dvec3& v, double r, double metallic)
{
    const brdf::Preset& preset = presetOf(model);
    const auto part = [&](ShadingPoint point, dvec3 brdf::BrdfTerms::*which) {
        point.baseColor = dvec3(1);
        point.metallic = metallic;
        const brdf::BrdfTerms terms = brdf::evaluateTerms(preset, point);
        return greatest(terms.*which) * terms.weight / point.NoL;
    };
    const double highlight = lobeReturn(
        v, r, [&](const ShadingPoint& point) { return part(point, &brdf::BrdfTerms::specular) / brdf::D_ggx(point); });
    return highlight +
           diffuseReturn(v, r, [&](const ShadingPoint& point) { return part(point, &brdf::BrdfTerms::diffuse); });
}

// Of a white metal in the furnace, where every argument is its own mean over light from all sides: light reflected once
// E, a Lambertian surface's 1, E at the light EAverage.
double compensatedReturn(const ProbeTerm& term, double NoV, double r)
{
    ShadingPoint point = mirrorPoint(NoV, r);
    point.f0 = dvec3(1);
    brdf::setLobeAlbedo(point);
    point.single = dvec3(point.E);
    point.spread = dvec3(1);
    point.ELight = point.EAverage;
    return greatest(term.formula(point));
}

double tableReturn(const ProbeTerm& term, double NoV, double r)
{
    const dvec3 terms = term.formula(mirrorPoint(NoV, r));
    return terms.x + terms.y;
}

// Whoever computes f(l, v) has E at NoL.
ShadingPoint reversed(const ShadingPoint& point)
{
    ShadingPoint back = brdf::makeShadingPoint(point.n, point.l, point.v, point.perceptualRoughness);
    back.f0 = point.f0;
    back.baseColor = point.baseColor;
    return back;
}

std::vector<ShadingPoint> reciprocityPoints(Slot slot, double NoV, double r)
{
    if (!readsInterface(slot))
        return sweepPoints(slot, NoV, r, gpu::Precision::fp64);
    ShadingPoint point = brdf::makeShadingPoint(kNormal, {std::sqrt(1 - NoV * NoV), 0, NoV}, {0, 0.8, 0.6}, r);
    point.f0 = dvec3(1);
    return {point};
}

} // namespace

std::optional<double> returnedEnergy(const Method& method, double NoV, double r)
{
    if (!canSweep(method))
        return std::nullopt;
    const ProbeTerm term = makeProbeTerm(method);
    const dvec3 v = mirrorPoint(NoV, r).v;
    switch (method.slot) {
    case Slot::distribution:
        return facetArea(term, r);
    case Slot::visibility:
        return lobeReturn(v, r, [&](const ShadingPoint& point) { return term.formula(point).x; });
    case Slot::model:
        return std::max(modelReturn(method, v, r, 0.0), modelReturn(method, v, r, 1.0));
    case Slot::diffuse:
    case Slot::sheen:
        return diffuseReturn(v, r, [&](const ShadingPoint& point) { return greatest(term.formula(point)); });
    case Slot::multipleScattering:
        return compensatedReturn(term, NoV, r);
    case Slot::dfg:
        return tableReturn(term, NoV, r);
    default:
        return std::nullopt;
    }
}

std::optional<double> reciprocityError(const Method& method, double NoV, double r)
{
    const Slot slot = method.slot;
    if (slot != Slot::model && slot != Slot::distribution && slot != Slot::visibility && slot != Slot::diffuse &&
        slot != Slot::sheen && !readsInterface(slot))
        return std::nullopt;
    const ProbeTerm term = makeProbeTerm(method);
    double worst = 0;
    for (ShadingPoint point : reciprocityPoints(slot, NoV, r)) {
        ShadingPoint back = reversed(point);
        if (readsInterface(slot))
            for (ShadingPoint* one : {&point, &back})
                brdf::setInterface(*one);
        const dvec3 there = term.formula(point), again = term.formula(back);
        for (int channel = 0; channel < 3; ++channel)
            if (const double size = std::max(std::abs(there[channel]), std::abs(again[channel])); size > 0)
                worst = std::max(worst, std::abs(there[channel] - again[channel]) / size);
    }
    return worst;
}

} // namespace torrance
