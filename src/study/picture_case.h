// A picture that can be drawn and computed, and what a drawing of it is worth.
#pragma once

#include "image/image.h"
#include "plan/settings.h"
#include "scene/scene.h"
#include "study/worst_pixel.h"

#include <functional>
#include <string>
#include <string_view>

namespace torrance {

struct PictureJudgement
{
    WorstExcess worst;
    std::string fault; // what is wrong beside that, as a sentence: coverage; empty: nothing
    Image exact;       // RGBA, scene-linear
    Image excess;      // one channel: error over what is allowed, 0 where nothing is compared

    bool passed() const { return fault.empty() && worst.excess <= 1.0; }
};

struct PictureCase
{
    std::string name;
    Scene scene;
    Camera camera;
    Settings settings;
    std::function<PictureJudgement(const PictureCase&, const Image& drawn)> judge;
};

/// Preset, size x size, one sample, transparent background.
Settings squareSettings(const brdf::Preset& preset, int size);

/// The methods that the plan computes a material with: the preset's, less the compensation it left out.
brdf::Preset plannedMethods(const Scene& scene, const Settings& settings, int material);

} // namespace torrance
