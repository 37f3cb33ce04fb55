// How the integrals over light are computed: of all that a picture is asked for, what may differ from material to
// material.
#pragma once

#include "brdf/method.h"

#include <array>
#include <string>

namespace torrance {

struct Settings;

/// What can be asked for per pixel and picture: seconds for a thumbnail.
inline constexpr int kMostLightDirections = 65536;

/// Slots whose methods stand in for an integral: what a picture's model is stays as it was asked for, and how exactly
/// it is computed is chosen.
inline constexpr std::array kLightSlots = {brdf::Slot::environmentDiffuse, brdf::Slot::environmentSpecular,
                                           brdf::Slot::dfg, brdf::Slot::areaLight};

/// What the numbers of directions are called where they are written: by people, and beside the slots' names.
inline constexpr const char* kEnvironmentSamplesName = "environment-samples";
inline constexpr const char* kLightSamplesName = "light-samples";

struct LightMethods
{
    std::array<const brdf::Method*, kLightSlots.size()> methods = {}; // by kLightSlots; null: the preset defines none
    int environmentSamples = 0;                                       // as Settings has them
    int lightSamples = 0;

    bool operator==(const LightMethods&) const = default;
};

/// Whether the method of environment_specular or of area_light draws as many directions as are asked for.
bool drawsEnvironmentSamples(const LightMethods& own);
bool drawsLightSamples(const LightMethods& own);

/// As --material-methods takes it: "2:environment-diffuse=sh9,environment-specular=vndf_lamps,...".
std::string materialMethodsText(int material, const LightMethods& own);

/// Of all materials that Settings::ofMaterials does not name.
LightMethods lightMethodsOf(const Settings& settings);

/// Of this one.
LightMethods lightMethodsOf(const Settings& settings, int material);

/// The settings of a picture all of whose materials have these.
Settings withLightMethods(Settings settings, const LightMethods& chosen);

} // namespace torrance
