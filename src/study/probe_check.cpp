#include "study/probe_check.h"

#include "brdf/condition.h"
#include "brdf/dfg.h"
#include "brdf/lobe_albedo.h"
#include "core/parallel.h"
#include "study/probe_grid.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace torrance {
namespace {

using namespace brdf;

constexpr double kRounding = 0x1p-24;

// What is left of a double after the device has been given it. volatile: g++ 12 drops the rounding of two neighbouring
// doubles to float and back when it vectorises straight-line code (-ftree-slp-vectorize, part of -O2).
double asFloat(double x)
{
    const volatile float rounded = static_cast<float>(x);
    return rounded;
}

dvec3 asFloat(const dvec3& x)
{
    return {asFloat(x.x), asFloat(x.y), asFloat(x.z)};
}

// The point whose scalars are those that the device sees: both sides then compute from the same numbers.
ShadingPoint scalarsRounded(ShadingPoint p)
{
    for (double* scalar :
         {&p.NoV, &p.NoL, &p.VoL, &p.NoH, &p.VoH, &p.oneLessVoH, &p.sin2H, &p.ToH, &p.BoH, &p.perceptualRoughness,
          &p.alpha, &p.alphaT, &p.alphaB, &p.ior, &p.metallic, &p.E, &p.bias, &p.ELight, &p.EAverage})
        *scalar = asFloat(*scalar);
    for (dvec3* color : {&p.f0, &p.f90, &p.eta, &p.k, &p.f82, &p.baseColor, &p.single, &p.spread, &p.F, &p.FNoV,
                         &p.FNoL, &p.lobeAlbedo})
        *color = asFloat(*color);
    return p;
}

// Of the worst channel, relative to the value, or to `terms` where that is more. A device may flush to zero what lies
// below the least normal float, be it the value or a term of it: that much is forgiven.
double relativeError(const vec3& device, const dvec3& exact, const dvec3& terms)
{
    double worst = 0;
    for (int channel = 0; channel < 3; ++channel) {
        const double d = device[channel], c = exact[channel];
        if (!std::isfinite(d) || !std::isfinite(c))
            return INFINITY;
        const double size = std::max({std::abs(c), terms[channel], static_cast<double>(FLT_MIN)});
        if (std::abs(d - c) > FLT_MIN)
            worst = std::max(worst, (std::abs(d - c) - FLT_MIN) / size);
    }
    return worst;
}

// The greater term of a formula that is a difference and can pass through 0, where no float is relatively right.
// f82, lazanyi: Schlick's reflectance here, or what they take of it at the cosine 1/7. chan: the body that a negative
// bump is added to.
dvec3 termsOf(const Method& method, const ShadingPoint& p)
{
    const auto larger = [&](const dvec3& f0, const dvec3& slope) {
        const double dip = p.VoH * std::pow(p.oneLessVoH, 6) * std::pow(7.0, 7) / std::pow(6.0, 6);
        return glm::max(f0 + slope * std::pow(p.oneLessVoH, 5), (f0 + slope * std::pow(6.0 / 7.0, 5)) * dip);
    };
    if (method.slot == Slot::fresnel && method.id == "f82")
        return larger(p.f0, p.f90 - p.f0);
    if (method.slot == Slot::fresnel && method.id == "lazanyi") {
        const dvec3 slope = 4.0 * p.eta / ((p.eta + 1.0) * (p.eta + 1.0) + p.k * p.k);
        return larger(dvec3(1) - slope, slope);
    }
    if (method.slot == Slot::diffuse && method.id == "chan")
        return p.baseColor * (0.25 * 0.25 / kPi); // the least body: both cosines 0
    return dvec3(0);
}

// 5e-6: forty roundings of 2^-23; every formula has fewer operations on its path than that. The textbook's D is the
// exception that it is kept for: three roundings of its cancelling sum d, 6 * 2^-24 in D for d near 1, grow as 1/d (and
// beyond first order where d is mostly rounding: there it is only asked to be finite).
double allowedFor(const Method& method, const ShadingPoint& p)
{
    if (method.id != "ggx_textbook")
        return 5e-6;
    const double growth = 1.0 / (p.NoH * p.NoH * (p.alpha * p.alpha - 1.0) + 1.0);
    return growth * kRounding > 0.01 ? DBL_MAX : 5e-6 + 6 * kRounding * growth;
}

// The vectors are rounded to float on their way to the device, the double formula sees them whole: kappa 2^-24 is what
// that alone can make of them, and as much again is for the arithmetic. Below r = 0.02 the highlight is narrower than
// the device's arithmetic on v + l resolves well.
double allowedForVectors(const ProbeTerm& term, const ShadingPoint& p)
{
    const double factor = p.perceptualRoughness < 0.02 ? 8 : 2;
    return 2e-6 + factor * conditionNumber(term.formula, p) * kRounding;
}

std::vector<ShadingPoint> rowsFor(const ProbeTerm& term)
{
    std::vector<ShadingPoint> rows = probeGrid();
    constexpr std::size_t kPart = 53; // an exact albedo takes a millisecond's fraction, and kappa asks for twenty
    if (term.readsAlbedo) {
        std::vector<ShadingPoint> part;
        for (std::size_t i = 0; i < rows.size(); i += kPart) {
            part.push_back(rows[i]);
            setLobeAlbedo(part.back());
        }
        rows = part;
    }
    for (ShadingPoint& row : rows) // kappa speaks of directions and roughness only
    {
        row.baseColor = asFloat(row.baseColor);
        row.metallic = asFloat(row.metallic);
        row.ior = asFloat(row.ior);
    }
    return rows;
}

// The table is linear between its nodes: within 1e-4 of scale F0 + bias for F0 in [0.04, 1] (src/prepare/dfg_table.h),
// so of E.
constexpr double kTableInterpolation = 1e-4;

// Scale, bias and weight of a fit are sums of terms of up to 8, each rounded a few times: what they cancel to has that
// error, however small it is.
constexpr double kFitRelative = 1e-4;
constexpr double kFitAbsolute = 4e-6;

/// View cosines and roughnesses from 0.05 to 1.
std::vector<ShadingPoint> albedoRows()
{
    std::vector<ShadingPoint> rows;
    constexpr int kSide = 20;
    for (int i = 0; i < kSide * kSide; ++i) {
        const double NoV = 0.05 + 0.95 * (i % kSide) / (kSide - 1.0), r = 0.05 + 0.95 * (i / kSide) / (kSide - 1.0);
        rows.push_back(makeShadingPoint(dvec3(0, 0, 1), directionAt(NoV, 0), directionAt(0.5, 1), r));
    }
    return rows;
}

// 0 * Inf at NoH -> 0, 0/0 where both cosines vanish, the square root of what should be 0, powers that
// underflow.
std::string faultOf(const Method& method, const ShadingPoint& point, const vec3& value)
{
    const float least = std::min({value.x, value.y, value.z}), greatest = std::max({value.x, value.y, value.z});
    const bool needsHorizon =
        method.slot == Slot::visibility || method.slot == Slot::diffuse || method.slot == Slot::sheen;
    constexpr float kReflectance = 1.0f + 1e-6f;
    if (!std::isfinite(value.x) || !std::isfinite(value.y) || !std::isfinite(value.z))
        return "not finite";
    if (least < 0)
        return "negative";
    if (needsHorizon && (point.NoV <= 0 || point.NoL <= 0) && value != vec3(0))
        return "not 0 below the horizon";
    if (method.slot == Slot::fresnel && greatest > kReflectance)
        return "reflects more than it receives";
    return {};
}

} // namespace

std::vector<const Method*> probedMethods()
{
    std::vector<const Method*> methods;
    for (const Method& method : allMethods())
        if (hasShadingFunction(method.slot) && method.slot != Slot::model)
            methods.push_back(&method);
    return methods;
}

ProbeCheck methodCheck(const Method& method)
{
    ProbeCheck check{makeProbeTerm(method), probeGrid(),
                     [&method](const ShadingPoint& p) { return allowedFor(method, p); },
                     [&method](const ShadingPoint& p) { return termsOf(method, p); }};
    for (ShadingPoint& row : check.rows)
        row = scalarsRounded(row);
    return check;
}

ProbeCheck brdfCheck(const Preset& preset)
{
    const ProbeTerm term = makeBrdfTerm(preset);
    return {term, rowsFor(term), [term](const ShadingPoint& p) { return allowedForVectors(term, p); }};
}

ProbeCheck albedoCheck()
{
    return {makeAlbedoTerm(), albedoRows(), [](const ShadingPoint&) { return kTableInterpolation; }};
}

std::vector<const Method*> dfgFits()
{
    std::vector<const Method*> fits;
    for (const Method& method : allMethods())
        if (method.slot == Slot::dfg && !findDfgTable(method.id))
            fits.push_back(&method);
    return fits;
}

ProbeCheck dfgFitCheck(const Method& fit)
{
    ProbeCheck check{makeProbeTerm(fit), albedoRows(), {}};
    for (ShadingPoint& row : check.rows)
        row = scalarsRounded(row);
    check.allowed = [formula = check.term.formula](const ShadingPoint& p) {
        const dvec3 exact = glm::abs(formula(p));
        return kFitRelative + kFitAbsolute / std::max(std::min({exact.x, exact.y, exact.z}), kFitAbsolute);
    };
    return check;
}
ProbeWorst worstOf(const gpu::Device& device, gpu::ShaderLibrary& shaders, const ProbeCheck& check)
{
    const std::vector<vec3> drawn = probe(device, shaders, check.term, check.rows);
    std::vector<ProbeWorst> judged(check.rows.size());
    constexpr std::size_t kGrain = 16;
    parallelFor(judged.size(), kGrain, [&](std::size_t i) {
        const dvec3 exact = check.term.formula(check.rows[i]);
        const double error = relativeError(drawn[i], exact, check.terms ? check.terms(check.rows[i]) : dvec3(0));
        judged[i] = {error / check.allowed(check.rows[i]), error, i, drawn[i], exact};
    });
    ProbeWorst worst;
    for (const ProbeWorst& row : judged)
        if (!(row.ratio <= worst.ratio)) // a NaN is the worst
            worst = row;
    return worst;
}

std::string cornerFault(const gpu::Device& device, gpu::ShaderLibrary& shaders, const Method& method)
{
    const std::vector<ShadingPoint> rows = probeCorners();
    const std::vector<vec3> values = probe(device, shaders, makeProbeTerm(method), rows);
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (const std::string fault = faultOf(method, rows[i], values[i]); !fault.empty())
            return fault + " at " + describe(rows[i]);
    return {};
}

} // namespace torrance
