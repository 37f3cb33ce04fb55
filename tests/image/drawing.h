// Pictures drawn in this process, on the device that all tests share, and how they are judged.
#pragma once

#include "passes/renderer.h"
#include "plan/shading_plan.h"
#include "scene/scene.h"

#include <string>
#include <string_view>

namespace torrance::test {

/// Preset by id, size x size, one sample, transparent background.
Settings settingsOf(std::string_view preset, int size);

/// Plans, uploads and draws.
Picture draw(const Scene& scene, const Camera& camera, const Settings& settings);

/// The methods that the plan computes a material with: the preset's, less the compensation it left out.
brdf::Preset plannedMethods(const Scene& scene, const Settings& settings, int material);

/// A pixel of the colour picture, premultiplied.
dvec4 pixelOf(const Picture& picture, int x, int y);

/// The worst pixel of a picture against what it should be, with what is needed to look into it.
struct Worst
{
    double excess = 0.0; // error over what is allowed; at most 1 passes
    int x = 0, y = 0;
    dvec3 drawn = dvec3(0.0), exact = dvec3(0.0), allowed = dvec3(0.0);

    void note(int px, int py, const dvec3& drawnColor, const dvec3& exactColor, const dvec3& allowedError);
    std::string text() const;
};

/// Writes drawn and exact pictures below the build tree; the folder's path, for the message of the failed test.
std::string keepFailure(const std::string& name, const Image& drawn, const Image& exact);

} // namespace torrance::test
