#include "study/tolerance_variant.h"

#include "passes/renderer.h"

#include <fmt/format.h>

namespace torrance {

std::string toleranceName(const Tolerance& tolerance)
{
    return fmt::format("tolerance {:.3g} %", 100.0 * tolerance.mean);
}

PlanVariant toleranceVariant(const TrialDevice& on, const Scene& scene, const Camera& camera, const Settings& asked,
                             const MethodTable& table, const Tolerance& tolerance, const Checkpoint& checkpoint)
{
    const ToleranceTask task = {.scene = scene,
                                .camera = camera,
                                .asked = asked,
                                .table = table,
                                .tolerance = tolerance,
                                .checkpoint = checkpoint};
    Renderer renderer(on.device, on.shaders, on.cacheFolder);
    Image drawn;
    const ToleranceResult result =
        drawWithin(task, [&](const Settings& settings, std::span<const PixelBox> only) -> const Image& {
            const ShadingPlan plan = makePlan(scene, settings);
            const DeviceScene uploaded = renderer.upload(scene, plan);
            drawn = renderer
                        .render(
                            uploaded, camera, [&](int, int) { checkpoint(); }, only)
                        .color;
            return drawn;
        });
    return {toleranceName(tolerance) + (result.holds ? "" : ", out of reach"), kToleranceKind, result.settings, 0};
}

} // namespace torrance
