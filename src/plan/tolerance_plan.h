// Methods chosen so that a picture stays within a tolerance, and chosen again when one did not.
#pragma once

#include "plan/method_ladder.h"
#include "plan/remark.h"
#include "plan/settings.h"
#include "plan/tolerance.h"

namespace torrance {

/// The choice as it stands. Plain data, changed by the functions below.
struct TolerancePlan
{
    Tolerance tolerance;
    std::vector<MethodLadder> ladders; // of the slots that have something to do
};

/// Every slot but the specular one takes the cheapest method whose expected error is at most this share of the
/// tolerance, or the nearest there is; the greater one where the specular slot needs nothing of it.
inline constexpr double kSlotShare = 0.125;
inline constexpr double kSlotShareAlone = 0.5;

/// `fixed` are slots that were asked for by name, and stay. The specular slot of environments begins at its cheapest
/// method: what look-ups of prefiltered light are off by depends on the environment far more than on the surface, and
/// the table is of another environment; a picture tells.
TolerancePlan planTolerance(const MethodTable& table, const Tolerance& tolerance, const brdf::Preset& asked,
                            std::span<const brdf::Slot> fixed, std::span<const SeenSurface> surfaces,
                            const LadderScene& scene);

/// One more slot, whose errors were measured on the picture itself: it begins where those of the table do.
void addLadder(TolerancePlan& plan, MethodLadder ladder, const LadderScene& scene);

/// What is drawn with the choice as it stands.
Settings settingsOf(const TolerancePlan& plan, Settings settings);

/// ns a pixel that the table says of a frame with the choice as it stands, as far as it knows.
double expectedCost(const TolerancePlan& plan);

/// Steps aim at this share of the tolerance: the upper end of a certificate's interval, which must be within, lies
/// about a third above its value.
inline constexpr double kAim = 0.75;

/// After a picture that was off by `measured` (mean), the worst of its pixels by `blamed` (a slot's name, or another
/// text): that slot, or else the one of which the most error is expected, among those that can rise, goes up by at
/// least one step, and on to the first with which no more than kAim of the tolerance is expected. With more samples of
/// the method that was drawn, its expectation is scaled by what was measured over what was expected; another method's
/// is the table's own, for errors of two methods say little of each other. False where all are at their highest.
bool stepUp(TolerancePlan& plan, double measured, std::string_view blamed = {});

/// Every slot at its highest: nothing that there is comes nearer. goNearest() takes them there; false where they were.
bool isNearest(const TolerancePlan& plan);
bool goNearest(TolerancePlan& plan);

/// One line each: choices with their expected share, what they save against the nearest, and what was refused and why.
Remarks remarksOf(const TolerancePlan& plan);

} // namespace torrance
