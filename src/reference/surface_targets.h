// What lies under the pixels' centres: the parameters that shading starts from.
#pragma once

#include "image/image.h"
#include "scene/scene.h"

#include <vector>

namespace torrance {

/// Six pictures of four channels, the targets of the device's layers pass (shaders/passes/surface_layers.frag): place
/// relative to the camera and depth along its axis; normal and perceptual roughness; the triangle's normal and
/// metalness; base colour and occlusion; emission and 1; object + 1 and material + 1. 0 where nothing is. The nearest
/// surface counts, blended ones too.
std::vector<Image> surfaceTargets(const Scene& scene, const Camera& camera, int width, int height);

} // namespace torrance
