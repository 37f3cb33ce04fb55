// The materials of the demo scene.
#pragma once

#include "make_assets/demo_scene.h"

#include <vector>

namespace torrance::assets {

/// Their numbers in demoMaterials().
enum class Finish
{
    paper,
    terrazzo,
    glaze,
    walnut,
    gold,
    hammeredCopper,
    brushedSteel,
    coralPlastic,
    ivoryCeramic,
    chrome,
    clockFace,
    brassScreen,
    brass,
    lamp,
    leaf,
    bark,
    amberGlass,
};

std::vector<DemoMaterial> demoMaterials();

} // namespace torrance::assets
