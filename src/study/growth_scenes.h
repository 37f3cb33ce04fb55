// Scenes of any size, made in memory: more triangles, lights, texels, pixels or instances of otherwise one picture.
#pragma once

#include "plan/settings.h"
#include "scene/scene.h"

#include <span>
#include <string_view>
#include <vector>

namespace torrance {

struct GrowthSeries
{
    std::string_view id;   // "triangles"
    std::string_view unit; // "triangle": what sizes count
    std::vector<double> sizes;
    Scene (*makeScene)(double size); // without environment
    /// The picture of this size; null: as it is.
    void (*setPicture)(double size, Settings& settings) = nullptr;
};

/// triangles: a dome of 2 n^2 triangles; lights: 1 to 256 points about a sphere; texels: a square of one base
/// colour; pixels: a sphere in pictures of up to 8192x8192; instances: up to 100 000 cubes of one
/// mesh. The greatest sizes are beyond what a processor's caches hold: the step into memory is none of the cost's
/// growth. What is larger is not seen larger: the same part of the picture is covered at every size.
std::span<const GrowthSeries> growthSeries();

/// From the right and a little from above, fitted.
Camera growthCamera(const Scene& scene);

} // namespace torrance
