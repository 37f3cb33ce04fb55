#include "study/method_sweep.h"

#include "brdf/brdf.h"
#include "brdf/condition.h"
#include "brdf/dfg.h"
#include "core/parallel.h"
#include "passes/precision_probe.h"
#include "passes/probe_pass.h"
#include "study/rounded_point.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace torrance {
namespace {

using brdf::ShadingPoint;
using gpu::Precision;

constexpr double kTolerance = 1e-4;
constexpr int kUnits[] = {0, 1, -1}; // in the last place
constexpr std::size_t kVariants = std::size(kUnits);

using Evaluate = std::function<std::vector<dvec3>(std::span<const ShadingPoint>)>;

// A device may flush to zero what lies below the least normal number: that much is forgiven.
double relativeError(double device, double exact, Precision precision)
{
    if (!std::isfinite(device))
        return INFINITY;
    const double least = leastNormal(precision);
    return std::max(0.0, std::abs(device - exact) - least) / std::max(std::abs(exact), least);
}

double relativeError(const dvec3& device, const dvec3& exact, Precision precision)
{
    double worst = 0;
    for (int channel = 0; channel < 3; ++channel)
        worst = std::max(worst, relativeError(device[channel], exact[channel], precision));
    return worst;
}

bool isFinite(const dvec3& value)
{
    return std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z);
}

void note(CellError& cell, const ShadingPoint& point, const dvec3& device, const dvec3& exact, double error)
{
    cell.nonFinite += isFinite(device) ? 0 : 1;
    cell.negative += device.x < 0 || device.y < 0 || device.z < 0 ? 1 : 0;
    if (!(error <= cell.error)) {
        cell.error = error;
        cell.at = point;
        cell.device = device;
        cell.exact = exact;
    }
}

// The condition number takes twenty evaluations: it is asked for only where it could excuse something.
double excessOf(double error, const brdf::Method& method, const ShadingPoint& point, Precision precision)
{
    if (!std::isfinite(error))
        return INFINITY;
    return error <= kTolerance ? error / kTolerance : error / allowedError(method, point, precision);
}

CellError judged(const brdf::Method& method, const ProbeTerm& term, std::span<const ShadingPoint> points,
                 std::span<const dvec3> values, Precision precision)
{
    CellError cell;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const dvec3 exact = valueAsRead(method.slot, term.formula(points[i]));
        double worst = 0;
        for (std::size_t variant = 0; variant < kVariants; ++variant) {
            const dvec3 device = valueAsRead(method.slot, values[kVariants * i + variant]);
            const double error = relativeError(device, exact, precision);
            note(cell, points[i], device, exact, error);
            worst = std::max(worst, error);
        }
        cell.excess = std::max(cell.excess, excessOf(worst, method, points[i], precision));
    }
    return cell;
}

// Rows [first, last) of the map at once: few draws, and no more memory than a draw takes.
void sweepRows(PrecisionSweep& sweep, const brdf::Method& method, const ProbeTerm& term, const SweepAxes& axes,
               const Evaluate& evaluate, std::size_t first, std::size_t last)
{
    const std::size_t columns = axes.cosines.size(), count = (last - first) * columns;
    std::vector<std::vector<ShadingPoint>> points(count);
    constexpr std::size_t kGrain = 8;
    parallelFor(count, kGrain, [&](std::size_t i) {
        points[i] =
            sweepPoints(method.slot, axes.cosines[i % columns], axes.rows[first + i / columns], sweep.precision);
        std::erase_if(points[i], [&](const ShadingPoint& point) { return point.NoL < axes.leastLight; });
    });
    std::vector<ShadingPoint> given;
    std::vector<std::size_t> starts;
    for (const auto& cell : points) {
        starts.push_back(given.size());
        for (const ShadingPoint& point : cell)
            for (const int units : kUnits)
                given.push_back(geometryRounded(point, sweep.precision, units));
    }
    const std::vector<dvec3> values = evaluate(given);
    parallelFor(count, kGrain, [&](std::size_t i) {
        sweep.cells[first * columns + i] =
            judged(method, term, points[i], std::span(values).subspan(starts[i], kVariants * points[i].size()),
                   sweep.precision);
    });
}

// Terms that look up a table are drawn in 32 bits by the pass that binds it.
std::vector<dvec3> probeTable(const gpu::Device& device, gpu::ShaderLibrary& shaders, const ProbeTerm& term,
                              std::span<const ShadingPoint> points)
{
    const std::vector<vec3> values = probe(device, shaders, term, points);
    return {values.begin(), values.end()};
}

} // namespace

bool isCoarserTable(const brdf::Method& method)
{
    const brdf::DfgStorage* storage = brdf::findDfgTable(method.id);
    return method.slot == brdf::Slot::dfg && storage != nullptr && storage != &brdf::allDfgTables().front();
}

bool canSweep(const brdf::Method& method)
{
    return brdf::hasShadingFunction(method.slot) || std::holds_alternative<brdf::DfgFormula>(method.formula);
}

PrecisionSweep sweepMethod(const gpu::Device& device, gpu::ShaderLibrary& shaders, const brdf::Method& method,
                           const SweepAxes& axes, Precision precision)
{
    const ProbeTerm term = makeProbeTerm(method);
    PrecisionSweep sweep = {.precision = precision, .refusal = {}, .cells = {}};
    Evaluate evaluate = [&](std::span<const ShadingPoint> points) { return probeTable(device, shaders, term, points); };
    std::variant<PrecisionProbe, std::string> made;
    if (!term.readsTable || precision != Precision::fp32) {
        made = makePrecisionProbe(device, shaders, term, precision);
        if (const auto* reason = std::get_if<std::string>(&made)) {
            sweep.refusal = *reason;
            return sweep;
        }
        evaluate = [&](std::span<const ShadingPoint> points) {
            return probe(device, std::get<PrecisionProbe>(made), points);
        };
    }
    sweep.cells.resize(axes.cosines.size() * axes.rows.size());
    constexpr std::size_t kRowsAtOnce = 8;
    for (std::size_t first = 0; first < axes.rows.size(); first += kRowsAtOnce)
        sweepRows(sweep, method, term, axes, evaluate, first, std::min(first + kRowsAtOnce, axes.rows.size()));
    return sweep;
}

dvec3 valueAsRead(brdf::Slot slot, const dvec3& value)
{
    if (slot != brdf::Slot::dfg)
        return value;
    return {brdf::kDielectricF0 * value.x + value.y, value.x + value.y, 1 - value.z};
}

double allowedError(const brdf::Method& method, const ShadingPoint& point, Precision precision)
{
    if (isCoarserTable(method))
        return INFINITY;
    const double kappa = brdf::conditionNumber(makeProbeTerm(method).formula, point);
    return kTolerance + 2 * kappa * unitRoundoff(precision);
}

} // namespace torrance
