// All methods of a slot measured: what each costs, and how far from what it stands for it is on the sphere set.
#pragma once

#include "study/method_cost.h"

#include <string>

namespace torrance {

struct TrialOptions
{
    const Environment& environment;   // of the slots that light from all around tells apart
    BenchBounds bounds;               // of the frames of each method
    std::function<void()> checkpoint; // called now and then, and may throw to end the work
};

struct MethodPictures
{
    Image drawn; // as a screen shows it; empty where nothing is drawn
    Image error; // heat map: black is 1e-6 and less, pale yellow 1 and more
};

struct MeasuredSlot
{
    brdf::Slot slot = brdf::Slot::model;
    std::vector<MethodRow> rows;
    std::vector<MethodPictures> pictures; // of each row
};

/// Errors do not depend on the machine's load or its threads; costs are of this run. Throws Error (deviceFailure), and
/// what the checkpoint throws.
MeasuredSlot measureSlot(const TrialDevice& on, brdf::Slot slot, const TrialOptions& options);

} // namespace torrance
