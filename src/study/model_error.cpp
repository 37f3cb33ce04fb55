#include "study/model_error.h"

#include "core/parallel.h"
#include "passes/probe_term.h"
#include "study/method_sweep.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace torrance {
namespace {

using brdf::Method;
using brdf::ShadingPoint;

constexpr double kFloor = 0.01;

bool isNameCharacter(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// Both kinds of surface are metals to a conductor's formula, and only one of them is a dielectric to the other's.
bool isComparable(const Method& approximated, const ShadingPoint& point)
{
    const bool metal = point.k != dvec3(0);
    return !(approximated.id == "exact_dielectric" && metal) && !(approximated.id == "exact_conductor" && !metal);
}

struct Compared
{
    ShadingPoint at;
    dvec3 value, truth;
};

std::vector<Compared> comparedAt(const Method& method, const Method& approximated, double cosine, double row)
{
    const ProbeTerm term = makeProbeTerm(method), truth = makeProbeTerm(approximated);
    std::vector<Compared> compared;
    for (const ShadingPoint& point : sweepPoints(method.slot, cosine, row, gpu::Precision::fp64))
        if (isComparable(approximated, point))
            compared.push_back(
                {point, valueAsRead(method.slot, term.formula(point)), valueAsRead(method.slot, truth.formula(point))});
    return compared;
}

// Of a Fresnel term, the greatest there is: 1.
double brightest(brdf::Slot slot, const std::vector<Compared>& cell)
{
    double greatest = slot == brdf::Slot::fresnel ? 1.0 : 0.0;
    for (const Compared& point : cell)
        greatest = std::max({greatest, point.truth.x, point.truth.y, point.truth.z});
    return greatest;
}

ModelCell judged(const std::vector<Compared>& cell, double floor)
{
    ModelCell worst;
    for (const Compared& point : cell)
        for (int channel = 0; channel < 3; ++channel) {
            const double difference = std::abs(point.value[channel] - point.truth[channel]);
            const double error = difference > 0 ? difference / (std::abs(point.truth[channel]) + floor) : 0.0;
            if (!(error <= worst.error))
                worst = {error, point.at};
        }
    return worst;
}

} // namespace

std::vector<const Method*> approximatedMethods(const Method& method)
{
    std::vector<const Method*> methods;
    const std::string_view text = method.approximates;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at;
        while (end < text.size() && isNameCharacter(text[end]))
            ++end;
        const Method* named = brdf::findMethod(method.slot, text.substr(at, end - at));
        if (named != nullptr && named != &method && std::ranges::find(methods, named) == methods.end())
            methods.push_back(named);
        at = end + 1;
    }
    return methods;
}

std::vector<ModelCell> modelErrors(const Method& method, const Method& approximated, const SweepAxes& axes)
{
    const std::size_t columns = axes.cosines.size();
    std::vector<ModelCell> cells(columns * axes.rows.size());
    parallelFor(cells.size(), 1, [&](std::size_t i) {
        const auto compared = comparedAt(method, approximated, axes.cosines[i % columns], axes.rows[i / columns]);
        cells[i] = judged(compared, kFloor * brightest(method.slot, compared));
    });
    return cells;
}

} // namespace torrance
