#include "study/picture_case.h"

#include "plan/shading_plan.h"

namespace torrance {

Settings squareSettings(const brdf::Preset& preset, int size)
{
    Settings settings;
    settings.methods = preset;
    settings.width = size;
    settings.height = size;
    settings.background = BackgroundKind::transparent;
    return settings;
}

brdf::Preset plannedMethods(const Scene& scene, const Settings& settings, int material)
{
    brdf::Preset methods = settings.methods;
    const ShadingPlan plan = makePlan(scene, settings);
    if (!plan.materials[static_cast<std::size_t>(material)].compensates)
        methods.multipleScattering = brdf::findMethod(brdf::Slot::multipleScattering, "none");
    return methods;
}

} // namespace torrance
