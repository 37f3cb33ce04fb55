#include "study/domain_check.h"

#include "passes/probe_term.h"
#include "study/method_energy.h"
#include "study/method_verdict.h"

#include <algorithm>
#include <fmt/format.h>

namespace torrance {
namespace {

using brdf::Domain;
using brdf::Method;
using brdf::Slot;
using gpu::Precision;

constexpr int kSweepSize = 16;
constexpr int kOutsideSize = 48; // breaks may be in pockets
constexpr int kPhysicsSize = 7;

// Places on an axis within a bound and, on demand, the bound itself.
std::vector<double> kept(std::vector<double> places, double least, double greatest)
{
    std::erase_if(places, [&](double place) { return place < least || place > greatest; });
    places.insert(places.begin(), std::max(least, places.empty() ? least : std::min(least, places.front())));
    if (places.back() < greatest)
        places.push_back(greatest);
    places.erase(std::ranges::unique(places).begin(), places.end());
    return places;
}

bool isFresnel(const Method& method)
{
    return method.slot == Slot::fresnel;
}

SweepAxes insideAxes(const Method& method, int size)
{
    const Domain& domain = method.domain;
    SweepAxes axes = sweepAxes(method.slot, size);
    axes.cosines = kept(axes.cosines, std::max(domain.leastCosine, axes.cosines.front()), 1.0);
    axes.leastLight = domain.leastCosine;
    axes.rows = isFresnel(method) ? kept(axes.rows, std::max(domain.leastIor, axes.rows.front()), axes.rows.back())
                                  : kept(axes.rows, domain.leastRoughness, domain.greatestRoughness);
    return axes;
}

bool standsFor(const Method& method, std::string_view id)
{
    return method.id == id ||
           std::ranges::any_of(approximatedMethods(method), [&](const Method* other) { return standsFor(*other, id); });
}

// Somewhere away from grazing, where every Fresnel term rises.
bool missesTotalReflection(const Method& method, double ior)
{
    const Method& exact = *brdf::findMethod(Slot::fresnel, "exact_dielectric");
    const ProbeTerm term = makeProbeTerm(method), truth = makeProbeTerm(exact);
    for (const double VoH : {0.1, 0.15, 0.2, 0.3, 0.5})
        for (const brdf::ShadingPoint& point : sweepPoints(Slot::fresnel, VoH, ior, Precision::fp64))
            if (point.k == dvec3(0) && truth.formula(point).x == 1 && term.formula(point).x < 0.9)
                return true;
    return false;
}

// What breaks on the cells of a map, a line each.
std::vector<std::string> breaks(const gpu::Device& device, gpu::ShaderLibrary& shaders, const Method& method,
                                const SweepAxes& axes)
{
    std::vector<std::string> lines;
    const AxisNames names = axisNames(method.slot);
    const PrecisionSweep sweep = sweepMethod(device, shaders, method, axes, Precision::fp32);
    for (std::size_t i = 0; i < sweep.cells.size(); ++i) {
        const CellError& cell = sweep.cells[i];
        if (cell.nonFinite > 0 || cell.negative > 0 || !(cell.excess <= 1))
            lines.push_back(fmt::format(
                "{} = {:.4g}, {} = {:.6g}: {} not finite, {} negative, error {:.3g} is {:.3g} times "
                "what is allowed (NoL = {:.4g}, sin NoH = {:.3g})",
                names.cosine, axes.cosines[i % axes.cosines.size()], names.row, axes.rows[i / axes.cosines.size()],
                cell.nonFinite, cell.negative, cell.error, cell.excess, cell.at.NoL, std::sqrt(cell.at.sin2H)));
    }
    if (isFresnel(method) && standsFor(method, "exact_dielectric"))
        for (const double ior : axes.rows)
            if (missesTotalReflection(method, ior))
                lines.push_back(fmt::format("ior = {:.6g}: total reflection is missed", ior));
    return lines;
}

// The worst of energy and reciprocity in the domain.
struct Physics
{
    double energy = 0.0;
    double reciprocity = 0.0;
    bool hasReciprocity = false;
};

Physics physicsOf(const Method& method)
{
    Physics physics;
    if (isFresnel(method))
        return physics;
    const SweepAxes axes = insideAxes(method, kPhysicsSize);
    for (const double NoV : axes.cosines)
        for (const double r : axes.rows) {
            physics.energy = std::max(physics.energy, returnedEnergy(method, NoV, r).value_or(0.0));
            const std::optional<double> reversal = reciprocityError(method, NoV, r);
            physics.hasReciprocity = reversal.has_value();
            physics.reciprocity = std::max(physics.reciprocity, reversal.value_or(0.0));
        }
    return physics;
}

void checkClaims(std::vector<std::string>& lines, const Method& method)
{
    const Physics physics = physicsOf(method);
    if (const bool gains = physics.energy > 1 + kEnergySlack; gains != method.gainsEnergy)
        lines.push_back(
            fmt::format("gainsEnergy is {}, and {:.6g} comes back of 1", method.gainsEnergy, physics.energy));
    const bool reciprocal = physics.reciprocity <= kReciprocityRounding;
    if (physics.hasReciprocity && reciprocal != method.reciprocal)
        lines.push_back(fmt::format("reciprocal is {}, and f(v, l) and f(l, v) differ by {:.3g}", method.reciprocal,
                                    physics.reciprocity));
}

// One bound of the domain, and the axes just outside of it.
struct Bound
{
    std::string_view name;
    double value;
    SweepAxes outside;
};

std::vector<Bound> boundsOf(const Method& method)
{
    const Domain& domain = method.domain;
    const SweepAxes inside = insideAxes(method, kOutsideSize);
    const auto with = [&](auto member, std::vector<double> places) {
        SweepAxes axes = inside;
        axes.*member = std::move(places);
        return axes;
    };
    const auto below = [](double bound) { return std::vector{0.9 * bound, 0.95 * bound, 0.97 * bound, 0.99 * bound}; };
    std::vector<Bound> bounds;
    if (domain.leastRoughness > 0)
        bounds.push_back(
            {"leastRoughness", domain.leastRoughness, with(&SweepAxes::rows, below(domain.leastRoughness))});
    if (domain.greatestRoughness < 1)
        bounds.push_back({"greatestRoughness", domain.greatestRoughness,
                          with(&SweepAxes::rows, {1.01 * domain.greatestRoughness, 1.1 * domain.greatestRoughness})});
    if (domain.leastIor > 0)
        bounds.push_back({"leastIor", domain.leastIor, with(&SweepAxes::rows, below(domain.leastIor))});
    if (domain.leastCosine > 0) {
        bounds.push_back({"leastCosine", domain.leastCosine, with(&SweepAxes::cosines, below(domain.leastCosine))});
        bounds.back().outside.leastLight = 0;
    }
    return bounds;
}

} // namespace

std::vector<std::string> domainContradictions(const gpu::Device& device, gpu::ShaderLibrary& shaders,
                                              const Method& method)
{
    std::vector<std::string> lines = breaks(device, shaders, method, insideAxes(method, kSweepSize));
    checkClaims(lines, method);
    for (const Bound& bound : boundsOf(method))
        if (breaks(device, shaders, method, bound.outside).empty())
            lines.push_back(fmt::format("{} = {}: nothing breaks just outside", bound.name, bound.value));
    return lines;
}

} // namespace torrance
