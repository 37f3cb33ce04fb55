// Pictures drawn in this process, on the device that all tests share, and how they are judged.
#pragma once

#include "passes/renderer.h"
#include "plan/shading_plan.h"
#include "scene/scene.h"
#include "study/picture_case.h"

#include <string>
#include <string_view>
#include <vector>

namespace torrance::test {

/// Preset by id, size x size, one sample, transparent background.
Settings settingsOf(std::string_view preset, int size);

/// Plans, uploads and draws.
Picture draw(const Scene& scene, const Camera& camera, const Settings& settings);

/// The same, uploaded for this camera alone.
Picture drawForOneCamera(const Scene& scene, const Camera& camera, const Settings& settings);

/// A pixel of the colour picture, premultiplied.
dvec4 pixelOf(const Picture& picture, int x, int y);

/// Writes drawn and exact pictures below the build tree; the folder's path, for the message of the failed test.
std::string keepFailure(const std::string& name, const Image& drawn, const Image& exact);

/// Draws the cases, and expects each to pass its own judgement.
void expectDrawnAsComputed(const std::vector<PictureCase>& cases);

} // namespace torrance::test
