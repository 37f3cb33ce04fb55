#include "plan/method_ladder.h"

#include "brdf/dfg.h"
#include "brdf/environment.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace torrance {
namespace {

using brdf::Method;
using brdf::Slot;

/// A quarter of the cost of a direction is that of a point of the method vndf_lamps (docs/performance.md).
constexpr double kPointCost = 0.25;

double shareOf(Slot slot, const SeenSurface& surface)
{
    switch (slot) {
    case Slot::environmentDiffuse:
        return surface.body;
    case Slot::environmentSpecular:
        return surface.lobe;
    case Slot::dfg:
        return surface.body + surface.lobe;
    case Slot::areaLight:
        return surface.spheres;
    default:
        return 0.0;
    }
}

std::size_t nearest(const std::vector<double>& values, double value)
{
    const auto distance = [&](double a) { return std::abs(a - value); };
    return static_cast<std::size_t>(std::ranges::min_element(values, {}, distance) - values.begin());
}

// Above the last cosine and below the first, the cell at the end speaks.
std::size_t columnOf(const MethodGrid& grid, double NoV)
{
    const auto edge = std::ranges::upper_bound(grid.cosines, NoV);
    const auto column = std::max<std::ptrdiff_t>(edge - grid.cosines.begin() - 1, 0);
    return std::min(static_cast<std::size_t>(column), grid.columns() - 1);
}

bool hasSamples(const Method& method)
{
    return method.slot == Slot::environmentSpecular ? brdf::drawsSamples(method)
                                                    : method.slot == Slot::areaLight && method.id == "sampled";
}

// Directions, and points as so many of them.
double effortOf(const Method& method, int samples)
{
    return samples + (method.id == "vndf_lamps" ? kPointCost * brdf::lampPointCount(samples) : 0.0);
}

std::string whyRefused(const Method& method, const LadderScene& scene)
{
    if (!method.ownModel.empty())
        return fmt::format("belongs to the model {}", method.ownModel);
    const bool ofEnvironment = method.slot == Slot::environmentDiffuse || method.slot == Slot::environmentSpecular;
    if (method.id == "even" && !scene.even)
        return "outside its domain: the environment is not of one radiance";
    if (ofEnvironment && method.id != "even" && scene.even)
        return "even is exact here, and needs no map";
    // What a table says of directions alone is of its own environment: under lamps that it has not, they fail by far.
    if (method.slot == Slot::environmentSpecular && brdf::drawsSamples(method) && method.id != "vndf_lamps" &&
        scene.lamps)
        return "vndf_lamps draws directions, too, and finds lamps besides";
    if (method.id == "vndf_lamps" && !scene.lamps)
        return "its points have no place behind so many lights";
    // Of light that is looked up, and of what compensation makes of it, the errors of albedos cancel; of directions
    // that are drawn they do not.
    if (method.slot == Slot::dfg && !brdf::findDfgTable(method.id) && !scene.even)
        return "outside its domain: the specular slot may draw directions, whose light compensation would be wrong by "
               "it";
    if (method.id == "sampled" && method.slot == Slot::environmentDiffuse)
        return "irradiance_cube holds the same integral"; // hundreds of times the cost, no error less
    if (method.id == "sh9_windowed")
        return "blurs what sh9 has";
    return "";
}

/// ns a pixel: the paired ratio to the slot's reference method, times its own time, which is the same for all.
double costOf(const MethodRow& row, double reference)
{
    return row.cost->ratio.median * reference;
}

const MethodRow* rowOf(const MethodTable& table, const Method& method)
{
    const auto found = std::ranges::find(table.rows, &method, &MethodRow::method);
    return found == table.rows.end() || !found->cost || !found->error ? nullptr : &*found;
}

void addRungs(std::vector<Rung>& rungs, const MethodTable& table, const MethodRow& row, double reference,
              double cheapest, std::span<const SeenSurface> surfaces, const LadderScene& scene)
{
    const Method& method = *row.method;
    const bool exact = scene.even && (method.slot == Slot::environmentDiffuse || method.id == "even" ||
                                      method.id == "split_sum" || method.id == "split_sum_dominant");
    const double cost = costOf(row, reference);
    const double error = exact ? 0.0 : expectedError(table, row, surfaces);
    if (!hasSamples(method)) {
        rungs.push_back({&method, 0, cost, error});
        return;
    }
    const double unit = std::max(cost - cheapest, 0.0) / effortOf(method, kTableSamples);
    for (const int samples : kLadderSamples)
        rungs.push_back({&method, samples, cheapest + unit * effortOf(method, samples),
                         error * std::sqrt(double(kTableSamples) / samples)});
}

// What something else is both cheaper and nearer than is no choice.
std::vector<Rung> front(std::vector<Rung> rungs)
{
    std::ranges::stable_sort(
        rungs, [](const Rung& a, const Rung& b) { return a.cost != b.cost ? a.cost < b.cost : a.error < b.error; });
    std::vector<Rung> kept;
    for (const Rung& rung : rungs)
        if (kept.empty() || rung.error < kept.back().error)
            kept.push_back(rung);
    return kept;
}

} // namespace

double expectedError(const MethodTable& table, const MethodRow& row, std::span<const SeenSurface> surfaces)
{
    constexpr double kNoiseShare = 0.798 / 2.13;
    double sum = 0.0;
    for (const SeenSurface& surface : surfaces) {
        const std::size_t cell = table.grid.cell(nearest(table.grid.reflectances, surface.f0),
                                                 nearest(table.grid.roughnesses, surface.perceptualRoughness),
                                                 columnOf(table.grid, surface.NoV));
        double error = row.error->cells.empty() ? row.error->mean : row.error->cells[cell];
        if (std::isnan(error)) // its truth is black there
            error = row.error->mean;
        const double noise = kNoiseShare * row.error->noise;
        sum += shareOf(row.method->slot, surface) * std::sqrt(std::max(error * error - noise * noise, 0.0));
    }
    return sum;
}

std::optional<MethodLadder> ladderOf(const MethodTable& table, Slot slot, const Method& asked,
                                     std::span<const SeenSurface> surfaces, const LadderScene& scene)
{
    const bool needed = slot == Slot::areaLight ? scene.spheres : scene.environment;
    const MethodRow* own = rowOf(table, asked);
    if (!needed || !own)
        return std::nullopt;
    MethodLadder ladder;
    ladder.slot = slot;
    std::vector<const MethodRow*> candidates;
    const double reference = own->cost->nanoseconds.median / own->cost->ratio.median;
    double cheapest = costOf(*own, reference);
    for (const Method& method : brdf::allMethods()) {
        const MethodRow* row = method.slot == slot ? rowOf(table, method) : nullptr;
        if (!row || row->truth != own->truth)
            continue;
        if (std::string reason = whyRefused(method, scene); !reason.empty()) {
            ladder.refused.push_back({&method, std::move(reason)});
            continue;
        }
        candidates.push_back(row);
        cheapest = std::min(cheapest, costOf(*row, reference));
    }
    std::vector<Rung> rungs;
    for (const MethodRow* row : candidates)
        addRungs(rungs, table, *row, reference, cheapest, surfaces, scene);
    if (rungs.empty())
        return std::nullopt;
    ladder.rungs = front(std::move(rungs));
    for (const MethodRow* row : candidates)
        if (std::ranges::find(ladder.rungs, row->method, &Rung::method) == ladder.rungs.end())
            ladder.refused.push_back({row->method, "something is both cheaper and nearer"});
    return ladder;
}

} // namespace torrance
