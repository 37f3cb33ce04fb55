// What the methods of a slot are measured on and against: a pure function of the registry.
#pragma once

#include "brdf/method.h"

#include <string>
#include <vector>

namespace torrance {

/// The light, and what else, that a slot's methods are told apart by.
enum class TrialScene
{
    lamps,       // directional lights: every term of the BRDF is one evaluation
    environment, // the light from all around that was chosen
    uniform,     // the same radiance from everywhere: what tables of albedos are for
    areaLights,  // lights with a radius
    bumps,       // lamps on surfaces finer than pixels
    picture,     // what is drawn stays the same, and curves show it
    none,        // nothing is drawn with the slot
};
TrialScene trialScene(brdf::Slot slot);

/// How what a method stands in for is computed.
enum class TruthKind
{
    formula,      // another method of the slot, or itself, in double
    fresnel,      // the exact Fresnel terms
    walks,        // random walks between facets
    integral,     // of BRDF and light
    albedo,       // the closed form of uniform light
    supersampled, // many samples a pixel
    none,         // MethodTruth::text says why there is none
};

struct MethodTruth
{
    TruthKind kind = TruthKind::none;
    const brdf::Method* method = nullptr; // of TruthKind::formula
    std::string text;                     // the same for methods that can stand in for each other
};

/// What a method is held against: where its row names a method that it approximates, the one at the end of that chain.
MethodTruth truthOf(const brdf::Method& method);

/// Why no picture can be drawn with a method beside the other slots of `standard`; empty where one can.
std::string whyNotDrawn(const brdf::Method& method);

/// Why a method is not measured on the spheres that slots are judged by; empty where it is.
std::string whyNotOnSpheres(const brdf::Method& method);

/// The preset `standard` with a method in its slot; of the slots distribution and visibility `gltf`, for compensation
/// is made for one method of each; of the slot model the source's whole preset. Of tone and transfer, which are no part
/// of shading, `standard` as it is. The method can be drawn.
brdf::Preset presetWith(const brdf::Method& method);

/// The slot's method in `standard`, whose cost others are compared with. Null where nothing is drawn with the slot.
const brdf::Method* referenceMethod(brdf::Slot slot);

std::vector<const brdf::Method*> methodsOf(brdf::Slot slot);

} // namespace torrance
