// One scene drawn on two paths.
#pragma once

#include "drawing.h"

#include <functional>
#include <string>

namespace torrance::test {

/// What a pixel may differ by beside the relative tolerance.
using Allowance = std::function<dvec3(int x, int y)>;

/// Draws on settings.path and forward: |drawn - forward| <= relative * |forward| + allowance, and alphas are equal.
/// Something must be lit, for a picture of nothing agrees with itself.
void expectForwardPicture(const Scene& scene, const Camera& camera, Settings settings, const std::string& name,
                          double relative, const Allowance& allowance = {});

/// Four squares side by side, each of a material and a kind of its own, and a blended one before them all.
Scene mixedScene();

/// mixedScene() and lines and points, lit or of their own colour.
Scene sceneOfAllSurfaces();

/// Sees all of sceneOfAllSurfaces().
Camera orthographicCamera();

} // namespace torrance::test
