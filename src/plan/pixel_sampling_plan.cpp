#include "plan/pixel_sampling_plan.h"

#include "brdf/pixel_sampling.h"
#include "core/error.h"

#include <algorithm>

namespace torrance {

bool shadesOncePerPixel(const Settings& settings)
{
    return settings.methods.pixelSampling && settings.methods.pixelSampling->id == "reconstructed";
}

int pictureCount(const Settings& settings)
{
    return shadesOncePerPixel(settings) ? 1 : settings.samples;
}

void checkPixelSampling(const ShadingPlan& plan)
{
    if (!shadesOncePerPixel(plan.settings))
        return;
    constexpr int kSamples = static_cast<int>(brdf::kSamplePlaces.size());
    if (plan.settings.samples != kSamples)
        throw usageError("the pixel sampling reconstructed has 4 samples, not " + std::to_string(plan.settings.samples),
                         "use --samples 4, or --pixel-sampling supersampled");
    const auto isShape = [](const Batch& batch) { return batch.draws.front().shape >= 0; };
    if (std::ranges::any_of(plan.batches, isShape))
        throw usageError("the pixel sampling reconstructed knows no depth of analytic shapes",
                         "use --pixel-sampling supersampled");
}

} // namespace torrance
