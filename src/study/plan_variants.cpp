#include "study/plan_variants.h"

#include "core/error.h"
#include "plan/path_plan.h"
#include "study/slot_trial.h"

#include <algorithm>
#include <fmt/format.h>

namespace torrance {
namespace {

using brdf::Slot;

/// The scene has what the slot is about.
bool isOf(Slot slot, const Scene& scene)
{
    switch (slot) {
    case Slot::areaLight:
        return std::ranges::any_of(scene.lights, [](const Light& light) { return light.radius > 0.0; });
    case Slot::textureFilter:
        return !scene.textures.empty();
    case Slot::pixelSampling: // a choice beside a number of samples: addNumbers
    case Slot::model:         // other models are no plans of this one
        return false;
    default:
        return true;
    }
}

void addMethods(std::vector<PlanVariant>& variants, const Scene& scene, const Settings& base)
{
    for (const Slot slot : brdf::allSlots()) {
        if (!base.methods[slot] || !isOf(slot, scene))
            continue;
        for (const brdf::Method* method : methodsOf(slot)) {
            if (method == base.methods[slot] || !whyNotDrawn(*method).empty())
                continue;
            Settings settings = base;
            settings.methods[slot] = method;
            variants.push_back({fmt::format("{}={}", brdf::slotName(slot), method->id),
                                std::string(brdf::slotName(slot)), settings, 0});
        }
    }
}

void addNumbers(std::vector<PlanVariant>& variants, const Scene& scene, const Settings& base)
{
    for (const int directions : {16, 256}) {
        Settings settings = base;
        settings.methods[Slot::environmentSpecular] = brdf::findMethod(Slot::environmentSpecular, "vndf_bounded");
        settings.environmentSamples = directions;
        if (scene.environment)
            variants.push_back(
                {fmt::format("vndf_bounded, {} directions", directions), "environment_samples", settings, 0});
    }
    for (const int samples : {4, 16}) {
        Settings settings = base;
        settings.samples = samples;
        variants.push_back({fmt::format("{} samples", samples), "samples", settings, 0});
    }
    if (scene.shapes.empty()) {
        Settings settings = base;
        settings.samples = 4;
        settings.methods[Slot::pixelSampling] = brdf::findMethod(Slot::pixelSampling, "reconstructed");
        variants.push_back({"4 samples, reconstructed", "samples", settings, 0});
    }
    constexpr int kLeastWidth = 64;
    if (scene.environment)
        for (int width = scene.environment->radiance.width / 2, i = 0; width >= kLeastWidth && i < 3; width /= 2, ++i)
            variants.push_back({fmt::format("environment {} wide", width), "environment_size", base, width});
}

void addPaths(std::vector<PlanVariant>& variants, const Settings& base)
{
    for (const RenderPath path : kRenderPaths) {
        Settings settings = base;
        settings.path = path;
        variants.push_back({fmt::format("path={}", nameOf(path)), "path", settings, 0});
    }
}

bool canBePlanned(const Scene& scene, const PlanVariant& variant)
{
    try {
        makePlan(scene, variant.settings);
        return true;
    } catch (const Error& error) {
        if (error.exitCode != ExitCode::usage)
            throw;
        return false; // methods that no table was made for together
    }
}

} // namespace

std::vector<PlanVariant> planVariants(const Scene& scene, const Settings& base)
{
    std::vector<PlanVariant> all = {{kStandardPlan, "preset", base, 0}};
    Settings gltf = base;
    gltf.methods = *brdf::findPreset("gltf");
    all.push_back({"gltf", "preset", gltf, 0});
    addMethods(all, scene, base);
    addNumbers(all, scene, base);
    addPaths(all, base);
    std::vector<PlanVariant> variants;
    for (PlanVariant& variant : all)
        if (canBePlanned(scene, variant))
            variants.push_back(std::move(variant));
    return variants;
}

} // namespace torrance
