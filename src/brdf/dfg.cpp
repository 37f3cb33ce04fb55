#include "brdf/dfg.h"

#include "brdf/albedo.h"

namespace torrance::brdf {

dvec3 DFG_table(double NoV, double perceptualRoughness)
{
    const AlbedoTerms terms = ggxAlbedo(NoV, perceptualRoughness);
    return {terms.scale, terms.bias, schlickDiffuseWeight(NoV)};
}

double lobeAlbedo(double NoV, double perceptualRoughness)
{
    thread_local double lastNoV = -1, lastRoughness = -1, E = 1;
    if (NoV != lastNoV || perceptualRoughness != lastRoughness) {
        E = ggxAlbedo(NoV, perceptualRoughness).albedo();
        lastNoV = NoV;
        lastRoughness = perceptualRoughness;
    }
    return E;
}

} // namespace torrance::brdf
