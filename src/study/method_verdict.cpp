#include "study/method_verdict.h"

#include "core/parallel.h"
#include "study/method_energy.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>

namespace torrance {
namespace {

using brdf::Method;
using brdf::ShadingPoint;
using brdf::Slot;

Extent extentOf(const SweepAxes& axes, const std::function<bool(std::size_t)>& happens)
{
    Extent extent;
    const std::size_t columns = axes.cosines.size();
    for (std::size_t i = 0; i < columns * axes.rows.size(); ++i) {
        if (!happens(i))
            continue;
        const double row = axes.rows[i / columns], cosine = axes.cosines[i % columns];
        if (extent.cells++ == 0)
            extent = {1, row, row, cosine, cosine};
        extent.greatestRow = std::max(extent.greatestRow, row);
        extent.leastCosine = std::min(extent.leastCosine, cosine);
        extent.greatestCosine = std::max(extent.greatestCosine, cosine);
    }
    return extent;
}

PrecisionVerdict verdictOf(const PrecisionSweep& sweep, const SweepAxes& axes)
{
    PrecisionVerdict verdict;
    verdict.precision = sweep.precision;
    verdict.refusal = sweep.refusal;
    if (!sweep.refusal.empty())
        return verdict;
    for (const CellError& cell : sweep.cells)
        if (std::isfinite(cell.error) && cell.error > verdict.worst.error)
            verdict.worst = cell;
    const auto where = [&](const auto& happens) {
        return extentOf(axes, [&](std::size_t i) { return happens(sweep.cells[i]); });
    };
    verdict.above4 = where([](const CellError& cell) { return !(cell.error <= 1e-4); });
    verdict.above2 = where([](const CellError& cell) { return !(cell.error <= 1e-2); });
    verdict.nonFinite = where([](const CellError& cell) { return cell.nonFinite > 0; });
    verdict.negative = where([](const CellError& cell) { return cell.negative > 0; });
    verdict.unexplained = where([](const CellError& cell) { return !(cell.excess <= 1); });
    return verdict;
}

ModelVerdict modelVerdict(const Method& method, const Method& approximated, const SweepAxes& axes)
{
    ModelVerdict verdict;
    verdict.approximated = &approximated;
    verdict.cells = modelErrors(method, approximated, axes);
    double squares = 0;
    for (const ModelCell& cell : verdict.cells) {
        squares += cell.error * cell.error;
        if (!(cell.error <= verdict.worst.error))
            verdict.worst = cell;
    }
    verdict.rms = std::sqrt(squares / static_cast<double>(verdict.cells.size()));
    verdict.above1 = extentOf(axes, [&](std::size_t i) { return !(verdict.cells[i].error <= 0.1); });
    return verdict;
}

// Per cell, in parallel; 0 where it is not defined.
std::vector<double> overCells(const SweepAxes& axes, const std::function<std::optional<double>(double, double)>& value)
{
    std::vector<double> values(axes.cosines.size() * axes.rows.size());
    parallelFor(values.size(), 1, [&](std::size_t i) {
        values[i] = value(axes.cosines[i % axes.cosines.size()], axes.rows[i / axes.cosines.size()]).value_or(0.0);
    });
    return values;
}

void judgePhysics(MethodVerdict& verdict, int size)
{
    const Method& method = *verdict.method;
    verdict.physicsAxes = sweepAxes(method.slot, size);
    if (method.slot == Slot::fresnel)
        return; // no more than 1 comes back: the error against the formula shows it
    const std::vector<double> energies =
        overCells(verdict.physicsAxes, [&](double NoV, double r) { return returnedEnergy(method, NoV, r); });
    const std::vector<double> reversals =
        overCells(verdict.physicsAxes, [&](double NoV, double r) { return reciprocityError(method, NoV, r); });
    verdict.energy = *std::ranges::max_element(energies);
    verdict.reciprocity = *std::ranges::max_element(reversals);
    verdict.gainsEnergy =
        extentOf(verdict.physicsAxes, [&](std::size_t i) { return !(energies[i] <= 1 + kEnergySlack); });
    verdict.notReciprocal =
        extentOf(verdict.physicsAxes, [&](std::size_t i) { return !(reversals[i] <= kReciprocityRounding); });
}

std::string rangeText(std::string_view name, double least, double greatest, const std::vector<double>& axis)
{
    if (least <= axis.front() && greatest >= axis.back())
        return "";
    if (least <= axis.front())
        return fmt::format("{} <= {:.3g}", name, greatest);
    if (greatest >= axis.back())
        return fmt::format("{} >= {:.3g}", name, least);
    return fmt::format("{} from {:.3g} to {:.3g}", name, least, greatest);
}

std::string extentText(const Extent& extent, const SweepAxes& axes, Slot slot)
{
    const AxisNames names = axisNames(slot);
    const std::string rows = rangeText(names.row, extent.leastRow, extent.greatestRow, axes.rows);
    const std::string cosines = rangeText(names.cosine, extent.leastCosine, extent.greatestCosine, axes.cosines);
    const std::size_t all = axes.rows.size() * axes.cosines.size();
    const std::string ranges = rows + (rows.empty() || cosines.empty() ? "" : ", ") + cosines;
    return fmt::format("{} ({:.3g} % of the map)", ranges.empty() ? "all over the map" : "within " + ranges,
                       100.0 * extent.cells / static_cast<double>(all));
}

std::string placeText(const ShadingPoint& at, Slot slot)
{
    if (slot == Slot::fresnel)
        return fmt::format("VoH = {:.4g}, ior = {:.7g}", at.VoH, at.ior);
    return fmt::format("NoV = {:.4g}, NoL = {:.4g}, sin NoH = {:.3g}, roughness = {:.4g}", at.NoV, at.NoL,
                       std::sqrt(at.sin2H), at.perceptualRoughness);
}

void addPrecisionLines(std::vector<std::string>& lines, const PrecisionVerdict& verdict, const SweepAxes& axes,
                       Slot slot)
{
    const std::string_view name = gpu::precisionName(verdict.precision);
    if (!verdict.refusal.empty()) {
        lines.push_back(fmt::format("{}: not evaluated: {}.", name, verdict.refusal));
        return;
    }
    const auto where = [&](const Extent& extent) { return extentText(extent, axes, slot); };
    std::string line = fmt::format("{}: worst error {:.3g}", name, verdict.worst.error);
    if (verdict.worst.error > 0)
        line += " at " + placeText(verdict.worst.at, slot);
    lines.push_back(line + ".");
    if (verdict.above4.cells > 0)
        lines.push_back(fmt::format("{}: error passes 1e-4 {}.", name, where(verdict.above4)));
    if (verdict.above2.cells > 0)
        lines.push_back(fmt::format("{}: error passes 1e-2 {}.", name, where(verdict.above2)));
    if (verdict.nonFinite.cells > 0)
        lines.push_back(fmt::format("{}: not finite {}.", name, where(verdict.nonFinite)));
    if (verdict.negative.cells > 0)
        lines.push_back(fmt::format("{}: negative {}.", name, where(verdict.negative)));
    if (verdict.precision == gpu::Precision::fp32 && verdict.unexplained.cells > 0)
        lines.push_back(
            fmt::format("{}: more than the rounding of its inputs explains {}.", name, where(verdict.unexplained)));
}

void addModelLines(std::vector<std::string>& lines, const ModelVerdict& model, const SweepAxes& axes, Slot slot)
{
    std::string line = fmt::format("against {}: model error at most {:.3g}, rms {:.3g}", model.approximated->id,
                                   model.worst.error, model.rms);
    if (model.worst.error > 0)
        line += ", worst at " + placeText(model.worst.at, slot);
    lines.push_back(line + ".");
    if (model.above1.cells > 0)
        lines.push_back(fmt::format("against {}: model error passes 0.1 {}.", model.approximated->id,
                                    extentText(model.above1, axes, slot)));
}

void addPhysicsLines(std::vector<std::string>& lines, const MethodVerdict& verdict)
{
    const Slot slot = verdict.method->slot;
    if (verdict.gainsEnergy.cells > 0)
        lines.push_back(fmt::format("gains energy: {:.4f} comes back of 1, {}.", verdict.energy,
                                    extentText(verdict.gainsEnergy, verdict.physicsAxes, slot)));
    else if (verdict.energy > 0)
        lines.push_back(fmt::format("energy: at most {:.4f} comes back of 1.", verdict.energy));
    if (verdict.notReciprocal.cells > 0)
        lines.push_back(fmt::format("not reciprocal: f(v, l) and f(l, v) differ by {:.3g}, {}.", verdict.reciprocity,
                                    extentText(verdict.notReciprocal, verdict.physicsAxes, slot)));
}

// An integral per cell: maps of those are coarser.
constexpr int kMostIntegrals = 24;

} // namespace

MethodVerdict judgeMethod(const gpu::Device& device, gpu::ShaderLibrary& shaders, const Method& method,
                          const AtlasSize& size, std::span<const gpu::Precision> precisions)
{
    MethodVerdict verdict;
    verdict.method = &method;
    const bool integrates = method.slot == Slot::dfg || readsInterface(method.slot);
    verdict.axes = sweepAxes(method.slot, integrates ? std::min(size.map, kMostIntegrals) : size.map);
    for (const gpu::Precision precision : precisions) {
        verdict.sweeps.push_back(sweepMethod(device, shaders, method, verdict.axes, precision));
        verdict.precisions.push_back(verdictOf(verdict.sweeps.back(), verdict.axes));
    }
    for (const Method* approximated : approximatedMethods(method))
        if (!isCoarserTable(method)) // its formula is the finer one's: the sweep in 32 bits is what it costs
            verdict.models.push_back(modelVerdict(method, *approximated, verdict.axes));
    judgePhysics(verdict, size.physics);
    return verdict;
}

std::vector<std::string> verdictLines(const MethodVerdict& verdict)
{
    std::vector<std::string> lines;
    const Slot slot = verdict.method->slot;
    for (const PrecisionVerdict& precision : verdict.precisions)
        addPrecisionLines(lines, precision, verdict.axes, slot);
    for (const ModelVerdict& model : verdict.models)
        addModelLines(lines, model, verdict.axes, slot);
    addPhysicsLines(lines, verdict);
    return lines;
}

} // namespace torrance
