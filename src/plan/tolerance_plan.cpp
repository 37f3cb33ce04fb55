#include "plan/tolerance_plan.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace torrance {
namespace {

using brdf::Slot;

std::size_t firstWithin(const MethodLadder& ladder, double error)
{
    const auto found = std::ranges::find_if(ladder.rungs, [&](const Rung& rung) { return rung.error <= error; });
    return found == ladder.rungs.end() ? ladder.rungs.size() - 1
                                       : static_cast<std::size_t>(found - ladder.rungs.begin());
}

double slotShareOf(const LadderScene& scene)
{
    return scene.even || !scene.environment ? kSlotShareAlone : kSlotShare;
}

// Costs are those of a table, or none was measured.
std::string reasonFor(const Rung& taken, const Rung& highest)
{
    if (std::isnan(taken.cost))
        return fmt::format("{:.2g} % of the light, measured on this picture", 100.0 * taken.error);
    return fmt::format("{:.2g} % expected by the table, and {:.3g} ns a pixel less than {}", 100.0 * taken.error,
                       highest.cost - taken.cost, nameOf(highest));
}

} // namespace

TolerancePlan planTolerance(const MethodTable& table, const Tolerance& tolerance, const brdf::Preset& asked,
                            std::span<const Slot> fixed, std::span<const SeenSurface> surfaces,
                            const LadderScene& scene)
{
    TolerancePlan plan = {tolerance, {}};
    for (const Slot slot : kLightSlots) {
        if (!asked[slot] || std::ranges::find(fixed, slot) != fixed.end())
            continue;
        std::optional<MethodLadder> ladder = ladderOf(table, slot, *asked[slot], surfaces, scene);
        if (!ladder)
            continue;
        if (slot != Slot::environmentSpecular)
            ladder->at = firstWithin(*ladder, slotShareOf(scene) * tolerance.mean);
        plan.ladders.push_back(std::move(*ladder));
    }
    return plan;
}

void addLadder(TolerancePlan& plan, MethodLadder ladder, const LadderScene& scene)
{
    ladder.at = firstWithin(ladder, slotShareOf(scene) * plan.tolerance.mean);
    plan.ladders.push_back(std::move(ladder));
}

Settings settingsOf(const TolerancePlan& plan, Settings settings)
{
    for (const MethodLadder& ladder : plan.ladders) {
        const Rung& rung = ladder.taken();
        settings.methods[ladder.slot] = rung.method;
        if (rung.samples > 0)
            (ladder.slot == Slot::areaLight ? settings.lightSamples : settings.environmentSamples) = rung.samples;
    }
    return settings;
}

double expectedCost(const TolerancePlan& plan)
{
    double cheapest = 0.0, more = 0.0; // rungs have the cost of whole frames
    for (const MethodLadder& ladder : plan.ladders) {
        const double first = ladder.rungs.front().cost;
        if (std::isnan(first))
            continue;
        cheapest = std::max(cheapest, first);
        more += ladder.taken().cost - first;
    }
    return cheapest + more;
}

bool stepUp(TolerancePlan& plan, double measured, std::string_view blamed)
{
    MethodLadder* worst = nullptr;
    double expected = 0.0;
    for (MethodLadder& ladder : plan.ladders) {
        expected += ladder.taken().error;
        if (!ladder.isHighest() && (!worst || ladder.taken().error > worst->taken().error))
            worst = &ladder;
    }
    for (MethodLadder& ladder : plan.ladders)
        if (!ladder.isHighest() && brdf::slotName(ladder.slot) == blamed)
            worst = &ladder;
    if (!worst)
        return false;
    const Rung drawn = worst->taken();
    const double scale = expected > 0.0 ? measured / expected : 1.0;
    const double left = kAim * plan.tolerance.mean - (expected - drawn.error);
    do
        ++worst->at;
    while (!worst->isHighest() && worst->taken().error * (worst->taken().method == drawn.method ? scale : 1.0) > left);
    return true;
}

bool isNearest(const TolerancePlan& plan)
{
    return std::ranges::all_of(plan.ladders, [](const MethodLadder& ladder) { return ladder.isHighest(); });
}

bool goNearest(TolerancePlan& plan)
{
    if (isNearest(plan))
        return false;
    for (MethodLadder& ladder : plan.ladders)
        ladder.at = ladder.rungs.size() - 1;
    return true;
}

Remarks remarksOf(const TolerancePlan& plan)
{
    Remarks remarks;
    for (const MethodLadder& ladder : plan.ladders) {
        const std::string subject = "tolerance, " + std::string(brdf::slotName(ladder.slot));
        remarks.push_back({subject, nameOf(ladder.taken()), reasonFor(ladder.taken(), ladder.rungs.back())});
        for (const RefusedMethod& refused : ladder.refused)
            remarks.push_back({subject, "not " + std::string(refused.method->id), refused.reason});
    }
    return remarks;
}

} // namespace torrance
