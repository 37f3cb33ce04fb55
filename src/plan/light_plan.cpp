#include "plan/light_plan.h"

#include "core/error.h"

namespace torrance {
namespace {

// Why a light changes no pixel; null where it may.
const char* whyUnseen(const Light& light, const dvec3& boundsMin, const dvec3& boundsMax)
{
    if (light.intensity == 0.0 || light.color == dvec3(0.0))
        return "it is black";
    if (light.kind != Light::Kind::directional && light.range > 0.0 &&
        glm::distance(light.position, glm::clamp(light.position, boundsMin, boundsMax)) >= light.range)
        return "its range ends before the scene";
    return nullptr;
}

} // namespace

LightPlan planLights(const Scene& scene, const dvec3& boundsMin, const dvec3& boundsMax, Remarks& remarks)
{
    LightPlan plan;
    for (const Light::Kind kind : {Light::Kind::directional, Light::Kind::point, Light::Kind::spot})
        for (std::size_t i = 0; i < scene.lights.size(); ++i) {
            const Light& light = scene.lights[i];
            if (light.kind != kind)
                continue;
            if (const char* reason = whyUnseen(light, boundsMin, boundsMax)) {
                remarks.push_back({"light '" + light.name + "'", "left out", reason});
                continue;
            }
            plan.lights.push_back(light);
            ++plan.counts[static_cast<std::size_t>(kind)];
        }
    if (plan.lights.size() > kMostLights)
        throw Error(ExitCode::input, "the scene has " + std::to_string(plan.lights.size()) +
                                         " lights that reach it, and at most " + std::to_string(kMostLights) +
                                         " can be drawn; leave some out, or give them ranges that end before it");
    return plan;
}

} // namespace torrance
