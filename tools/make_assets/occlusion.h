// How much of the studio's light reaches each point of the demo scene past the things beside it.
#pragma once

#include "image/image.h"
#include "make_assets/chart_atlas.h"
#include "make_assets/demo_scene.h"
#include "make_assets/picture.h"

namespace torrance::assets {

/// One grey picture for the whole scene: visible over total cosine-weighted light of `panorama`, by rays. The renderer
/// draws no shadows; as glTF's occlusion this puts the objects on the ground that they stand on.
Image bakeOcclusion(const DemoScene& scene, const std::vector<std::vector<Chart>>& charts, const Image& panorama);

} // namespace torrance::assets
