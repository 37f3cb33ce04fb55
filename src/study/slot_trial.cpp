#include "study/slot_trial.h"

#include "study/model_error.h"

#include <algorithm>

namespace torrance {
namespace {

using brdf::Method;
using brdf::Slot;

const brdf::Preset& standard()
{
    return *brdf::findPreset("standard");
}

// Compensation is made for one D and V: beside others there is none.
const brdf::Preset& besides(Slot slot)
{
    return slot == Slot::distribution || slot == Slot::visibility ? *brdf::findPreset("gltf") : standard();
}

// The method at the end of the chain of what stands in for what.
const Method* rootOf(const Method& method)
{
    const Method* root = &method;
    for (;;) {
        const std::vector<const Method*> next = approximatedMethods(*root);
        if (next.empty())
            return root;
        root = next.front();
    }
}

// An exact form, or what others are held against.
bool isYardstick(const Method& method)
{
    const auto standsForIt = [&](const Method& other) {
        const std::vector<const Method*> named = approximatedMethods(other);
        return std::ranges::find(named, &method) != named.end();
    };
    return method.approximates.empty() || std::ranges::any_of(brdf::allMethods(), standsForIt);
}

MethodTruth formulaTruth(const Method& method)
{
    const Method* root = rootOf(method);
    if (root == &method && !isYardstick(method))
        return {TruthKind::none, nullptr, "stands for " + std::string(method.approximates) + ": not computed here"};
    return {TruthKind::formula, root, std::string(root->id)};
}

} // namespace

TrialScene trialScene(Slot slot)
{
    switch (slot) {
    case Slot::model:
    case Slot::distribution:
    case Slot::visibility:
    case Slot::fresnel:
    case Slot::diffuse:
    case Slot::diffuseWeight:
    case Slot::multipleScattering:
        return TrialScene::lamps;
    case Slot::environmentDiffuse:
    case Slot::environmentSpecular:
        return TrialScene::environment;
    case Slot::dfg:
        return TrialScene::uniform;
    case Slot::areaLight:
        return TrialScene::areaLights;
    case Slot::specularAntialiasing:
        return TrialScene::bumps;
    case Slot::tone:
    case Slot::transfer:
        return TrialScene::picture;
    case Slot::textureFilter:
    case Slot::pixelSampling:
    case Slot::sheen:
        break;
    }
    return TrialScene::none;
}

MethodTruth truthOf(const Method& method)
{
    switch (method.slot) {
    case Slot::fresnel:
        return {TruthKind::fresnel, nullptr, "exact Fresnel terms"};
    case Slot::multipleScattering:
        return {TruthKind::walks, nullptr, "random walks between facets"};
    case Slot::environmentDiffuse:
    case Slot::environmentSpecular:
        return {TruthKind::integral, nullptr, "the integral of BRDF and environment"};
    case Slot::areaLight:
        return {TruthKind::integral, nullptr, "the integral of BRDF and lights with a radius"};
    case Slot::dfg:
        return {TruthKind::albedo, nullptr, "the albedo's integral"};
    case Slot::specularAntialiasing:
    case Slot::pixelSampling:
        return {TruthKind::supersampled, nullptr, "256 samples a pixel"};
    default:
        return formulaTruth(method);
    }
}

std::string whyNotDrawn(const Method& method)
{
    if (method.slot == Slot::sheen)
        return "no material is drawn with it yet";
    if (method.needs != brdf::Interface::reflectance)
        return "needs an index of refraction that a base colour does not give: a truth, and not drawn";
    if (!method.ownModel.empty())
        return "belongs to the model " + std::string(method.ownModel) + " alone";
    return "";
}

std::string whyNotOnSpheres(const Method& method)
{
    if (method.slot == Slot::pixelSampling)
        return "is about edges, which are not judged on spheres: torrance chart SCENE draws it";
    if (method.slot == Slot::textureFilter)
        return "is about textures, which the spheres have not: torrance chart SCENE draws it";
    return whyNotDrawn(method);
}

brdf::Preset presetWith(const Method& method)
{
    brdf::Preset preset = besides(method.slot);
    if (method.slot == Slot::model)
        return *std::ranges::find(brdf::allPresets(), &method, &brdf::Preset::model);
    if (method.slot != Slot::tone && method.slot != Slot::transfer)
        preset[method.slot] = &method;
    return preset;
}

const Method* referenceMethod(Slot slot)
{
    if (slot == Slot::tone)
        return brdf::findMethod(slot, standard().tone);
    if (slot == Slot::transfer)
        return brdf::findMethod(slot, standard().transfer);
    return standard()[slot];
}

std::vector<const Method*> methodsOf(Slot slot)
{
    std::vector<const Method*> methods;
    for (const Method& method : brdf::allMethods())
        if (method.slot == slot)
            methods.push_back(&method);
    return methods;
}

} // namespace torrance
