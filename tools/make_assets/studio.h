// A photographer's studio: soft boxes in a dim room.
#pragma once

#include "image/image.h"

namespace torrance::assets {

/// Scaled so that a white diffuse surface that faces up and towards the camera (0, 1, 1) shows a mean radiance of 1.
Image studioPanorama(int width, int height);

} // namespace torrance::assets
