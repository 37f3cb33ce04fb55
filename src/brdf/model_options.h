// What can be chosen within a source's model: readings of it to the letter, and the numbers that its materials have
// beside glTF's.
#pragma once

#include <span>
#include <string_view>
#include <variant>

namespace torrance::brdf {

struct Preset;

struct ModelOptions
{
    // Quirks: what a source says to the letter, where Torrance takes another reading.
    bool doubleFresnel = false;
    bool noCosine = false;
    bool piDenominator = false;
    bool energySketch = false;
    bool fiveLevels = false;
    bool fresnelAtView = false;

    // Parameters.
    double ambient = 0.1;
    double specularFactor = 0.5;
    double reflectivity = 1.0;
    double reflection = 1.0;
    double fresnelExponent = 2.0;
    double refraction = 0.0;
};

/// One choice of one model. A quirk is on or off; a parameter is a number from 0 to `greatest`.
struct ModelOption
{
    std::string_view model; // id of the row
    std::string_view id;    // as on the command line
    std::string_view text;
    std::variant<bool ModelOptions::*, double ModelOptions::*> member;
    double greatest = 1.0;

    bool isQuirk() const { return std::holds_alternative<bool ModelOptions::*>(member); }
};

std::span<const ModelOption> allModelOptions();

/// Null where the preset's model has no such option.
const ModelOption* findModelOption(const Preset& preset, std::string_view id);

} // namespace torrance::brdf
