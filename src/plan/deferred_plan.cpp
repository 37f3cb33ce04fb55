#include "plan/deferred_plan.h"

#include "core/error.h"

#include <algorithm>
#include <cassert>
#include <set>

namespace torrance {
namespace {

void checkMethods(const ShadingPlan& plan)
{
    if (plan.settings.view)
        throw usageError("the deferred path draws no view of a term", "use --path forward");
    const brdf::Method* method = plan.settings.methods.specularAntialiasing;
    if (method && method->id != "none")
        throw usageError("the deferred path cannot use the specular antialiasing " + std::string(method->id) +
                             ", which reads how the normal turns along the surface",
                         "use --path forward, or --specular-antialiasing none");
}

void checkMaterials(const ShadingPlan& plan)
{
    for (const PlannedMaterial& planned : plan.materials)
        if (planned.material.ior != Material{}.ior)
            throw usageError("the deferred path has no room for the index of refraction of " + planned.material.name,
                             "use --path forward, or a material of index 1.5");
}

} // namespace

ShaderKey lightingClass(const ShaderKey& key)
{
    const bool lit = !key.unlit && key.normals;
    return {.unlit = !lit, .compensates = lit && key.compensates, .choice = lit ? key.choice : 0};
}

void planDeferred(ShadingPlan& plan)
{
    checkMethods(plan);
    checkMaterials(plan);
    std::set<ShaderKey> classes;
    for (const Batch& batch : plan.batches)
        classes.insert(lightingClass(batch.key));
    plan.lightingClasses.assign(classes.begin(), classes.end());
    if (!plan.blended.empty())
        plan.remarks.push_back(
            {"blended surfaces", "drawn forward over the rest", "a G-buffer holds one surface a pixel"});
}

std::uint32_t lightingClassIndex(const ShadingPlan& plan, const ShaderKey& key)
{
    const auto found = std::ranges::find(plan.lightingClasses, lightingClass(key));
    assert(found != plan.lightingClasses.end());
    return static_cast<std::uint32_t>(found - plan.lightingClasses.begin());
}

} // namespace torrance
