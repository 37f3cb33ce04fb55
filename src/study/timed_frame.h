// What a frame takes, with all the pictures that its samples need.
#pragma once

#include "core/process_usage.h"
#include "passes/renderer.h"

namespace torrance {

/// Draws a picture's samples and leaves them on the device: reading back does not count.
TimeUse timeOfFrame(Renderer& renderer, const DeviceScene& scene, const Camera& camera);

} // namespace torrance
