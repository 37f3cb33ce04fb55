// Scenes of many kinds, small enough that the error of every pixel of their pictures can be known.
#pragma once

#include "plan/settings.h"
#include "scene/scene.h"

#include <string>

namespace torrance::test {

inline constexpr int kCertifiedScenes = 20;

struct CertifiedScene
{
    std::string name;
    Scene scene;
    Camera camera;
    Settings settings;
};

/// Number `index` of kCertifiedScenes. Surfaces: one sphere (metal, dielectric), a square seen at a slant, three
/// spheres, a textured torus. Light: a smooth sky, a sky with a small sun, windows in the dark, an even sky with a
/// lamp.
CertifiedScene certifiedScene(int index);

} // namespace torrance::test
