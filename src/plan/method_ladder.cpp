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
    if (method.slot == Slot::environmentSpecular && brdf::drawsSamples(method) && !brdf::hasLampPoints(method) &&
        scene.lamps)
        return "vndf_lamps draws directions, too, and finds lamps besides";
    if (method.slot == Slot::environmentSpecular && brdf::hasLampPoints(method) && !scene.lamps)
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

/// The same, of its doubt: the greater half of an interval that need not be even.
double costDoubtOf(const MethodRow& row, double reference)
{
    const Measured& ratio = row.cost->ratio;
    return std::max(ratio.high - ratio.median, ratio.median - ratio.low) * reference;
}

const MethodRow* rowOf(const MethodTable& table, const Method& method)
{
    const auto found = std::ranges::find(table.rows, &method, &MethodRow::method);
    return found == table.rows.end() || !found->cost || !found->error ? nullptr : &*found;
}

/// What the samples of a row's method cost: what points cost is what vndf_lamps takes longer than vndf_bounded.
struct SampleCost
{
    double direction = 0.0, point = 0.0; // ns a pixel
    double of(int samples) const { return direction * samples + point * brdf::lampPointCount(samples); }
};

SampleCost sampleCostOf(const MethodTable& table, const MethodRow& row, double reference, double cheapest)
{
    double directions = costOf(row, reference), points = 0.0;
    if (row.method->slot == Slot::environmentSpecular && brdf::hasLampPoints(*row.method))
        if (const MethodRow* without = rowOf(table, *brdf::findMethod(row.method->slot, "vndf_bounded"))) {
            points = std::max(directions - costOf(*without, reference), 0.0);
            directions -= points;
        }
    return {std::max(directions - cheapest, 0.0) / kTableSamples, points / brdf::lampPointCount(kTableSamples)};
}

void addRungs(std::vector<Rung>& rungs, const MethodTable& table, const MethodRow& row, double reference,
              double cheapest, std::span<const SeenSurface> surfaces)
{
    const Method& method = *row.method;
    // The table's environment is not even; where the method is allowed, the scene's is.
    const double error = method.id == "even" ? 0.0 : expectedError(table, row, surfaces);
    if (!hasSamples(method)) {
        rungs.push_back({&method, 0, costOf(row, reference), error, costDoubtOf(row, reference)});
        return;
    }
    const SampleCost cost = sampleCostOf(table, row, reference, cheapest);
    const double doubt = costDoubtOf(row, reference) / costOf(row, reference); // a share, the same of all numbers
    for (const int samples : kLadderSamples) {
        const double total = cheapest + cost.of(samples);
        rungs.push_back({&method, samples, total, error * std::sqrt(double(kTableSamples) / samples), doubt * total});
    }
}

bool readsTable(const Rung& rung)
{
    return rung.method->slot == Slot::dfg && brdf::findDfgTable(rung.method->id);
}

// Beyond doubt: a machine that wanders must not part methods that cost the same. Rungs of one method wander together.
// What a table takes to be there is in no pixel's time: beside one, what does without is dearer beyond doubt or
// cheaper.
bool isCheaper(const Rung& a, const Rung& b)
{
    if (a.method == b.method)
        return a.cost < b.cost;
    if (readsTable(b) && !readsTable(a))
        return a.cost - a.costDoubt < b.cost + b.costDoubt;
    return a.cost + a.costDoubt < b.cost - b.costDoubt;
}

// What something else is nearer than and costs no more, as far as is known, is no choice.
std::vector<Rung> front(std::vector<Rung> rungs)
{
    std::ranges::stable_sort(
        rungs, [](const Rung& a, const Rung& b) { return a.error != b.error ? a.error < b.error : a.cost < b.cost; });
    std::vector<Rung> kept;
    for (const Rung& rung : rungs)
        if (kept.empty() || isCheaper(rung, kept.back()))
            kept.push_back(rung);
    std::ranges::reverse(kept);
    return kept;
}

} // namespace

std::string nameOf(const Rung& rung)
{
    return rung.samples > 0 ? fmt::format("{} with {} samples", rung.method->id, rung.samples)
                            : std::string(rung.method->id);
}

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
        addRungs(rungs, table, *row, reference, cheapest, surfaces);
    if (rungs.empty())
        return std::nullopt;
    ladder.rungs = front(std::move(rungs));
    for (const MethodRow* row : candidates)
        if (std::ranges::find(ladder.rungs, row->method, &Rung::method) == ladder.rungs.end())
            ladder.refused.push_back({row->method, "something nearer costs no more"});
    return ladder;
}

} // namespace torrance
